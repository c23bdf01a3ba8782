// A row has force, torque and modal forces of body after body.

#include "liggghts_fix/link/opening_forces.h"

#include "coupler/base/errors.h"

namespace footfall {

void OpeningForces::expect_set_up() {
  for (const auto& body : bodies_) body->clear_contacts();
  set_up_ = true;
}

void OpeningForces::begin_substep() {
  if (set_up_)
    for (const auto& body : bodies_) body->use_as_opening_force();
  set_up_ = false;
}

std::vector<double> OpeningForces::of_this_rank() const {
  std::vector<double> row;
  for (const auto& body : bodies_) {
    const OpeningForce& force = body->opening_force();
    row.insert(row.end(), force.F_W.data(), force.F_W.data() + 3);
    row.insert(row.end(), force.T_B.data(), force.T_B.data() + 3);
    row.insert(row.end(), force.Q_a.data(), force.Q_a.data() + force.Q_a.size());
  }
  return row;
}

void OpeningForces::restore(bool on_this_rank) {
  const double* next = stored_.data();
  for (const auto& body : bodies_) {
    OpeningForce force(body->boundary().mode_count());
    if (on_this_rank) {
      force.F_W = Eigen::Map<const Eigen::Vector3d>(next);
      force.T_B = Eigen::Map<const Eigen::Vector3d>(next + 3);
      force.Q_a = Eigen::Map<const Eigen::VectorXd>(next + 6, force.Q_a.size());
    }
    next += 6 + force.Q_a.size();
    body->set_opening_force(force);
  }
  FOOTFALL_DEMAND(next == stored_.data() + stored_.size());
  set_up_ = false;
}

}  // namespace footfall
