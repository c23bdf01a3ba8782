#pragma once
// The expressions of signals and events at the start of a run: what they name is there, and they have values.

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/dynamics/assembly.h"

namespace footfall {

// What a scene says of how its mechanism is assembled.
AssemblyOptions assembly_options(const Scene& scene);

// Throws InputError for a name that nothing has, and for an expression without a value at the start, as far as that is
// known without a run. is_placed: bodies stand where the run places them. Takes the sampled signals.
void demand_values_at_start(const Scene& scene, bool is_placed, Mechanism& mechanism);

}  // namespace footfall
