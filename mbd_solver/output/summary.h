#pragma once
// summary.json: the figures of a run, whole or not there (whole_file.h).

#include <nlohmann/json.hpp>
#include <string>

namespace footfall {

// Throws NumericalError, naming the key, when a number is not finite; InputError when the file cannot be written.
void write_summary(const std::string& path, const nlohmann::ordered_json& summary);

// Throws InputError when there is no such file, or it holds something else.
nlohmann::ordered_json read_summary(const std::string& path);

}  // namespace footfall
