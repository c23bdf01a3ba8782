#pragma once
// The slope of a bed's surface along x. Height of the surface over x: the highest point of a grain in slices two grain
// diameters wide, less a radius. The slices overlap, a quarter of a diameter apart: a steep slope is hardly longer than
// two of them. A line by least squares through the slices whose height lies between two bounds; the angle is the arc
// tangent of its slope.

#include <vector>

#include "mbd_solver/cli/grains/bed_frames.h"

namespace footfall {

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

}  // namespace footfall
