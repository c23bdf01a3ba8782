#pragma once
// From the kinematics of the mechanism to the message about one body.

#include "coupler/body_motion.h"
#include "mbd_solver/model/body_kinematics.h"

namespace footfall {

// Position, velocity and acceleration as computed. `motion` is sized: for the body's modes, or for none when its
// boundary is rigid. No allocation.
void fill_motion(const BodyKinematics& body, BodyMotion& motion);

}  // namespace footfall
