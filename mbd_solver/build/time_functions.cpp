#include "mbd_solver/build/time_functions.h"

namespace footfall {

TimeFunctionPtr time_function(const TimeFunctionSpec& spec) {
  std::vector<TimeFunctionPtr> parts = {
      polynomial(spec.polynomial.empty() ? std::vector<double>{0.0} : spec.polynomial)};
  if (spec.amplitude != 0.0) parts.push_back(sine(spec.amplitude, spec.frequency, spec.phase));
  if (!spec.table.empty()) {
    std::vector<double> times, values;
    for (const Eigen::Vector2d& row : spec.table) {
      times.push_back(row.x());
      values.push_back(row.y());
    }
    parts.push_back(table(std::move(times), std::move(values)));
  }
  return sum(std::move(parts));
}

TimeFunctionPtr time_function(const std::optional<TimeFunctionSpec>& spec) {
  return spec ? time_function(*spec) : nullptr;
}

}  // namespace footfall
