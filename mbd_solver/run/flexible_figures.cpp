#include "mbd_solver/run/flexible_figures.h"

#include <algorithm>

#include "mbd_solver/model/flexible/stress_recovery.h"

namespace footfall {

FlexibleBodies::FlexibleBodies(const Simulation& simulation) : simulation_(simulation) {
  const Model& model = simulation.mechanism().model;
  for (int i = 0; i < model.body_count(); ++i)
    if (model.body(i).mode_count() > 0) bodies_.push_back(i);
  now_.resize(bodies_.size());
  peak_.resize(bodies_.size());
}

int FlexibleBodies::find(int body) const {
  const auto found = std::find(bodies_.begin(), bodies_.end(), body);
  return found == bodies_.end() ? -1 : static_cast<int>(found - bodies_.begin());
}

const Body& FlexibleBodies::body(int k) const { return simulation_.mechanism().model.body(bodies_[static_cast<std::size_t>(k)]); }

void FlexibleBodies::take(const Sample& sample) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Body& body = simulation_.mechanism().model.body(bodies_[k]);
    const Eigen::Index first = simulation_.layout().body_q[static_cast<std::size_t>(bodies_[k])] + 7;
    const Eigen::VectorXd a = sample.state.q.segment(first, body.mode_count());
    now_[k] = {body.inertia().strain_energy(a), largest_deflection(*body.modal(), a), von_mises(*body.modal(), a)};
    peak_[k].strain_energy = std::max(peak_[k].strain_energy, now_[k].strain_energy);
    peak_[k].deflection = std::max(peak_[k].deflection, now_[k].deflection);
    peak_[k].von_mises = std::max(peak_[k].von_mises, now_[k].von_mises);
  }
}

}  // namespace footfall
