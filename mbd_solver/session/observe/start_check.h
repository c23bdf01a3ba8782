#pragma once
// What only building the mechanism of a scene finds: meshes, modal bases, controllers, values at the start.

#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/assemble/grain_dump.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// What overlaps where a run begins: bodies with each other, with the grains of a settled bed, and with the box of a bed that is not
// made yet; and surfaces that are not where their bodies are.

// Warnings. The mechanism is assembled as at the start of a run; nothing is reported where it cannot be. grains: of the bed;
// empty: unknown.
std::vector<std::string> overlaps_at_start(const Scene& scene, const Mechanism& mechanism,
                                           const std::vector<GrainPlace>& grains);

// Of a boundary whose surface comes from a file: it is farther from its body than both are large. Throws InputError for files.
std::vector<std::string> surfaces_away(const Scene& scene);

// judges: also what a run warns of at its start or later. warn: receives each warning, with its code. Grains are those that the
// scene names; with_grains: what else is checked of a mechanism that has been built. Throws InputError, with the file of the scene
// unless it names another place.
void check_by_building(Scene scene, bool judges, const std::function<void(const std::string&)>& warn,
                       const std::function<void(const Scene&, const Mechanism&)>& with_grains = {});

}  // namespace footfall
