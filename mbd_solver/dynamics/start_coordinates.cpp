#include "mbd_solver/dynamics/start_coordinates.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/dynamics/joint_closing.h"
#include "mbd_solver/dynamics/unbent_closing.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kStartStep = 0.05;  // [rad or m]: of a coordinate on its way to the start

// One more condition per given coordinate: it goes from the drawing's zero at t = 0 to its value at t = 1.
Model model_on_the_way(const Model& model, const std::vector<StartCoordinate>& start) {
  Model out = without_forces(model);
  for (const StartCoordinate& given : start) {
    const Joint& joint = model.joint(given.joint);
    PrescribedMotion motion;
    const auto axis = static_cast<std::size_t>(axis_of(given.coordinate));
    (given.coordinate == Coordinate::kAngle ? motion.rotation : motion.translation[axis]) =
        polynomial({0.0, given.value});
    out.add_joint(prescribed_joint("start of " + joint.name + "." + std::string(name_of(given.coordinate)), joint.m1,
                                   joint.m2, motion));
  }
  return out;
}

// A mechanism that no joint holds to the ground keeps its first body where it was drawn.
void put_back_first_body(const Model& model, const Layout& layout, State& state) {
  for (int j = 0; j < model.joint_count(); ++j)
    if (model.joint(j).m1.body == kGround || model.joint(j).m2.body == kGround) return;
  const BodyState& drawn = model.initial(0);
  const Eigen::Vector3d r = state.q.head<3>();
  const Eigen::Matrix3d R = rotation_matrix(drawn.L) * rotation_matrix(state.q.segment<4>(3)).transpose();
  const Eigen::Quaterniond turn(R);
  for (std::size_t i = 0; i < layout.body_q.size(); ++i) {
    const int q = layout.body_q[i];
    const Eigen::Vector3d moved = drawn.r + R * (state.q.segment<3>(q) - r);
    const Eigen::Vector4d L = state.q.segment<4>(q + 3);
    const Eigen::Quaterniond turned = turn * Eigen::Quaterniond(L(0), L(1), L(2), L(3));
    state.q.segment<3>(q) = moved;
    state.q.segment<4>(q + 3) << turned.w(), turned.x(), turned.y(), turned.z();
  }
}

}  // namespace

void move_to_start(const Model& model, const std::vector<StartCoordinate>& start, State& state) {
  const Model on_the_way = model_on_the_way(model, start);
  const Layout layout(on_the_way), all(model);
  ConstraintRows rows(on_the_way, layout);
  UnbentClosing unbent(on_the_way, layout);
  Eigen::VectorXd z = state.z;
  state.z = Eigen::VectorXd::Zero(layout.z_size);
  double longest = 0.0;
  for (const StartCoordinate& given : start) longest = std::max(longest, std::abs(given.value));
  const int steps = 1 + static_cast<int>(longest / kStartStep);
  for (int k = 1; k <= steps; ++k) {
    state.time = static_cast<double>(k) / steps;
    unbent.close(state);
    rows.evaluate(state);
    close_joints(on_the_way, layout, rows, state);
    check_contradiction(on_the_way, layout, rows.phi, 1.0,
                        "on the way to the coordinates of [initial.joints] they do not close; they stay open",
                        "m or rad");
  }
  state.time = 0.0;
  for (std::size_t j = 0; j < all.joint_turns.size(); ++j)
    if (all.joint_turns[j] >= 0) z[all.joint_turns[j]] = state.z[layout.joint_turns[j]];
  state.z = std::move(z);
  put_back_first_body(model, layout, state);
}

}  // namespace footfall
