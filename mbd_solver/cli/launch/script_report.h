#pragma once
// What `footfall check` says of the grains of a LIGGGHTS script, as far as its text and a bed that is made tell it.

#include <string>

#include "mbd_solver/scene/scene.h"

namespace footfall {

// Grains, their radii, the time step as a share of the Rayleigh and the Hertz time of the smallest grain (theory 5) at the
// speed of the impact, substeps per window: two or three lines. What only LIGGGHTS can compute is left out.
std::string script_report(const Scene& scene);

}  // namespace footfall
