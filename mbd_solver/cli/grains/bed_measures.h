#pragma once
// Figures of a bed of grains that can be compared between runs.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/cli/grains/bed_frames.h"

namespace footfall {

// Kinetic energy of the grains over their mass, all of one density [J/kg]; their spin is left out, as dumps seldom hold
// it.
double kinetic_energy(const BedFrame& bed);

// Mean number of neighbours of a grain: those nearer than `gap` times the smaller radius. 0.01 makes it insensitive to
// the digits of dumps.
double coordination_number(const BedFrame& bed, double gap = 0.01);

// Share of the upright cylinder of radius R [m] below `top` (a point on its axis) that grains fill, down to `depth`
// [m].
double packing_fraction(const BedFrame& bed, const Eigen::Vector3d& top, double R, double depth);

// Height of the bed's surface in rings of `width` [m] around a vertical line: the mean over columns of that width of
// the highest grain's top, or of its height over the column's middle where it reaches over from another. NaN where no
// column holds grains.
std::vector<double> surface_profile(const BedFrame& bed, const Eigen::Vector2d& centre, double width, int rings);

// How far apart the same grains are in two beds. Grains that only one of them holds are left out.
struct Separation {
  double median = 0.0, mean = 0.0, largest = 0.0;  // [m]
  double share_apart = 0.0;  // of the grains that are further apart than a tenth of their radius [-]
};
Separation separation(const BedFrame& a, const BedFrame& b);

}  // namespace footfall
