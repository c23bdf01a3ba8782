#pragma once
// LIGGGHTS scripts come with scenes, and scenes from other people: a script runs no programs, and writes below the
// run's own folder alone.

#include <map>
#include <string>

namespace footfall {

// Looks at the script and at all it includes. It may write to ${out}/... and to files whose names begin with ${bed}.
// Throws InputError with every line that runs a program or writes elsewhere.
void demand_safe_script(const std::string& script, const std::map<std::string, std::string>& variables);

// Set for the programs that we start: liggghts_mbd then refuses `shell`, however the script has put it together.
inline constexpr const char* kNoPrograms = "FOOTFALL_NO_PROGRAMS";

}  // namespace footfall
