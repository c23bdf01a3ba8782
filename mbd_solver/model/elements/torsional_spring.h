#pragma once
// Spring and damper about the common z axis of two markers (of a revolute, cylindrical or universal joint).
//   principal angle  alpha = atan2(y1.x2, x1.x2) in (-pi, pi]
//   angle            phi = alpha + 2 pi round((z - alpha) / (2 pi)),  continuous over any number of turns
//   torque on body 2 about z1:  T = -k (phi - phi0) - c phi'
// The inner state z follows the angle, dz = phi' + kTurnFollow (phi - z), and only tells how many whole turns there are:
// phi is exact while z is within half a turn of it. z starts at zero, so the angle starts in (-pi, pi]. A damper alone
// (k = 0) has no inner state. theory 3.5.

#include "mbd_solver/model/force_element.h"

namespace footfall {

class TorsionalSpring : public ForceElement {
 public:
  struct Parameters {
    double stiffness = 0.0;   // k [N m/rad] >= 0
    double damping = 0.0;     // c [N m s/rad] >= 0
    double free_angle = 0.0;  // phi0 [rad]
  };
  TorsionalSpring(std::string name, Marker m1, Marker m2, const Parameters& parameters);

  int state_count() const override { return parameters_.stiffness > 0.0 ? 1 : 0; }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(state_count()); }
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;
  // phi [rad], phi' [rad/s], T [N m].
  Eigen::Vector3d sample(const ElementInput& in) const;

 private:
  Marker m1_, m2_;
  Parameters parameters_;
  mutable Eigen::VectorXd sine_, cosine_, scratch_;  // scratch rows of size n
};

}  // namespace footfall
