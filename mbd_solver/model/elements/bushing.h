#pragma once
// Bushing between two markers: translational spring-damper (isotropic) and centring spring for the relative
// attitude.
//   force on body 2 at its marker: F = -k d - c d',  d = p2 - p1
//   attitude: potential V = 1/2 sum_i k'_i (1 - e1_i . e2_i),  k'_i = k_j + k_l - k_i, which for small
//     relative rotations phi is 1/2 sum_i k_i phi_i^2 about the axes of marker 1, and stays smooth for any
//     rotation (k (1 - cos phi) when isotropic)
//   damping torque on body 2: -c_rot (w2 - w1), w = angular velocity of the node (A Psi da included)
// The weak centring spring of a pad pivot is this with translation left to a spherical joint.

#include "mbd_solver/model/force_element.h"

namespace footfall {

class Bushing : public ForceElement {
 public:
  struct Parameters {
    double stiffness = 0.0;                               // k [N/m] >= 0
    double damping = 0.0;                                 // c [N s/m] >= 0
    Eigen::Vector3d rotational_stiffness{0.0, 0.0, 0.0};  // about x, y, z of marker 1 [N m/rad] >= 0
    double rotational_damping = 0.0;                      // [N m s/rad] >= 0
  };
  Bushing(std::string name, Marker m1, Marker m2, const Parameters& parameters);

  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;

 private:
  Marker m1_, m2_;
  Parameters parameters_;
  Eigen::Vector3d axis_weight_;          // k'_i
  mutable Eigen::Matrix3Xd X_, X_rate_;  // scratch, 3 x n
};

}  // namespace footfall
