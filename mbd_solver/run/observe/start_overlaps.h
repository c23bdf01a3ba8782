#pragma once
// What overlaps where a run begins: bodies with each other, and with the grains of a settled bed.

#include <string>
#include <vector>

#include "mbd_solver/assemble/grain_dump.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Warnings. The mechanism is assembled as at the start of a run; nothing is reported where it cannot be. grains: of the bed;
// empty: unknown.
std::vector<std::string> overlaps_at_start(const Scene& scene, const Mechanism& mechanism,
                                           const std::vector<GrainPlace>& grains);

}  // namespace footfall
