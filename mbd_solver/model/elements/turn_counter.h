#pragma once
// Counts the turns of an angle for a gear, and acts on nothing. theory 2.1.
//   z' = q' + kTurnFollow (q - z)     (joints/whole_turns.h)

#include "mbd_solver/model/force_element.h"
#include "mbd_solver/model/joints/joint_coordinate.h"

namespace footfall {

class TurnCounter : public ForceElement {
 public:
  // Markers of the joint, z along its axis. Not to be evaluated from two threads at once (it owns scratch).
  TurnCounter(std::string name, Marker m1, Marker m2);

  int state_count() const override { return 1; }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(1); }
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput&, StoredEnergy&, Dissipated&) const override {}

 private:
  Marker m1_, m2_;
  mutable CoordinateScratch scratch_;
  mutable Eigen::VectorXd row_;
};

}  // namespace footfall
