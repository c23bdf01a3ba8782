#pragma once
// Scenes come from other people, and their LIGGGHTS scripts with them: a script runs no programs, and writes only into
// the folder of results.

#include <map>
#include <string>

namespace footfall {

// Checks the script and all files it includes. It may write to ${out}/... and to files whose names begin with ${bed}.
// Throws InputError with every line that runs a program or writes elsewhere.
void require_safe_script(const std::string& script, const std::map<std::string, std::string>& variables);

}  // namespace footfall
