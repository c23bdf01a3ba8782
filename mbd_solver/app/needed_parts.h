#pragma once
// footfall needs WORDS...: the optional parts of the program that the line `footfall WORDS...` needs beyond the parts of
// its command. ./footfall asks before it carries out the line, and builds them first. Not in the list of commands.

#include <string>
#include <vector>

namespace footfall {

// Some of these, in this order:
//   campaign  `sweep` or `check` with a file of drawn runs
//   fmi       a scene that is named, or that a named file of a study names, has a signal of kind "fmu"
//   import    `new` from the file of a robot
// Every word that names a file or a folder counts, whatever option it belongs to. Only reads files; a file that cannot be
// read or parsed needs nothing, as the command itself reports it.
std::vector<std::string> needed_parts(const std::vector<std::string>& words);

}  // namespace footfall
