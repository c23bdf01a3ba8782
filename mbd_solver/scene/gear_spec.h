#pragma once
// Gears of a scene: a weighted sum of coordinates of joints that remains zero, as in the reference configuration.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "mbd_solver/scene/joint_spec.h"

namespace footfall {

// sum_i factors[i] q_i = 0. Two external wheels with n1 and n2 teeth: [n1, n2] about parallel axes; an internal one:
// [n1, -n2]. A rack: [pitch radius, -1]. A differential: [1, 1, -2]. A cam: the last coordinate is replaced by y(q) - y(0).
struct GearSpec {
  Source source;
  std::string name;
  std::vector<std::string> joints;  // two or more
  std::vector<double> factors;      // of each joint, none zero [1/rad or 1/m, times a common unit]
  // Of each joint: "angle", "displacement" ... or "auto" (its only one); empty: all "auto"
  std::vector<std::string> coordinates;
  std::vector<Eigen::Vector2d> curve;  // of a cam: (q [rad or m], y), q rising; empty: none
  bool closed = false;                 // the curve is periodic: over one turn of an angle, any length of a displacement
};

}  // namespace footfall
