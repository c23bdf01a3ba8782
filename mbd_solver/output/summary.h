#pragma once
// summary.json: what a run came to, in one object. Written beside the target and renamed: a reader never sees half of it.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace footfall {

// Throws InputError when the file cannot be written, NumericalError when a number in it is not finite.
void write_summary(const std::string& path, const nlohmann::ordered_json& summary);

}  // namespace footfall
