#pragma once
// Functions of time of a scene as the model takes them.

#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/time_function.h"
#include "mbd_solver/scene/joint_spec.h"

namespace footfall {

// Of the tables in commands of a drive: a position is led with its rate as well.
TableShape command_shape(MotorKind kind);

// shape: of its table, by what uses the function.
TimeFunctionPtr time_function(const TimeFunctionSpec& spec, TableShape shape);
// Null where none is given.
TimeFunctionPtr time_function(const std::optional<TimeFunctionSpec>& spec, TableShape shape);

}  // namespace footfall
