#pragma once
// What `footfall check` reports about grains: the bed that [particles.box] describes, or what the text of a LIGGGHTS
// script and a bed in the cache show; and the scripts of the box, stored with the results of a run.

#include <string>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Size, floor and surface of the bed, its grains, time step, and its folder; of a bed in the cache, its contents. A few
// lines. For a scene with [particles.box].
std::string box_report(const Scene& scene);

// Throws InputError when a coupled body reaches out of the simulation box at the start, as far as it is known before the
// bed is made. Does nothing without [particles.box].
void require_inside_box(const Scene& scene, const Mechanism& mechanism);

// Copies the scripts of the box into DIR/script, with particles.toml: the section [particles] that runs them. Does
// nothing without [particles.box].
void store_box_scripts(const Scene& scene, const std::string& out);

// Grains, their radii, the time step as a share of the Rayleigh and the Hertz time of the smallest grain (theory 5) at
// the speed of the impact, DEM steps per window: two or three lines. Values that only LIGGGHTS can compute are left out.
std::string script_report(const Scene& scene);

}  // namespace footfall
