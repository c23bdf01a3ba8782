#pragma once
// Whether bodies will leave a bed by numbers sideways, as far as it follows from their motion at the start.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// A warning for each body whose middle may pass a side wall of [particles.box] before the end of the scene, with the time.
//   prescribed relative to the ground: its displacement
//   free (nothing joins it to the ground, directly or through other bodies): flight to the surface under gravity, then
//   sliding under gravity along the surface, also of a terrain, with half of the friction, because a bed on a slope gives way
std::vector<std::string> leaving_bodies(const Scene& scene, const Mechanism& mechanism);

// A bed as small as the bodies allow, by the table of docs/how-to/size_a_bed.md: one width of the widest body that touches the
// bed below it and on each side of its path, two if the path is long, and at least five grains. On a terrain the floor is that deep below the
// lowest body. Rocks of the terrain are part of it. No proposal where bodies are the walls of the bed.
struct BedProposal {
  Eigen::Vector2d size = Eigen::Vector2d::Zero(), centre = Eigen::Vector2d::Zero();  // along x and y [m]
  double depth = 0.0;                                                                // [m]
  double sinkage = 0.0;  // that is expected, for a plate of the area of the bodies on a loose bed [m]
  double width = 0.0;    // of the widest body, the shorter side [m]; 0: no body, no proposal
  bool further = false;  // a body on joints with the ground has a speed at the start, whose way is not in the size
};
BedProposal proposed_bed(const Scene& scene, const Mechanism& mechanism);
// A line for `footfall check` with the command that sets it.
std::string proposal_text(const Scene& scene, const BedProposal& bed);

}  // namespace footfall
