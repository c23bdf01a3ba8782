#pragma once
// Static equilibrium as the start of a run: [initial] settle = true.
// The mechanism moves under the loads of the start; whenever its kinetic energy is largest, it is stopped there (kinetic
// damping, Cundall 1976). With one mode that is the equilibrium, with several each stop takes most of the energy. It
// has settled when at rest it would hardly accelerate: kAtRest of what it did at first, or of gravity.

#include "mbd_solver/dynamics/assembly.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

struct Settled {
  State state;                // at rest, time 0
  double acceleration = 0.0;  // that is left, the largest of all coordinates [m/s2 or rad/s2]
  double moved = 0.0;         // the farthest way of a body's origin [m]
  std::string body;           // of that body
  double time = 0.0;          // of motion until then [s]
};

// Functions of time count as at t = 0. Throws InputError where nothing holds the mechanism, or it does not come to rest;
// NumericalError from the integrator.
Settled settle(const Scene& scene, const AssemblyOptions& assembly, const IntegratorOptions& options);

}  // namespace footfall
