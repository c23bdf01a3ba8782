#pragma once
// The damping ratio that a flexible body has as its joints hold it. The scene gives the ratio of the body's free modes: where
// joints hold a body, its lowest mode is mostly a combination of stiffer free modes, which damp slow motion little.

#include <string>
#include <vector>

#include "mbd_solver/assemble/mechanism.h"

namespace footfall {

struct AttachedDamping {
  int body = 0;            // in the model
  double frequency = 0.0;  // of the lowest mode with at least half of its strain energy in this body [Hz]
  double given = 0.0;      // damping ratio of the scene
  double ratio = 0.0;      // of this mode
};

// One per flexible body with damping whose ratio differs from the given one by more than a fifth; at the start, joints closed,
// without struts and springs.
// most: velocities of the mechanism beyond which nothing is computed; the effort grows with their third power.
constexpr int kMostVelocities = 1000;
std::vector<AttachedDamping> attached_damping(const Scene& scene, const Mechanism& mechanism,
                                              int most = kMostVelocities);

// The warnings of `check`, also of bodies that bend too far under the weight that their joints hold.
std::vector<std::string> warnings_of_held_bodies(const Scene& scene, const Mechanism& mechanism);
// The warnings of a run: of few velocities, and of damping that is not the default.
std::vector<std::string> damping_warnings_of_run(const Scene& scene, const Mechanism& mechanism);

}  // namespace footfall
