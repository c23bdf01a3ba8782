#pragma once
// The mass, or moment of inertia, that a joint coordinate moves: an estimate from above, for the damping of stick in joints.

#include "mbd_solver/assemble/mechanism.h"

namespace footfall {

// In the reference configuration, all other joints locked: the smaller of both sides of the joint [kg or kg m2],
// including the contributions of gears and rotors on the coordinate. In a loop all bodies. > 0.
double moved_mass(const Scene& scene, const Mechanism& mechanism, int joint, Coordinate coordinate);

}  // namespace footfall
