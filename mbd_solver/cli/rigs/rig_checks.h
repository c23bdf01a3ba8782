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
// Of a rig whose bodies hold the bed: tray, frame and lid of a shear box, the gate before a slope. Twice the size: bodies,
// bed and way are twice as long, pressures are the same.
std::vector<RigCheck> checks_of_holding_bodies(const Scene& scene, bool slow);

}  // namespace footfall
