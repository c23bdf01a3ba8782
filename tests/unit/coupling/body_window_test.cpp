// The windows of one body, with every scheme: what is sent, felt, and left over.

#include "mbd_solver/coupling/body_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "coupler/schemes/registry.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

constexpr int kSubsteps = 10;
constexpr double kDt = 1e-3;        // [s]
constexpr double kStiffness = 1e5;  // of the contacts [N/m]

class EveryScheme : public testing::TestWithParam<std::string> {
 protected:
  EveryScheme() : computed(random.motion(0)), window(*scheme, body, computed) {
    answer.mean.F_W = 100.0 * random.vector();
    answer.mean.T_B = random.vector();
    answer.contact_stiffness = kStiffness;
    if (scheme->wants_tangent()) answer.tangent.emplace_back().K.diagonal().head<3>().setConstant(kStiffness);
  }
  const std::unique_ptr<Scheme> scheme = make_scheme(GetParam());
  const Body body{"ball", 10.0, Eigen::Vector3d(0.1, 0.2, 0.3).asDiagonal()};
  test::Random random{41};
  BodyMotion computed;
  BodyWindow window;
  BodyLoad answer;
  ExternalLoad felt;
};
std::string test_name(const testing::TestParamInfo<std::string>& scheme) {
  std::string name = scheme.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(BodyWindow, EveryScheme, testing::ValuesIn(scheme_names()), test_name);

TEST_P(EveryScheme, SendsThePlaceAsComputed) {
  window.begin(kSubsteps, kDt, computed);
  window.answer(answer, felt);
  BodyMotion sent = random.motion(0);
  const BodyMotion next = sent;
  window.begin(kSubsteps, kDt, sent);
  EXPECT_EQ(sent.r, next.r);
  EXPECT_EQ(sent.L, next.L);
  EXPECT_EQ(sent.ddr, next.ddr);
  EXPECT_EQ(sent.dw, next.dw);
}

// Two routes: the path that the grains' side walks with what was sent, and the one known here.
TEST_P(EveryScheme, KnowsWhereTheGrainsSideLeavesTheBoundary) {
  BoundaryPath grains_side(*scheme, computed);
  for (int k = 0; k < 2; ++k) {
    BodyMotion sent = computed;
    window.begin(kSubsteps, kDt, sent);
    grains_side.begin_window(sent, kSubsteps, kDt);
    for (int i = 0; i < kSubsteps; ++i) grains_side.advance();
    EXPECT_EQ(window.path().r_end, grains_side.pose().r);
    EXPECT_EQ(window.path().L_end, grains_side.pose().L);
    EXPECT_EQ(window.pending_work(grains_side.pose()), 0.0);
    window.answer(answer, felt);
    computed.r += 0.01 * random.vector();
  }
}

TEST_P(EveryScheme, FeelsTheMeanOfTheGrainsAndReactsAroundThePredictedPath) {
  window.begin(kSubsteps, kDt, computed);
  window.answer(answer, felt);
  EXPECT_EQ(felt.F_W, answer.mean.F_W);
  EXPECT_EQ(felt.T_B, answer.mean.T_B);
  ASSERT_EQ(felt.tangent.has_value(), scheme->wants_tangent());
  EXPECT_EQ(window.surplus_impulse(computed).has_value(), scheme->wants_tangent());
  if (!felt.tangent) return;
  EXPECT_EQ(felt.tangent->K, answer.tangent.front().K);
  EXPECT_EQ(felt.tangent->r_mean, window.path().r_mean);
  EXPECT_EQ(felt.tangent->v_mean, window.path().v_mean);
}

// Means stand for the windows' middles: after one of length 2 and one of length 1 the force is followed by 1/3 of its
// change to the end. A scheme with slopes follows them instead (zero here).
TEST_P(EveryScheme, FollowsTheForceToTheEndOfItsWindow) {
  BodyMotion sent = computed;
  window.begin(2 * kSubsteps, kDt, sent);
  answer.mean = MeanLoad();
  answer.mean.F_W.z() = 300.0;
  window.answer(answer, felt);
  sent = computed;
  window.begin(kSubsteps, kDt, sent);
  answer.mean.F_W.z() = 600.0;
  if (scheme->wants_tangent()) answer.tangent.front() = {};
  window.answer(answer, felt);
  BodyMotion end;
  end.r = window.path().r_end + Eigen::Vector3d(0.0, 0.0, 1e-3);
  end.L = window.path().L_end;
  const double at_end = scheme->wants_tangent() ? 600.0 : 700.0;  // [N]
  EXPECT_NEAR(window.pending_work(end), 1e-3 * at_end, 1e-10);    // round-off of r
}

// Two masses of 1 kg, 1 m apart, on a spring: one mode of Omega [rad/s].
std::shared_ptr<const ModalBody> dumbbell(double Omega) {
  auto body = std::make_shared<ModalBody>();
  body->name = "dumbbell";
  body->rho0.resize(3, 2);
  body->rho0 << 0.0, 0.0, 0.0, 0.0, -0.5, 0.5;
  body->node_mass = Eigen::Vector2d::Ones();
  body->node_inertia.assign(2, 0.1 * Eigen::Matrix3d::Identity());
  body->Phi = Eigen::MatrixXd::Zero(6, 1);
  body->Phi(2, 0) = -std::sqrt(0.5);
  body->Phi(5, 0) = std::sqrt(0.5);
  body->Psi = Eigen::MatrixXd::Zero(6, 1);
  body->stiffness = Eigen::VectorXd::Constant(1, Omega * Omega);
  body->damping = Eigen::VectorXd::Zero(1);
  return body;
}

// theta = Omega H = 10: da_path = 2 da (1 - cos theta)/theta^2, with weight theta^4/(1 + theta^4), is below 5 % of da.
TEST_P(EveryScheme, SlowsDownModesThatSwingWithinTheWindow) {
  const double H = kSubsteps * kDt;
  const Body flexible("dumbbell", dumbbell(10.0 / H));
  BodyMotion sent(1);
  BodyWindow windows(*scheme, flexible, sent);
  sent.da[0] = 1.0;
  windows.begin(kSubsteps, kDt, sent);
  EXPECT_LT(std::abs(sent.da[0]), 0.05);
}

}  // namespace
}  // namespace footfall
