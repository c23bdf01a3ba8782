#pragma once
// The instant at which a model is evaluated: what residual, Jacobian and energies share. Sized once, then reused.

#include <optional>
#include <vector>

#include "mbd_solver/dynamics/body_force.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/model/state.h"

namespace footfall {

struct Evaluation {
  // Both must outlive this object.
  Evaluation(const Model& model, const Layout& layout);

  // Unpacks y; accelerations from ydot, or zero.
  void load(const Eigen::Ref<const Eigen::VectorXd>& y);
  void load(const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::Ref<const Eigen::VectorXd>& ydot);
  // After load(): the inputs with the continuous signals among them, and the rates of their states.
  const Eigen::VectorXd& input_values(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs);

  PairMotion pair_of(const Joint& joint) const { return kinematics.pair(joint.m1.body, joint.m2.body); }
  PairMotion pair_of(const ForceElement& force) const { return kinematics.pair(force.bodies()[0], force.bodies()[1]); }

  const Model& model;
  const Layout& layout;
  Kinematics kinematics;
  ElementScratches scratch;
  std::optional<ContinuousSignals> signals;  // a copy of the model's signals
  std::vector<InertiaScratch> inertia;       // per body
  Eigen::VectorXd values, signal_rates;      // inputs with the continuous signals; rates of their states
  // Coordinates of the largest body, pair of bodies and force element; states of the element with most.
  int largest_body = 0, largest_pair = 0, largest_element = 0, most_states = 0;
  Eigen::VectorXd empty;
};

}  // namespace footfall
