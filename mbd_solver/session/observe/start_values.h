#pragma once
// Checks of the expressions of signals and events at the start of a run: their names exist, and they have values.

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/dynamics/assembly.h"

namespace footfall {

// How the scene wants its mechanism to be assembled.
AssemblyOptions assembly_options(const Scene& scene, const Model& model);  // both must outlive what it returns

// Throws InputError for a mechanism that cannot be assembled, for pads of a landing that span no area, for an unknown
// name, and for an expression without a value at the start, as far as that is known without a run. is_placed: bodies are
// where the run places them. Moves the sampled signals out of the mechanism.
void require_values_at_start(const Scene& scene, bool is_placed, Mechanism& mechanism);

// A warning for each signal of kind "host": a run from the command line has no program that sets it.
std::vector<std::string> unset_signals(const Scene& scene);

}  // namespace footfall
