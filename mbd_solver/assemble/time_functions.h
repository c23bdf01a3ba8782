#pragma once
// Functions of time of a scene, for the model.

#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/time_function.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// The two columns of a table.
std::pair<std::vector<double>, std::vector<double>> columns_of(const std::vector<Eigen::Vector2d>& rows);

// The shape of a table in the command of a drive: a position needs a continuous rate.
TableShape command_shape(MotorKind kind);

// shape: of its table; the user of the function decides.
TimeFunctionPtr time_function(const TimeFunctionSpec& spec, TableShape shape);
// Null where none is given.
TimeFunctionPtr time_function(const std::optional<TimeFunctionSpec>& spec, TableShape shape);

struct NamedFunction {
  std::string name;  // "forces.f.force"
  TimeFunctionPtr function;
};
// All that a scene gives, without their signals: prescribed motions, commands of drives, forces and torques.
std::vector<NamedFunction> time_functions(const Scene& scene);

}  // namespace footfall
