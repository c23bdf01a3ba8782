#pragma once
// The energy that a mechanism has transferred between forms: the scale of its energy errors (theory 8).
//   flow = 1/2 sum over forms of integral |dE_form|,  taken from sample to sample
// Forms: kinetic energy, gravity, strain, gas, contact; every kind of dissipation; work of external loads on each body;
// work of prescribed motions, forces and drives. Every transfer is counted in two forms, hence the half.
// Kinetic energy of a mechanism without joints to the ground is measured relative to the initial velocity of the mass centre, so
// that the flow does not depend on a common velocity:
//   K' = K - V0 . P + 1/2 m V0^2,  P = sum m_i dr_i,  V0 = P(0) / m

#include <Eigen/Dense>

#include "coupler/archive.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/state.h"

namespace footfall {

class EnergyFlow {
 public:
  // `model` must outlive this.
  explicit EnergyFlow(const Model& model) : model_(model) {}
  // At the start and after every window.
  void sample(const StoredEnergy& stored, const State& state, const Kinematics& kinematics);

  // The flow, or the largest K' if that is larger (a freely spinning body transfers no energy); at least the round-off of the
  // energies. [J]
  double scale() const;

  void visit(Archive& archive);

 private:
  struct Forms {
    StoredEnergy stored;  // its kinetic energy is K'
    Dissipated dissipated;
    Eigen::VectorXd load_work;
    Supplied supplied;

    void visit(Archive& archive);
  };

  const Model& model_;
  bool started_ = false;
  Eigen::Vector3d V0_ = Eigen::Vector3d::Zero();  // [m/s]
  Forms last_;
  double flow_ = 0.0;             // [J]
  double largest_kinetic_ = 0.0;  // of K' [J]
  double largest_form_ = 0.0;     // of any form, K in W included [J]
};

}  // namespace footfall
