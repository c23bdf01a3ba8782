#include "mbd_solver/dynamics/joint_closing.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/joints/whole_turns.h"

namespace footfall {
namespace {

constexpr int kMostClosingSteps = 30;
constexpr double kAssembled = 1e-12;  // [m or rad]: what double precision reaches for mechanisms of metres
// While the joints are still open by a gap g, redundant conditions look independent to about g: they must not
// steer the closing.
constexpr double kClosingRank = 1e-5;

// The angles of gears (state.z) as they are; with dx, as they will be after this step of the bodies.
void follow_turns(const Model& model, const Layout& layout, const Kinematics& kinematics, const Eigen::VectorXd* dx,
                  State& state) {
  for (int j = 0; j < model.joint_count(); ++j) {
    const int z = layout.joint_turns[static_cast<std::size_t>(j)];
    if (z < 0) continue;
    const Joint& joint = model.joint(j);
    const PairMotion pair = kinematics.pair(joint.m1.body, joint.m2.body);
    const JointCoordinate q(Coordinate::kAngle, pair, joint.m1, joint.m2);
    state.z[z] = nearest_turn(q.value(), state.z[z]);
    if (dx == nullptr) continue;
    Eigen::VectorXd q_x = Eigen::VectorXd::Zero(pair.size());
    q.add_gradient(1.0, q_x);
    const int bodies[2] = {joint.m1.body, joint.m2.body};
    for (int i = 0; i < 2; ++i) {
      const int n = pair.body[i]->size();
      if (n > 0)
        state.z[z] +=
            q_x.segment(pair.offset(i), n).dot(dx->segment(layout.body_v[static_cast<std::size_t>(bodies[i])], n));
    }
  }
}

}  // namespace

void close_joints(const Model& model, const Layout& layout, ConstraintRows& rows, State& state) {
  double last = HUGE_VAL;
  for (int i = 0; i < kMostClosingSteps; ++i) {
    const double now = rows.phi.lpNorm<Eigen::Infinity>();
    if (now <= 1e-15 || (now <= kAssembled && now >= 0.5 * last)) break;
    last = now;
    const Eigen::VectorXd dx = rows.correction(rows.phi, kClosingRank);
    follow_turns(model, layout, rows.kinematics(), &dx, state);
    add_increment(layout, dx, state.q);
    rows.evaluate(state);
  }
  follow_turns(model, layout, rows.kinematics(), nullptr, state);
}

void check_contradiction(const Model& model, const Layout& layout, const Eigen::VectorXd& defect, double scale,
                         const std::string& what, const std::string& unit) {
  const double largest = defect.lpNorm<Eigen::Infinity>();
  if (largest <= kContradiction * scale) return;
  std::vector<int> worst;
  for (int row = 0; row < defect.size(); ++row) {
    const int joint = layout.row_joint[static_cast<std::size_t>(row)];
    if (std::abs(defect[row]) > 0.1 * largest && (worst.empty() || worst.back() != joint)) worst.push_back(joint);
  }
  throw InputError("joints " + joint_names(model, worst) + " contradict each other: " + what + " by " +
                   number_text(largest, 3) + " " + unit + ". Move one of them, or free one of its directions.");
}

std::string joint_names(const Model& model, const std::vector<int>& joints) {
  std::string out;
  for (int joint : joints) out += (out.empty() ? "\"" : ", \"") + model.joint(joint).name + "\"";
  return out;
}

}  // namespace footfall
