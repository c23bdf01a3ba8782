#pragma once
// The mass that damping acts on where a grain touches a body that can give way.

namespace footfall {

// LIGGGHTS takes a wall for infinitely heavy: the effective mass of its contacts is the grain's. While this lives, the
// grain counts as
//   m_eff = m M / (m + M)
// with the mass M that the contact meets on the body's side: damping is then that of two bodies, and the coefficient of
// restitution the one that the script gives. inverse_mass: 1/M [1/kg], 0 for a body that does not give way, which
// changes nothing.
class PairMass {
 public:
  PairMass(double& grain, double inverse_mass) : grain_(grain), own_(grain) {
    grain = own_ / (1.0 + own_ * inverse_mass);
  }
  ~PairMass() { grain_ = own_; }
  PairMass(const PairMass&) = delete;
  PairMass& operator=(const PairMass&) = delete;

 private:
  double& grain_;
  double own_;  // [kg]
};

}  // namespace footfall
