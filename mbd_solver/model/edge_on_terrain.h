#pragma once
// Where a raised circular edge touches uneven ground. Theory 6.8.
// A circle of radius R about r across the axis a cuts the field, of the normal N(c) = (-h_x, -h_y, 1), along a curve. It touches at
// the places c of the curve whose distance rho from r is stationary. With d = c - r = U u + V v + w a, u level, v up in its plane:
//   w = 0,   U N_v - V N_u = a.(d x N) = 0,   e = d / rho,   inside = R - rho > 0
//   d inside = -n.(dr + dtheta x (c - Bo)) / s,  s = |n - (n.a) a|:  the force acts at c along n
// All such places count, by the sign of the determinant of the derivatives of w and a.(d x N) by x and y (-1: the greatest distance
// between two least): they appear and end in pairs of opposite sign and the same depth, so that the energy has no jump however sharp
// the ground is. The overlap is s inside, the distance along n where the ground is a plane, and the stiffness k (|a_h| / s)^2.5, a_h
// the level part of a: the energy 0.4 k (|a_h| inside)^2.5 does not know n, and equals the energy of a plane on a level.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/model/terrain.h"

namespace footfall {

struct EdgePlace {
  double sign = 1.0;
  double inside = 0.0;                                                               // R - rho [m]
  Eigen::Vector3d e = Eigen::Vector3d::Zero();                                       // from the centre to c
  Eigen::Vector3d n = Eigen::Vector3d::UnitZ();                                      // of the field at c
  Terrain::Height at_c;                                                              // its height, slope, bend
  Eigen::Vector3d c = Eigen::Vector3d::Zero();                                       // [m]
  double tilt(const Eigen::Vector3d& a) const { return (n - n.dot(a) * a).norm(); }  // s
  // By [dr; dtheta] of the body, whose Bo is `arm` before the centre: of c against the body, and of n.
  void find_ways(const Eigen::Vector3d& a, const Eigen::Vector3d& centre, const Eigen::Vector3d& arm,
                 Eigen::Matrix<double, 3, 6>& of_c, Eigen::Matrix<double, 3, 6>& of_n) const;
};

// All that are inside. The field is below `top` [m] of W within R of the centre. Overwrites out.
void find_edge_places(Terrain& terrain, const Eigen::Vector3d& centre, double R, const Eigen::Vector3d& a, double top,
                      std::vector<EdgePlace>& out);

}  // namespace footfall
