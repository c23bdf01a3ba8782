#pragma once
// What a run was computed with and on, for its summary.

#include <nlohmann/json.hpp>
#include <string>

namespace footfall {

// "GCC 12.2.0", of the compiler of this program.
std::string compiler_version();
// processor, cores, system; what the machine does not tell is left out. No name of the machine or of its user.
nlohmann::ordered_json machine();

}  // namespace footfall
