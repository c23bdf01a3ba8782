#pragma once
// What overlaps where a run begins: bodies with each other, with the grains of a settled bed, and with the box of a bed that is not
// made yet; and surfaces that are not where their bodies are.

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

// Of a boundary whose surface comes from a file: it is farther from its body than both are large. Throws InputError for files.
std::vector<std::string> surfaces_away(const Scene& scene);

}  // namespace footfall
