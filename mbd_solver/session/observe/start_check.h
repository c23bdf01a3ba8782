#pragma once
// What only building the mechanism of a scene finds: meshes, modal bases, controllers, values at the start.

#include <functional>
#include <string>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// judges: also what a run warns of at its start or later. warn: receives each warning, with its code. Grains are those that the
// scene names; with_grains: what else is checked of a mechanism that has been built. Throws InputError, with the file of the scene
// unless it names another place.
void check_by_building(Scene scene, bool judges, const std::function<void(const std::string&)>& warn,
                       const std::function<void(const Scene&, const Mechanism&)>& with_grains = {});

}  // namespace footfall
