#pragma once
// What [particles.box] of a scene stands for, told by `footfall check`, and kept beside the results of a run.

#include <string>

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Size, floor and surface of the bed, its grains, time step, and where it is kept; of a bed that is made, what is in it.
// A few lines. For a scene that touches the grains of a box.
std::string box_report(const Scene& scene);

// Throws InputError when a body that grains touch stands outside of the simulation box at the start, as far as is known
// before the bed is made; nothing without a box.
void demand_inside_box(const Scene& scene, const Mechanism& mechanism);

// Copies the scripts of the box into DIR/script, with the section [particles] that runs them as they stand:
// particles.toml. Nothing without a box.
void keep_box_scripts(const Scene& scene, const std::string& out);

// What `footfall check` says of the grains of a LIGGGHTS script, as far as its text and a bed that is made tell it.

// Grains, their radii, the time step as a share of the Rayleigh and the Hertz time of the smallest grain (theory 5) at the
// speed of the impact, substeps per window: two or three lines. What only LIGGGHTS can compute is left out.
std::string script_report(const Scene& scene);

}  // namespace footfall
