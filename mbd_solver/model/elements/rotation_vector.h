#pragma once
// The rotation vector theta = phi n of marker 2 against marker 1, from dot products G_ij = e1_i . e2_j of their axes:
//   c = (tr G - 1) / 2,   w_k = (G_ji - G_ij) / 2 for (i, j, k) = (x, y, z), (y, z, x), (z, x, y)
//   phi = atan2(|w|, c) in [0, pi],   theta = f w,   f = phi / |w|
// theta has the same components in both markers. f is smooth up to half a turn, where the axis of rotation jumps.

#include <Eigen/Dense>

#include "mbd_solver/model/elements/dot_product.h"

namespace footfall {

class RotationVector {
 public:
  RotationVector(const PairMotion& pair, const Marker& m1, const Marker& m2);

  double angle() const { return angle_; }                  // phi [rad]
  const Eigen::Vector3d& value() const { return theta_; }  // theta [rad]

  // With u = [w; c]: p . d(theta)/du at fixed p, its derivative by u, and J = d(theta)/du (3 x 4).
  Eigen::Vector4d gradient(const Eigen::Vector3d& p) const;
  Eigen::Matrix4d curvature(const Eigen::Vector3d& p) const;
  Eigen::Matrix<double, 3, 4> jacobian() const;

  // Everything below adds to its last argument.
  void add_gradient(const Eigen::Vector4d& b, Eigen::Ref<Eigen::VectorXd> out) const;     // out += b . du/dx
  void add_second(const Eigen::Vector4d& b, Eigen::Ref<Eigen::MatrixXd> K) const;         // K += b . d2u/dx2
  void add_jacobian(Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, 4>> columns) const;  // columns += (du/dx)^T

 private:
  KinematicVector e1_[3], e2_[3];
  Eigen::Vector3d w_, theta_;
  double c_, rho_;  // rho = w.w + c^2
  double angle_;
  double f_, g_, h_;  // df/dw = g w,  dg/dw = 2 h w
};

}  // namespace footfall
