#pragma once
// The checks that a rig makes of itself: the same with a bed of twice the size, with grains of half the size, at half the
// speed.

#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"

namespace footfall {

struct RigCheck {
  std::string name;
  std::vector<std::string> settings;  // of --set
};

// Of a scene with a box. Half the speed: every prescribed motion that is a polynomial of time, c_k -> c_k / 2^k, and twice
// the end time [s]; only where `slow`. Throws InputError where the bed is a script's, or a motion is something else.
std::vector<RigCheck> checks_of(const Scene& scene, bool slow);
// Of a shear box (inputs/rigs/scenes/box.toml), whose bed is poured by a script into the box itself. Twice the size: box,
// lid, bed and way are twice as long, the pressure is the same. Half the grains: half the time step, too.
std::vector<RigCheck> checks_of_shear_box(const Scene& scene, bool slow);

}  // namespace footfall
