#pragma once
// A bushing, and the rotation vector between two markers that it is written with.

#include <Eigen/Dense>

#include "mbd_solver/model/force_element.h"
#include "mbd_solver/model/kinematic_vector.h"

namespace footfall {

// The rotation vector theta = phi n of marker 2 against marker 1, from dot products G_ij = e1_i . e2_j of their axes:
//   c = (tr G - 1) / 2,   w_k = (G_ji - G_ij) / 2 for (i, j, k) = (x, y, z), (y, z, x), (z, x, y)
//   phi = atan2(|w|, c) in [0, pi],   theta = f w,   f = phi / |w|
// theta has the same components in both markers. f is smooth up to half a turn, where the axis of rotation jumps.
class RotationVector {
 public:
  RotationVector(const PairMotion& pair, const Marker& m1, const Marker& m2);

  double angle() const { return angle_; }                  // phi [rad]
  const Eigen::Vector3d& value() const { return theta_; }  // theta [rad]

  // With u = [w; c]: p . d(theta)/du at fixed p, its derivative by u, and J = d(theta)/du (3 x 4).
  Eigen::Vector4d gradient(const Eigen::Vector3d& p) const;
  Eigen::Matrix4d curvature(const Eigen::Vector3d& p) const;
  Eigen::Matrix<double, 3, 4> jacobian() const;

  // All add to their last argument.
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

// Bushing between two markers: a spring and a damper along and about each axis of marker 1.
//   displacement  d_i = e1_i . (p2 - p1),  force along e1_i:  -k_i d_i - c_i d_i'
//   rotation      potential V = 1/2 sum_i k_i theta_i^2 of the rotation vector theta: after a rotation by phi about axis i
//                 alone the torque is k_i phi, below half a turn. NumericalError beyond kLargestTurn, near the jump.
//   damping torque on body 2 about e1_i:  -c_i e1_i . (w2 - w1), w = angular velocity of the node (A Psi da included),
//                 at any angle
// The weak centring spring of a pad pivot is a bushing without translation, next to a spherical joint. theory 3.5.
class Bushing : public ForceElement {
 public:
  static constexpr double kLargestTurn = 175.0;  // [degrees]

  struct Parameters {                                                // along or about x, y, z of marker 1, all >= 0
    Eigen::Vector3d stiffness = Eigen::Vector3d::Zero();             // [N/m]
    Eigen::Vector3d damping = Eigen::Vector3d::Zero();               // [N s/m]
    Eigen::Vector3d rotational_stiffness = Eigen::Vector3d::Zero();  // [N m/rad]
    Eigen::Vector3d rotational_damping = Eigen::Vector3d::Zero();    // [N m s/rad]
  };
  Bushing(std::string name, Marker m1, Marker m2, const Parameters& parameters);

  std::unique_ptr<ElementScratch> scratch(SharedCopies& shared) const override;
  // All throw NumericalError beyond kLargestTurn if a rotational stiffness is not zero.
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;

 private:
  struct Scratch;
  class Turn;
  void add_translation_derivatives(const ElementInput& in, ElementDerivatives& out) const;
  void add_rotation_derivatives(const ElementInput& in, ElementDerivatives& out) const;
  void add_turning_derivatives(const ElementInput& in, ElementDerivatives& out) const;

  Marker m1_, m2_;
  Parameters parameters_;
  bool translates_, turns_, damps_turning_;  // which parts are not zero
};

}  // namespace footfall
