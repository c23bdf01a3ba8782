#pragma once
// Energy, mass and number of the grains of a rank.
//
//   E = sum of 1/2 m v^2 + 1/2 I w^2 - m g . x   (over the grains; clumps as rigid bodies)

#include <Eigen/Core>

#include "pointers.h"

namespace LAMMPS_NS {

// Sums over the grains of this rank.
struct GrainSum {
  double energy = 0.0;  // E [J]
  double size = 0.0;    // the same without regard to sign [J]: round-off is relative to this
  double mass = 0.0;    // [kg]
  long count = 0;
};
// only_outside: grains beyond fixed sides of the box, which LIGGGHTS is about to lose. ahead: g has acted on the velocities for this
// much less time [s]; at the exchange of grains half a step, because they have been advanced to the middle of the step.
GrainSum sum_of_grains(LAMMPS* lmp, const Eigen::Vector3d& g, bool only_outside = false, double ahead = 0.0);

}  // namespace LAMMPS_NS
