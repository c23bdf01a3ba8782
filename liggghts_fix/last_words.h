#pragma once
// What LIGGGHTS says before it aborts. An error that one rank alone finds goes to that rank's screen and not to the
// log, and MPI_Abort drops what log and screen still hold in their buffers. So with `-screen none` every rank keeps its
// screen here, and MPI_Abort first writes out what is buffered and adds the lines that say ERROR to the log and to
// stderr.

#include <cstdio>
#include <string>

namespace footfall {

// A screen for this rank, a file without a name that ends with the program; nullptr when there is none to be had. `log`
// is LIGGGHTS' log file.
std::FILE* screen_kept_for_last_words(const std::string& log);
// What that screen says of errors so far, in one line; empty without.
std::string errors_on_screen();

}  // namespace footfall
