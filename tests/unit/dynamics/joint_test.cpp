// mbd_solver/model/joints/joint.h:
// every condition of every joint: value, rate, acceleration and Jacobian row against differences along a
// random motion.

#include "mbd_solver/dynamics/kinematics.h"
#include "tests/unit/dynamics/random_model.h"

namespace footfall {
namespace {

struct Motion {
  Eigen::VectorXd q, v, dv;
};

// Where the motion stands a time dt later: q to third order along v and dv (constant dv), so central
// differences see phi'' exactly to second order in dt.
Motion later(const Layout& layout, const Motion& at, double dt) {
  Motion out = at;
  out.v += dt * at.dv;
  // Two Gauss points of the rate make the increment of q fourth-order accurate.
  for (std::size_t i = 0; i < layout.body_q.size(); ++i) {
    const int q = layout.body_q[i];
    Eigen::Vector4d L = at.q.segment<4>(q + 3);
    const Eigen::Vector3d w0 = at.v.segment<3>(layout.body_v[i] + 3), dw = at.dv.segment<3>(layout.body_v[i] + 3);
    const auto rate = [&](const Eigen::Vector4d& x, double s) { return quaternion_rate(x, w0 + s * dw); };
    const Eigen::Vector4d k1 = rate(L, 0.0), k2 = rate(L + 0.5 * dt * k1, 0.5 * dt),
                          k3 = rate(L + 0.5 * dt * k2, 0.5 * dt), k4 = rate(L + dt * k3, dt);
    L += dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    const Eigen::VectorXd dx = dt * at.v + 0.5 * dt * dt * at.dv;
    const int end = i + 1 < layout.body_q.size() ? layout.body_v[i + 1] : layout.v_size;
    out.q.segment<3>(q) += dx.segment<3>(layout.body_v[i]);
    out.q.segment<4>(q + 3) = L;
    out.q.segment(q + 7, end - layout.body_v[i] - 6) += dx.segment(layout.body_v[i] + 6, end - layout.body_v[i] - 6);
  }
  return out;
}

class EveryJoint : public ::testing::TestWithParam<std::pair<int, int>> {
 protected:
  EveryJoint()
      : random_(17),
        model_(test::random_bodies(random_)),
        joints_(test::all_joints(random_, model_, GetParam().first, GetParam().second)) {
    for (const Joint& joint : joints_) model_.add_joint(joint);
    const Assembly given = test::as_given(model_);
    layout_ = std::make_unique<Layout>(model_);
    at_ = {given.state.q, given.state.v, random_.vector_x(layout_->v_size, 3.0)};
  }
  // phi, phi', phi'' of one condition.
  RowValue value(const Joint& joint, const ConstraintRow& row, double t, const Motion& at,
                 Eigen::VectorXd* phi_v = nullptr) {
    Kinematics kinematics(model_);
    kinematics.load(*layout_, at.q, at.v, at.dv);
    const PairMotion pair = kinematics.pair(joint.m1.body, joint.m2.body);
    Eigen::VectorXd local(pair.size());
    MarkerVectors vectors(pair, joint.m1, joint.m2);
    const RowValue out = evaluate_row(row, t, vectors, local);
    if (phi_v != nullptr) *phi_v = local;
    return out;
  }
  test::Random random_;
  Model model_;
  std::vector<Joint> joints_;
  std::unique_ptr<Layout> layout_;
  Motion at_;
};

TEST_P(EveryJoint, RatesAreTimeDerivatives) {
  // truncation dt^2 = 1e-10, round-off 1e-16 / dt = 1e-11, times derivatives of some hundred
  const double t = 0.4, dt = 1e-5;
  const double tolerance = 1e-7;
  for (const Joint& joint : joints_) {
    for (const ConstraintRow& row : joint.rows) {
      const RowValue now = value(joint, row, t, at_);
      const RowValue next = value(joint, row, t + dt, later(*layout_, at_, dt));
      const RowValue last = value(joint, row, t - dt, later(*layout_, at_, -dt));
      if (row.holds_positions()) {
        EXPECT_NEAR(now.rate, (next.phi - last.phi) / (2.0 * dt), tolerance) << joint.name;
      }
      EXPECT_NEAR(now.acc, (next.rate - last.rate) / (2.0 * dt), tolerance) << joint.name;
    }
  }
}

TEST_P(EveryJoint, JacobianRowIsTheRatePerVelocity) {
  for (const Joint& joint : joints_) {
    for (const ConstraintRow& row : joint.rows) {
      Eigen::VectorXd phi_v;
      const RowValue now = value(joint, row, 0.4, at_, &phi_v);
      double rate = now.phi_t;
      int offset = 0;
      for (int body : {joint.m1.body, joint.m2.body}) {
        if (body == kGround) continue;
        const int n = 6 + model_.body(body).mode_count();
        rate += phi_v.segment(offset, n).dot(at_.v.segment(layout_->body_v[static_cast<std::size_t>(body)], n));
        offset += n;
      }
      EXPECT_NEAR(rate, now.rate, 1e-13 * (1.0 + std::abs(rate))) << joint.name;  // two ways to the same sum: round-off
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, EveryJoint,
                         ::testing::Values(std::make_pair(0, 2), std::make_pair(0, 1), std::make_pair(1, 3),
                                           std::make_pair(kGround, 1), std::make_pair(3, kGround),
                                           std::make_pair(kGround, 0)));

TEST(Joint, LeavesTheFreedomOfItsKind) {
  test::Random random(3);
  const Model model = test::random_bodies(random);
  const std::vector<Joint> joints = test::all_joints(random, model, 0, 2);
  const std::vector<std::size_t> rows = {6, 3, 4, 5, 5, 4, 1, 1, 3, 4, 3, 5};
  ASSERT_EQ(joints.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(joints[i].rows.size(), rows[i]) << joints[i].kind;
}

}  // namespace
}  // namespace footfall
