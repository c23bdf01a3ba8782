#include "mbd_solver/output/summary.h"

#include <cmath>
#include <cstdio>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"

namespace footfall {

namespace {

// JSON has no word for NaN: the library would write null without complaint.
void demand_finite(const nlohmann::ordered_json& value, const std::string& path) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw NumericalError("summary: \"" + path + "\" is no longer finite");
  if (!value.is_structured()) return;
  for (const auto& [key, inner] : value.items()) demand_finite(inner, path.empty() ? key : path + "." + key);
}

}  // namespace

void write_summary(const std::string& path, const nlohmann::ordered_json& summary) {
  demand_finite(summary, "");
  write_whole_file(path, summary.dump(2) + "\n");
}

void throw_incomplete_summary(const std::string& folder, const std::string& what) {
  throw InputError(folder + "/summary.json: is not the whole summary of a run (" + what +
                   "); was it cut, or written by hand?");
}

nlohmann::ordered_json read_summary(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": cannot be read; expected the summary.json of a run");
  try {
    const nlohmann::ordered_json summary = nlohmann::ordered_json::parse(file);
    if (!summary.is_object()) throw InputError(path + ": is not the summary of a run: it holds no { ... }");
    return summary;
  } catch (const nlohmann::json::exception& e) {
    throw InputError(path + ": is not the summary of a run: " + e.what());
  }
}

}  // namespace footfall
