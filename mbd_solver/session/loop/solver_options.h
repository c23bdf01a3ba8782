#pragma once
// From the table [solver] of a scene to the options of integrators and equations.

#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

Baumgarte baumgarte_of(const SolverSpec& spec);
IntegratorOptions integrator_options(const SolverSpec& spec, bool with_grains);

}  // namespace footfall
