#pragma once
// summary.json: the figures of a run, whole or not there (whole_file.h).

#include <nlohmann/json.hpp>
#include <string>

namespace footfall {

// Throws NumericalError, naming the key, when a number is not finite; InputError when the file cannot be written.
void write_summary(const std::string& path, const nlohmann::ordered_json& summary);

[[noreturn]] void throw_incomplete_summary(const std::string& folder, const std::string& what);

// Throws InputError when there is no such file, or it holds something else than an object.
nlohmann::ordered_json read_summary(const std::string& path);

// Does what needs the summary; one that lacks something, or holds something else there, is an InputError that names it.
template <class Action>
auto with_summary_of(const std::string& folder, const Action& action) {
  try {
    return action();
  } catch (const nlohmann::json::exception& error) {
    throw_incomplete_summary(folder, error.what());
  }
}

}  // namespace footfall
