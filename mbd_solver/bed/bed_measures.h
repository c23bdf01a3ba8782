#pragma once
// Figures of a bed of grains that can be compared between runs.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/build/grain_dump.h"

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

// The slope of a bed's surface along x. Height of the surface over x: the highest point of a grain in slices two grain
// diameters wide, less a radius. The slices overlap, a quarter of a diameter apart: a steep slope is hardly longer than
// two of them. A line by least squares through the slices whose height lies between two bounds; the angle is the arc
// tangent of its slope.

struct SlopeBounds {
  double left = 0.0, right = 0.0;  // of the bed along x [m]
  double radius = 0.0;             // of its largest grains [m]
  double low = 0.0, high = 0.0;    // heights of the surface that count [m]
};

struct BedSlope {
  std::vector<double> x, height;  // of the surface, slice by slice [m]
  double angle = 0.0;             // [deg], in [0, 90); NaN: fewer than three slices between the bounds
  double r_squared = 0.0;         // of the line; NaN likewise
};

BedSlope bed_slope(const BedFrame& bed, const SlopeBounds& bounds);

// Of the last dump of grains in a folder; left, right and radius are those of its grains. Throws InputError naming the
// folder when it has no dump.
BedSlope last_slope(const std::string& folder, double low, double high);

// How the grains of a bed touch each other, from their places alone.

struct BedContacts {
  // Contacts of a grain with others (two clumps may have several), on the average over those in the middle half of the depth, three radii and more from
  // the outermost grains along x and y; 0 where there are none.
  double coordination = 0.0;
  double largest_overlap = 0.0;  // of two grains, of the smaller radius [-]
};

// Cost grows with the number of grains. Contacts across a period are not seen.
BedContacts bed_contacts(const std::vector<GrainPlace>& grains);

}  // namespace footfall
