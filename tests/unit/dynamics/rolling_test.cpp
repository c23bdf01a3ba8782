// mbd_solver/model/joints/rolling.h: rolling without slip against closed forms: down a slope, on a turntable, and a coin that
// rolls in a circle.

#include "mbd_solver/model/joints/rolling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/pi.h"
#include "mbd_solver/model/rotation.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

constexpr double kRollingTolerance = 1e-8;  // rtol of the runs is 1e-11, over some hundred steps
constexpr double kG = 9.81;                 // [m/s2]

// Multipliers of the three rows of joint 0 turned into the force on the wheel, in the axes of the plane.
Eigen::Vector3d force_on_wheel(test::Run& run, int joint = 0) {
  Eigen::VectorXd rates(run.equations.layout().size());
  run.equations.accelerations(run.state, run.inputs, rates);
  const Layout& layout = run.equations.layout();
  return -rates.segment<3>(layout.lambda0() + layout.joint_row[static_cast<std::size_t>(joint)]);
}

class Rolls : public ::testing::TestWithParam<std::string> {};

// On a slope of angle a: g sin(a) / (1 + I / (m R^2)), friction m g sin(a) (I / (m R^2)) / (1 + I / (m R^2)).
TEST_P(Rolls, DownASlope) {
  const double m = 3.0, R = 0.2, a = 20.0 * kPi / 180.0, t = 1.5;
  for (const bool disc : {true, false}) {
    const double share = disc ? 0.5 : 0.4;
    Model model(kG * Eigen::Vector3d(std::sin(a), 0.0, -std::cos(a)));
    BodyState state;
    state.r.z() = R;
    const double I = share * m * R * R;
    // axis of the wheel: y
    model.add_body(Body("wheel", m, Eigen::Vector3d(disc ? 0.5 * I : I, I, disc ? 0.5 * I : I).asDiagonal()), state);
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    if (disc) axes << 1, 0, 0, 0, 0, 1, 0, -1, 0;  // columns x, -z, y
    model.add_joint(
        rolling_joint("rolling", ground_marker(Eigen::Vector3d::Zero()), model.marker_at(0, state.r, axes), R, disc));
    test::Run run(model, GetParam(), test::precise(1e-11));
    run.to(t, 3);
    const double acc = kG * std::sin(a) / (1.0 + share);
    EXPECT_NEAR(run.body(0).dr.x(), acc * t, kRollingTolerance * acc * t) << disc;
    EXPECT_NEAR(run.body(0).r.x(), 0.5 * acc * t * t, kRollingTolerance * acc * t * t) << disc;
    EXPECT_NEAR(run.body(0).w.y(), acc * t / R, kRollingTolerance * acc * t / R) << disc;
    const Eigen::Vector3d force = force_on_wheel(run);
    EXPECT_NEAR(force.x(), -share * m * acc, kRollingTolerance * m * kG) << disc;
    EXPECT_NEAR(force.y(), 0.0, kRollingTolerance * m * kG) << disc;
    EXPECT_NEAR(force.z(), m * kG * std::cos(a), kRollingTolerance * m * kG) << disc;
    EXPECT_NEAR(run.imbalance(), 0.0, kRollingTolerance * m * kG) << disc;
  }
}

// A coin leans by a constant angle and its centre moves in a circle, Omega about the vertical. With A and C about a
// diameter and the axis, alpha between axis and vertical, s = sin, c = cos of it, the moment of momentum about the centre
// gives the spin  sigma = (A Omega^2 c s - m g R c) / (Omega s (C + m R^2)),  and the centre moves at R sigma on a circle of
// radius R sigma / Omega. The force is m (g n + R sigma Omega k), k the horizontal direction of the axis.
TEST_P(Rolls, CoinInACircle) {
  const double m = 0.7, R = 0.3, A = 0.25 * m * R * R, C = 2.0 * A, alpha = 65.0 * kPi / 180.0, Omega = 3.0;
  const double s = std::sin(alpha), c = std::cos(alpha);
  const double sigma = (A * Omega * Omega * c * s - m * kG * R * c) / (Omega * s * (C + m * R * R));
  const Eigen::Vector3d n(0, 0, 1), axis(s, 0, c), h(0, 1, 0);  // h = n x axis / s
  BodyState state;
  state.r = Eigen::Vector3d(0.0, 0.0, R * s);
  state.L << std::cos(0.5 * alpha), 0.0, std::sin(0.5 * alpha), 0.0;  // z of the body along the axis
  state.w = Omega * (n - c * axis) + sigma * axis;
  state.dr = -R * sigma * h;
  Model model(-kG * n);
  model.add_body(Body("coin", m, Eigen::Vector3d(A, A, C).asDiagonal()), state);
  model.add_joint(rolling_joint("rolling", ground_marker(Eigen::Vector3d::Zero()),
                                body_marker(0, model.body(0), Eigen::Vector3d::Zero()), R, true));
  test::Run run(model, GetParam(), test::precise(1e-11));
  EXPECT_TRUE(run.assembly.notes.empty());  // these speeds fit
  const double radius = R * sigma / Omega;  // c'' = R sigma Omega k: the centre of the circle lies along k
  const Eigen::Vector3d centre = state.r + radius * Eigen::Vector3d::UnitX();
  for (int i = 1; i <= 8; ++i) {
    run.to(0.5 * i);
    const BodyKinematics coin = run.body(0);
    const double phi = Omega * run.state.time;
    const Eigen::Vector3d k(std::cos(phi), std::sin(phi), 0.0);
    EXPECT_LT((coin.A.col(2) - (s * k + c * n)).norm(), 1e-6) << run.state.time;
    EXPECT_LT((coin.r - (centre - radius * k)).norm(), 1e-6) << run.state.time;
    EXPECT_LT((force_on_wheel(run) - m * (kG * n + R * sigma * Omega * k)).norm(), 1e-5) << run.state.time;
    EXPECT_NEAR(run.imbalance(), 0.0, kRollingTolerance * m * kG);
  }
}

// A ball on a turntable: its centre moves in a circle with I / (I + m R^2) times the speed of the table (Earnshaw 1844), 2/7
// of it for a solid ball.
TEST_P(Rolls, BallOnATurntable) {
  const double m = 0.2, R = 0.05, Omega = 7.0, t = 4.0;
  Model model(-kG * Eigen::Vector3d::UnitZ());
  BodyState table, ball;
  table.w.z() = Omega;
  ball.r = Eigen::Vector3d(0.4, 0.0, R);
  ball.dr = Eigen::Vector3d(0.3, 0.1, 0.0);
  // velocity of the touching point is that of the table: w x (-R n) = Omega x r - dr
  const Eigen::Vector3d slip = Omega * Eigen::Vector3d::UnitZ().cross(ball.r) - ball.dr;
  ball.w = Eigen::Vector3d(slip.y() / R, -slip.x() / R, 1.5);
  model.add_body(Body("table", 5.0, Eigen::Matrix3d::Identity()), table);
  model.add_body(Body("ball", m, 0.4 * m * R * R * Eigen::Matrix3d::Identity()), ball);
  PrescribedMotion turning;
  turning.translation = {polynomial({0.0}), polynomial({0.0}), polynomial({0.0})};
  turning.rotation = polynomial({0.0, Omega});
  turning.hold_other_rotations = true;
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  model.add_joint(rolling_joint("rolling", model.marker_at(0, origin), model.marker_at(1, ball.r), R, false));
  model.add_joint(prescribed_joint("motor", ground_marker(origin), model.marker_at(0, origin), turning));
  test::Run run(model, GetParam(), test::precise(1e-11));
  EXPECT_TRUE(run.assembly.notes.empty());
  run.to(t, 8);
  const double orbit = 2.0 / 7.0 * Omega;
  // r'' = orbit z x r':  r = centre + [v / orbit turned by -90 degrees]
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ(), v = ball.dr;
  const Eigen::Vector3d centre = ball.r + z.cross(v) / orbit;
  const Eigen::Vector3d turned = Eigen::AngleAxisd(orbit * t, z) * Eigen::Vector3d(ball.r - centre);
  EXPECT_LT((run.body(1).r - (centre + turned)).norm(), 1e-7);
  EXPECT_NEAR(run.body(1).w.z(), 1.5, 1e-7);
  EXPECT_NEAR(run.imbalance(), 0.0, kRollingTolerance * m * kG);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Rolls, ::testing::Values("one_step", "ida"));

// A wheel that slides at the start.
TEST(Rolling, StartIsMadeToRoll) {
  Model model(-kG * Eigen::Vector3d::UnitZ());
  BodyState state;
  state.r.z() = 0.1;
  state.dr = Eigen::Vector3d(2.0, 0.0, 0.0);  // slides, does not turn
  const double m = 1.0, I = 0.005;            // disc: I = m R^2 / 2
  model.add_body(Body("wheel", m, Eigen::Vector3d(0.5 * I, I, 0.5 * I).asDiagonal()), state);
  Eigen::Matrix3d axes;
  axes << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  model.add_joint(
      rolling_joint("rolling", ground_marker(Eigen::Vector3d::Zero()), model.marker_at(0, state.r, axes), 0.1, true));
  const Assembly assembly = assemble(model);
  ASSERT_EQ(assembly.notes.size(), 1u);  // the smallest change in the metric of the masses: an impact along the ground
  EXPECT_NEAR(assembly.state.v[0], 2.0 * m / (m + I / 0.01), 1e-12);
  EXPECT_NEAR(assembly.state.v[4], assembly.state.v[0] / 0.1, 1e-12);
}

}  // namespace
}  // namespace footfall
