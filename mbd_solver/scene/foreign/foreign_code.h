#pragma once
// Programs of the user that a scene runs: FMUs. They run only where the user trusts them.

#include <string>
#include <vector>

#include "mbd_solver/base/fmu_description.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

inline const std::string kBuildFmuHost =
    "start the run by ./footfall, which builds it, or build the target footfall_fmu_host (it needs libzip-dev)";

// By the host of FMUs, which must be there. Throws InputError.
FmuDescription describe_fmu(const std::string& file);

bool runs_foreign_code(const Scene& scene);
// Throws InputError for a scene that runs such a program, unless it is trusted.
void require_trust(const Scene& scene, bool trusted);
// Before a run: every program can be started here, and can tell its state where the scene asks for checkpoints. Throws InputError.
void require_foreign_code(const Scene& scene);
// Names of the signals whose program cannot tell its state: the run has no checkpoints.
std::vector<std::string> foreign_code_without_state(const Scene& scene);

}  // namespace footfall
