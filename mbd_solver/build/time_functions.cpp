#include "mbd_solver/build/time_functions.h"

namespace footfall {

TableShape command_shape(MotorKind kind) {
  return kind == MotorKind::kPosition ? TableShape::kMonotone : TableShape::kLines;
}

TimeFunctionPtr time_function(const TimeFunctionSpec& spec, TableShape shape) {
  std::vector<TimeFunctionPtr> parts = {
      polynomial(spec.polynomial.empty() ? std::vector<double>{0.0} : spec.polynomial)};
  if (spec.amplitude != 0.0) parts.push_back(sine(spec.amplitude, spec.frequency, spec.phase));
  if (!spec.table.empty()) {
    std::vector<double> times, values;
    for (const Eigen::Vector2d& row : spec.table) {
      times.push_back(row.x());
      values.push_back(row.y());
    }
    parts.push_back(table(std::move(times), std::move(values), shape));
  }
  return sum(std::move(parts));
}

TimeFunctionPtr time_function(const std::optional<TimeFunctionSpec>& spec, TableShape shape) {
  return spec ? time_function(*spec, shape) : nullptr;
}

}  // namespace footfall
