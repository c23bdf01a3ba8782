#pragma once
// Static equilibrium at the start of a run: [initial] settle = true.
// The mechanism moves under the loads of the start; at every maximum of its kinetic energy its velocities are set to zero
// (kinetic damping, Cundall 1976). With one mode the result is the equilibrium, with several each stop removes most of
// the energy. It has settled when its accelerations at rest are below kAtRest of the initial ones, or of gravity.

#include "mbd_solver/dynamics/assembly.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

struct Settled {
  State state;                // at rest, time 0
  double acceleration = 0.0;  // largest remaining one of all coordinates [m/s2 or rad/s2]
  double moved = 0.0;         // largest displacement of a body's origin [m]
  std::string body;           // with that displacement
  double time = 0.0;          // of motion until settled [s]
};

// Functions of time keep their value at t = 0. Throws InputError when the mechanism does not come to rest, NumericalError
// from the integrator.
Settled settle(const Scene& scene, const AssemblyOptions& assembly, const IntegratorOptions& options);

}  // namespace footfall
