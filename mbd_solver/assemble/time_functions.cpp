// Sums of polynomial, sine and table; a signal is added where the function is used.
#include "mbd_solver/assemble/time_functions.h"

namespace footfall {

std::pair<std::vector<double>, std::vector<double>> columns_of(const std::vector<Eigen::Vector2d>& rows) {
  std::pair<std::vector<double>, std::vector<double>> columns;
  for (const Eigen::Vector2d& row : rows) {
    columns.first.push_back(row.x());
    columns.second.push_back(row.y());
  }
  return columns;
}

TableShape command_shape(MotorKind kind) {
  return kind == MotorKind::kPosition ? TableShape::kMonotone : TableShape::kLines;
}

TimeFunctionPtr time_function(const TimeFunctionSpec& spec, TableShape shape) {
  std::vector<TimeFunctionPtr> parts = {
      polynomial(spec.polynomial.empty() ? std::vector<double>{0.0} : spec.polynomial)};
  if (spec.amplitude != 0.0) parts.push_back(sine(spec.amplitude, spec.frequency, spec.phase));
  if (!spec.table.empty()) {
    auto [times, values] = columns_of(spec.table);
    parts.push_back(table(std::move(times), std::move(values), shape));
  }
  return sum(std::move(parts));
}

TimeFunctionPtr time_function(const std::optional<TimeFunctionSpec>& spec, TableShape shape) {
  return spec ? time_function(*spec, shape) : nullptr;
}

std::vector<NamedFunction> time_functions(const Scene& scene) {
  std::vector<NamedFunction> functions;
  const auto add = [&](const std::string& name, const std::optional<TimeFunctionSpec>& spec, TableShape shape) {
    if (spec) functions.push_back({name, time_function(*spec, shape)});
  };
  for (const JointSpec& joint : scene.joints) {
    if (!joint.motion) continue;
    for (const auto* f : {&joint.motion->x, &joint.motion->y, &joint.motion->z, &joint.motion->rotation})
      add("joints." + joint.name + ".motion", *f, TableShape::kSpline);
  }
  for (const DriveSpec& drive : scene.drives)
    add("drives." + drive.name + ".command", drive.command, command_shape(drive.motor.kind));
  for (const ForceSpec& force : scene.forces) {
    add("forces." + force.name + ".force", force.force, TableShape::kLines);
    add("forces." + force.name + ".torque", force.torque, TableShape::kLines);
  }
  return functions;
}

}  // namespace footfall
