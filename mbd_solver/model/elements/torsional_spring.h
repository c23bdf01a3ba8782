#pragma once
// Spring and damper about the common z axis of two markers (of a revolute, cylindrical or universal joint).
//   angle phi = atan2(y1.x2, x1.x2) in (-pi, pi],  torque on body 2 about z1:  T = -k (phi - phi0) - c phi'
// With k = 0 any number of turns is allowed; with k > 0 the angle must stay within (-pi, pi].

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
