#pragma once
// Rolling without slip of a sphere, or of a thin disc on its edge, on a plane. Marker 1: point p1 and axes x1, y1 of the
// plane, n = z1. Marker 2: centre p2 and axes of the wheel, a = z2 is the disc's. All in the frame of marker 1:
//   d = p2 - p1,  w = angular velocity of the wheel,  rho from the centre to the contact point,  |rho| = R
//   velocity of that point   u = d' + w x rho = 0             three rows, along x1, y1, z1
//   sphere   rho = -R n,                     u_z = (d_z - R)'
//   disc     rho = -R (n - a_z a) / s,       u_z = (d_z - R s)',  s = sqrt(a_x^2 + a_y^2)
//            w x rho = R (sigma h + a a_z'/s),  h = (n x a) / s,  sigma = x2'.y2 the spin about the disc's axis
// The row along z1 is a condition on the position (the height) as well; the others have phi = 0 always (nonholonomic).
// Each u is linear in rates of dot products: u_k = sum_m c_m(u) u_m', see rolling.cpp. theory 2.1.

#include "mbd_solver/model/elements/constraint_row.h"

namespace footfall {

// Row k is along axis k of marker 1.
class Rolling : public RowLaw {
 public:
  Rolling(double radius, bool disc) : radius_(radius), disc_(disc) {}  // radius R > 0 [m]

  bool holds_positions(int row) const override { return row == 2; }
  RowValue evaluate(int row, MarkerVectors& vectors, Eigen::Ref<Eigen::VectorXd> phi_v) const override;
  void add_derivatives(int row, MarkerVectors& vectors, double lambda, Eigen::Ref<Eigen::VectorXd> rate_dx,
                       Eigen::Ref<Eigen::VectorXd> acc_dx, Eigen::Ref<Eigen::VectorXd> acc_dv,
                       Eigen::Ref<Eigen::MatrixXd> K, RowScratch& scratch) const override;

 private:
  double radius_;
  bool disc_;
};

}  // namespace footfall
