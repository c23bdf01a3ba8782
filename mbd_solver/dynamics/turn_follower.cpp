// An angle is known up to whole turns from the attitudes of two bodies; the turn comes from the state before.

#include "mbd_solver/dynamics/turn_follower.h"

#include <cmath>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/elements/joint_coordinate.h"

namespace footfall {
namespace {

constexpr double kSurprise = 0.5 * kPi;  // difference of an angle from the expected angle: the turn is uncertain

JointCoordinate angle_of(const Joint& joint, const Kinematics& kinematics) {
  return {Coordinate::kAngle, kinematics.pair(joint.m1.body, joint.m2.body), joint.m1, joint.m2};
}

}  // namespace

TurnFollower::TurnFollower(const Model& model, const Layout& layout)
    : model_(model), layout_(layout), kinematics_(model) {
  for (int j = 0; j < model.joint_count(); ++j)
    if (model.joint(j).counts_turns) joints_.push_back(j);
}

void TurnFollower::load(const State& state, const Eigen::VectorXd& rates) {
  kinematics_.load(layout_, state.q, state.v, rates.segment(layout_.v0(), layout_.v_size));
}

void TurnFollower::measure(const State& state, const Eigen::VectorXd& rates, Motion& out) {
  out.time = state.time;
  if (joints_.empty()) return;
  load(state, rates);
  out.rate.resize(layout_.angle_count);
  out.acc.resize(layout_.angle_count);
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const JointCoordinate now = angle_of(model_.joint(joints_[k]), kinematics_);
    out.rate[static_cast<Eigen::Index>(k)] = now.rate();
    out.acc[static_cast<Eigen::Index>(k)] = now.acc();
  }
}

void TurnFollower::follow(const Motion& from, const Eigen::VectorXd& rates, State& state, Motion* to) {
  const double h = state.time - from.time;
  if (to != nullptr) to->time = state.time;
  if (joints_.empty()) return;
  load(state, rates);
  if (to != nullptr) {
    to->rate.resize(layout_.angle_count);
    to->acc.resize(layout_.angle_count);
  }
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const JointCoordinate now = angle_of(model_.joint(joints_[k]), kinematics_);
    const double expected =
        state.angles[i] + 0.5 * h * (from.rate[i] + now.rate()) + h * h / 12.0 * (from.acc[i] - now.acc());
    state.angles[i] = nearest_turn(now.value(), expected);
    if (state.uncertain_angle < 0 && std::abs(state.angles[i] - expected) > kSurprise)
      state.uncertain_angle = joints_[k];
    if (to == nullptr) continue;
    to->rate[i] = now.rate();
    to->acc[i] = now.acc();
  }
}

void start_angles(const Model& model, const Layout& layout, const Kinematics& kinematics, State& state) {
  state.angles.resize(layout.angle_count);
  for (int j = 0; j < model.joint_count(); ++j)
    if (const int angle = layout.joint_angle[j]; angle >= 0)
      state.angles[angle] = angle_of(model.joint(j), kinematics).value();
}

}  // namespace footfall
