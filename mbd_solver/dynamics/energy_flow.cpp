// Differences of all forms between samples, summed with their magnitudes.

#include "mbd_solver/dynamics/energy_flow.h"

#include <algorithm>
#include <cmath>

namespace footfall {
namespace {

constexpr double kRoundOff = 1e-9;  // of the largest form: accuracy of differences of energies

// A joint holds or moves it against the ground, whose frame is then the only one in which its work is counted.
bool is_anchored(const Model& model) {
  for (int i = 0; i < model.joint_count(); ++i)
    if (model.joint(i).m1.body == kGround || model.joint(i).m2.body == kGround) return true;
  return false;
}

}  // namespace

void EnergyFlow::sample(const StoredEnergy& stored, const State& state, const Kinematics& kinematics) {
  double mass = 0.0;
  Eigen::Vector3d P = Eigen::Vector3d::Zero();
  for (int i = 0; i < model_.body_count(); ++i) {
    mass += model_.body(i).mass();
    P += model_.body(i).mass() * kinematics.of(i).dr;
  }
  if (!started_ && !is_anchored(model_)) V0_ = P / mass;
  Forms now{stored, state.dissipated, state.load_work, state.supplied};
  now.stored[Stored::kKinetic] += 0.5 * mass * V0_.squaredNorm() - V0_.dot(P);
  if (started_) {
    double moved = (now.load_work - last_.load_work).cwiseAbs().sum();
    for (std::size_t k = 0; k < now.supplied.by_kind.size(); ++k)
      moved += std::abs(now.supplied.by_kind[k] - last_.supplied.by_kind[k]);
    for (std::size_t k = 0; k < now.stored.by_kind.size(); ++k)
      moved += std::abs(now.stored.by_kind[k] - last_.stored.by_kind[k]);
    for (std::size_t k = 0; k < now.dissipated.by_kind.size(); ++k)
      moved += std::abs(now.dissipated.by_kind[k] - last_.dissipated.by_kind[k]);
    flow_ += 0.5 * moved;
  }
  started_ = true;
  largest_kinetic_ = std::max(largest_kinetic_, now.stored[Stored::kKinetic]);
  for (const double form : stored.by_kind) largest_form_ = std::max(largest_form_, std::abs(form));
  last_ = std::move(now);
}

void EnergyFlow::Forms::visit(Archive& archive) {
  archive.members<&Forms::stored, &Forms::dissipated, &Forms::load_work, &Forms::supplied>(*this);
}

void EnergyFlow::visit(Archive& archive) {
  archive.members<&EnergyFlow::started_, &EnergyFlow::V0_, &EnergyFlow::last_, &EnergyFlow::flow_,
                  &EnergyFlow::largest_kinetic_, &EnergyFlow::largest_form_>(*this);
}

double EnergyFlow::scale() const { return std::max({flow_, largest_kinetic_, kRoundOff * largest_form_}); }

}  // namespace footfall
