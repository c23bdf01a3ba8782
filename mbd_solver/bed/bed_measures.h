#pragma once
// Measures of a bed of grains: energy, packing, surface profile and slope, contacts, and the distance between two beds.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/assemble/grain_dump.h"
#include "mbd_solver/bed/bed_frames.h"

namespace footfall {

// Kinetic energy of the grains, all of one density, divided by their mass [J/kg]; without rotation, which dumps seldom
// contain.
double kinetic_energy(const BedFrame& bed);

// Mean number of neighbours of a grain: those with a gap below `gap` times the smaller radius. 0.01 makes it insensitive
// to the digits of dumps.
double coordination_number(const BedFrame& bed, double gap = 0.01);

// Share of a vertical cylinder that grains fill [-]: radius R [m], from `top` (a point on its axis) down by `depth` [m].
double packing_fraction(const BedFrame& bed, const Eigen::Vector3d& top, double R, double depth);

// Height of the bed's surface [m] in rings of `width` [m] around a vertical line: the mean over columns of that width of
// the highest grain's top; of a grain of another column that reaches over, its height above the column's middle. NaN
// where no column contains grains.
std::vector<double> surface_profile(const BedFrame& bed, const Eigen::Vector2d& centre, double width, int rings);

// Distances between the same grains in two beds. Grains that only one bed has are left out.
struct Separation {
  double median = 0.0, mean = 0.0, largest = 0.0;  // [m]
  double share_apart = 0.0;                        // of grains further apart than a tenth of their radius [-]
};
Separation separation(const BedFrame& a, const BedFrame& b);

// The slope of a bed's surface along x. Height of the surface over x: the highest grain centre in slices two grain
// diameters wide; the slices overlap, a quarter of a diameter apart, because a steep slope is hardly longer than two of
// them. A line by least squares goes through the slices whose height lies between two bounds; the angle is the arc
// tangent of its slope.

struct SlopeBounds {
  double left = 0.0, right = 0.0;  // of the bed along x [m]
  double radius = 0.0;             // of its largest grains [m]
  double low = 0.0, high = 0.0;    // range of heights that count [m]
};

struct BedSlope {
  std::vector<double> x, height;  // of the surface, slice by slice [m]
  double angle = 0.0;             // [deg], in [0, 90); NaN for fewer than three slices between the bounds
  double r_squared = 0.0;         // of the line [-]; NaN likewise
};

BedSlope bed_slope(const BedFrame& bed, const SlopeBounds& bounds);

// Of the last dump of grains in a folder; left, right and radius are taken from its grains. Throws InputError when there is
// no dump.
BedSlope last_slope(const std::string& folder, double low, double high);

struct BedContacts {
  // Mean number of contacts of a grain (two clumps may have several), over the middle half of the depth and at least
  // three radii from the outermost grains along x and y; 0 where there are none.
  double coordination = 0.0;
  double largest_overlap = 0.0;  // of two grains, over the smaller radius [-]
};

// From the positions of grains. Contacts across a periodic boundary are not counted.
BedContacts bed_contacts(const std::vector<GrainPlace>& grains);

}  // namespace footfall
