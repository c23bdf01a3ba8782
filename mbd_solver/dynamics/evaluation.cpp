// Sizes of scratch are the largest in the model, so that no evaluation allocates.

#include "mbd_solver/dynamics/evaluation.h"

#include <algorithm>

namespace footfall {

Evaluation::Evaluation(const Model& given_model, const Layout& given_layout)
    : model(given_model), layout(given_layout), kinematics(given_model), scratch(given_model) {
  if (model.signals()) signals.emplace(*model.signals());
  for (int i = 0; i < model.body_count(); ++i) {
    inertia.emplace_back(model.body(i).mode_count());
    largest_body = std::max(largest_body, 6 + model.body(i).mode_count());
  }
  largest_pair = largest_element = 2 * largest_body;
  for (int i = 0; i < model.force_count(); ++i) {
    const ForceElement& force = model.force(i);
    int size = pair_of(force).size();
    for (const int body : force.further_bodies()) size += kinematics.of(body).size();
    largest_element = std::max(largest_element, size);
    most_states = std::max(most_states, force.state_count());
  }
  signal_rates = Eigen::VectorXd::Zero(layout.z_size - layout.signal_z);
}

void Evaluation::load(const Eigen::Ref<const Eigen::VectorXd>& y) {
  kinematics.load(layout, y.head(layout.q_size), y.segment(layout.v0(), layout.v_size), empty);
  kinematics.load_turns(layout, y.segment(layout.z0(), layout.z_size));
}

void Evaluation::load(const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::Ref<const Eigen::VectorXd>& ydot) {
  kinematics.load(layout, y.head(layout.q_size), y.segment(layout.v0(), layout.v_size),
                  ydot.segment(layout.v0(), layout.v_size));
  kinematics.load_turns(layout, y.segment(layout.z0(), layout.z_size));
}

const Eigen::VectorXd& Evaluation::input_values(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                                const Inputs& inputs) {
  if (!signals) return inputs.values;
  values = inputs.values;
  const Instant instant{kinematics, layout, model, y.segment(layout.z0(), layout.z_size)};
  signals->evaluate(t, instant, instant.z.tail(signal_rates.size()), values, signal_rates);
  return values;
}

}  // namespace footfall
