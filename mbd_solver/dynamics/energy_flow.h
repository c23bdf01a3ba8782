#pragma once
// How much energy a mechanism has moved from one form to another: the scale that its errors of energy are held against
// (theory 8).
//   flow = 1/2 sum over forms of integral |dE_form|,  taken from sample to sample
// Forms: kinetic energy, gravity, strain, gas, contact; every kind of dissipation; work of external loads on each body;
// work of prescribed motions, forces and drives. What leaves one form arrives in another, hence the half.
// Kinetic energy is that seen by someone who moves as the mass centre did at the start, so that a scene in a train has
// the flow of the scene at rest:
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
  void take(const StoredEnergy& stored, const State& state, const Kinematics& kinematics);

  // The flow, or the largest K' where that is more: a body that spins freely moves no energy. Never less than the
  // round-off of the account. [J]
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
  double largest_form_ = 0.0;     // of any form as it is, K in W included [J]
};

}  // namespace footfall
