#pragma once
// Functions of time of a scene as the model takes them.

#include "mbd_solver/model/laws/time_function.h"
#include "mbd_solver/scene/joint_spec.h"

namespace footfall {

TimeFunctionPtr time_function(const TimeFunctionSpec& spec);
// Null where none is given.
TimeFunctionPtr time_function(const std::optional<TimeFunctionSpec>& spec);

}  // namespace footfall
