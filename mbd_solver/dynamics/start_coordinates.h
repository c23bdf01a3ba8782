#pragma once
// Coordinates of joints that a scene gives values at the start.

#include <vector>

#include "mbd_solver/model/joints/joint_coordinate.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// A coordinate of a joint at the start; the others follow by the smallest motion of the bodies.
struct StartCoordinate {
  int joint = 0;
  Coordinate coordinate = Coordinate::kAngle;
  double value = 0.0;  // [rad or m]
};

// Moves the coordinates to their values in small steps, so that loops stay on their branch. The joints of `state` are
// closed, before and after. Throws InputError where they do not close on the way.
void move_to_start(const Model& model, const std::vector<StartCoordinate>& start, State& state);

}  // namespace footfall
