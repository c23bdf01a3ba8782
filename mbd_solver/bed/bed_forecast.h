#pragma once
// Whether bodies will leave a bed by numbers sideways, as far as it follows from their motion at the start.

#include <string>
#include <vector>

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// A warning for each body whose middle may pass a side wall of [particles.box] before the end of the scene, with the time.
//   prescribed relative to the ground: its displacement
//   free (nothing joins it to the ground, directly or through other bodies): flight to the surface under gravity, then
//   sliding under gravity along the surface with half of the friction, because a bed on a slope gives way
std::vector<std::string> leaving_bodies(const Scene& scene, const Mechanism& mechanism);

}  // namespace footfall
