#pragma once
// Where a circular edge that stands up touches uneven ground. Theory 6.8.
// A circle of radius R about r across the axis a, and the field with the normal N(c) = (-h_x, -h_y, 1) at its places c. The places
// p = r + R e on the circle and c on the field face each other:
//   (p - c).T_x = 0,  (p - c).T_y = 0,  N.t = 0;   T_x = (1, 0, h_x), T_y = (0, 1, h_y), t = a x e
// which is where the distance of c from the circle is stationary on the field. With d = c - r = U u + V v + w a, u level, v up in the
// plane of the circle, rho = |(U, V)| and N_p the part of N in that plane this is, in c alone and for any sharpness of the ground,
//   U N_v - V N_u = 0,   w |N_p| - (R - rho) N.a = 0,   e = -N_p / |N_p|,   overlap n.(c - p) = hypot(R - rho, w) where rho < R
// All such places count, by the sign of the determinant of these equations' derivatives (-1: a saddle between two places): they
// appear and end in pairs of opposite sign and the same overlap, so that the energy of the sum has no jump.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/model/terrain.h"

namespace footfall {

struct EdgePlace {
  double sign = 1.0;
  Eigen::Vector3d e = Eigen::Vector3d::Zero();   // from the centre to p
  double overlap = 0.0;                          // [m]
  Eigen::Vector3d n = Eigen::Vector3d::UnitZ();  // of the field at c
  Terrain::Height at_c;                          // its height, slope, bend
  Eigen::Vector3d c = Eigen::Vector3d::Zero();   // [m]
  // By [dr; dtheta] of the body, whose Bo is `arm` before p: of p along the circle, and of n.
  void find_ways(double R, const Eigen::Vector3d& a, const Eigen::Vector3d& arm, Eigen::Matrix<double, 3, 6>& of_p,
                 Eigen::Matrix<double, 3, 6>& of_n) const;
};

// All of overlap > 0. The field is below `top` [m] of W within R of the centre. Overwrites out.
void find_edge_places(const Terrain& terrain, const Eigen::Vector3d& centre, double R, const Eigen::Vector3d& a,
                      double top, std::vector<EdgePlace>& out);

}  // namespace footfall
