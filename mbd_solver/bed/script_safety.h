#pragma once
// Scenes come from other people, and their LIGGGHTS scripts with them: a script runs no programs, and writes only into
// the folder of results. The kernel sees to that while LIGGGHTS runs (coupler/base/confinement.h); what follows reports
// it before the start, and decides where a kernel has no Landlock.

#include <map>
#include <set>
#include <string>

namespace footfall {

// Checks the script and all files it includes. It may write to ${out}/... and to files whose names begin with ${bed}.
// Throws InputError with every line that runs a program or writes elsewhere; where the kernel does not confine it, also
// with every line of which that is not certain. given: the variables out, bed and here that the command line gives.
void require_safe_script(const std::string& script, const std::map<std::string, std::string>& variables,
                         const std::set<std::string>& given);

// Every line of which it is not certain, from the text alone, that it runs no program and writes only where it may;
// empty: the whole script is safe, whatever LIGGGHTS makes of it.
std::string uncertain_lines(const std::string& script, const std::map<std::string, std::string>& variables,
                            const std::set<std::string>& given);

}  // namespace footfall
