#pragma once
// Gears of a scene: a weighted sum of coordinates of joints that stays zero, as it is in the drawing.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "mbd_solver/scene/joint_spec.h"

namespace footfall {

// sum_i factors[i] q_i = 0. Two wheels with n1 and n2 teeth outside of each other: [n1, n2] about parallel axes; inside:
// [n1, -n2]. A rack: [pitch radius, -1]. A differential: [1, 1, -2]. A cam: the last coordinate enters as a curve, y(q) - y(0).
struct GearSpec {
  Source source;
  std::string name;
  std::vector<std::string> joints;  // two or more
  std::vector<double> factors;      // of each, none zero [1/rad or 1/m, up to a common unit]
  // Of each joint: "angle", "displacement" or "auto" (the one that there is); empty: all "auto"
  std::vector<std::string> coordinates;
  std::vector<Eigen::Vector2d> curve;  // of a cam: (q [rad or m], y), q rising; empty: none
  bool closed = false;                 // the curve goes round: over one turn of an angle, any length of a displacement
};

}  // namespace footfall
