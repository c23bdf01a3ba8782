#include "mbd_solver/output/summary.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "coupler/errors.h"

namespace footfall {
namespace {

void demand_finite(const nlohmann::ordered_json& value, const std::string& key) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) throw NumericalError("summary: " + key + " is not finite");
  if (!value.is_structured()) return;
  for (const auto& [name, inner] : value.items()) demand_finite(inner, key.empty() ? name : key + "." + name);
}

}  // namespace

void write_summary(const std::string& path, const nlohmann::ordered_json& summary) {
  demand_finite(summary, "");
  const std::string partial = path + ".partial";
  {
    std::ofstream file(partial);
    file << summary.dump(2) << "\n";
    if (!file) throw InputError(partial + ": cannot be written: " + std::strerror(errno));
  }
  if (std::rename(partial.c_str(), path.c_str()) != 0) throw InputError(path + ": cannot be written: " + std::strerror(errno));
}

}  // namespace footfall
