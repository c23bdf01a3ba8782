// Gears and rolling.
#include <gtest/gtest.h>

#include <cmath>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/gear.h"
#include "mbd_solver/model/elements/joint_coordinate.h"
#include "mbd_solver/model/elements/rolling.h"
#include "tests/support/refused.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

// mbd_solver/model/elements/gear.h: gears, racks and differentials against their equations of motion in one coordinate.

constexpr double kGearTolerance = 1e-8;  // rtol of the runs is 1e-11, over some hundred steps

const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

// A body that turns about z, or slides along it, at a place of its own.
int add_moving(Model& model, const std::string& name, double inertia, Coordinate kind, int base = kGround,
               double mass = 1.0) {
  BodyState state;
  state.r = Eigen::Vector3d(model.body_count(), 0.5, 0.0);
  const double m = kind == Coordinate::kAngle ? mass : inertia;
  const int body = model.add_body(Body(name, m, inertia * Eigen::Matrix3d::Identity()), state);
  const Marker m1 = model.marker_at(base, state.r), m2 = model.marker_at(body, state.r);
  return model.add_joint(kind == Coordinate::kAngle ? revolute_joint(name, m1, m2) : prismatic_joint(name, m1, m2));
}

// A constant torque about z, or force along it.
void push(Model& model, int body, Coordinate kind, double size) {
  const Marker centre = body_marker(body, model.body(body), Eigen::Vector3d::Zero());
  const TimeFunctionPtr on = polynomial({size}), off = polynomial({0.0});
  const bool turns = kind == Coordinate::kAngle;
  model.add_force(
      std::make_unique<AppliedForce>("push_" + std::to_string(body), centre, kZ, turns ? off : on, turns ? on : off));
}

double q_rate(test::Run& run, int body, Coordinate kind) {
  return kind == Coordinate::kAngle ? run.body(body).w.z() : run.body(body).dr.z();
}

// What the gear brings on its first coordinate.
double reaction(test::Run& run, int joint) {
  Eigen::VectorXd rates(run.equations.layout().size());
  run.equations.saddle().accelerations(run.state, run.inputs, rates);
  const Layout& layout = run.equations.layout();
  return -rates[layout.lambda0() + layout.joint_row[static_cast<std::size_t>(joint)]];
}

class Gears : public ::testing::TestWithParam<std::pair<std::string, Baumgarte>> {};

// Teeth n1 and n2 outside of each other, torque T on the first: q1'' (I1 + I2 (n1/n2)^2) = T, for 28 turns.
TEST_P(Gears, PairTurnsAsItsInertias) {
  const double I1 = 0.02, I2 = 0.7, n1 = 17.0, n2 = 53.0, T = 0.4, t = 9.0;
  Model model;
  add_moving(model, "pinion", I1, Coordinate::kAngle);
  add_moving(model, "wheel", I2, Coordinate::kAngle);
  const int gear = add_gear(model, "mesh", {{0, Coordinate::kAngle, n1}, {1, Coordinate::kAngle, n2}});
  push(model, 0, Coordinate::kAngle, T);
  test::Run run(model, GetParam().first, test::precise(1e-11), GetParam().second);
  const double ratio = n1 / n2, acc = T / (I1 + I2 * ratio * ratio);
  for (int i = 1; i <= 3; ++i) {
    run.to(t * i / 3.0, 3);
    const double speed = acc * run.state.time;
    EXPECT_NEAR(q_rate(run, 0, Coordinate::kAngle), speed, kGearTolerance * speed);
    EXPECT_NEAR(q_rate(run, 1, Coordinate::kAngle), -ratio * speed, kGearTolerance * speed);
    EXPECT_NEAR(reaction(run, gear), I1 * acc - T, kGearTolerance * T);
    const Drift drift = run.equations.saddle().drift(run.state);
    EXPECT_LT(drift.position, 1e-7);  // phi over many turns; Baumgarte's terms leave some of it
    EXPECT_NEAR(run.imbalance(), 0.0, kGearTolerance * run.energy().stored.total());
  }
  const Layout& layout = run.equations.layout();
  const double turned = run.state.z[layout.joint_turns[static_cast<std::size_t>(gear)]];
  EXPECT_GT(turned, 25.0 * 2.0 * kPi);
  EXPECT_NEAR(turned, 0.5 * acc * t * t, 1e-6 * turned);
}

// A pinion of radius r under a torque T lifts a rack of mass m: (I + m r^2) q'' = T - m g r. The tooth force is m (g + r q'').
TEST_P(Gears, RackLiftsAMass) {
  const double I = 0.03, r = 0.05, m = 4.0, g = 9.81, T = 3.0, t = 2.0;
  Model model(Eigen::Vector3d(0.0, 0.0, -g));
  add_moving(model, "pinion", I, Coordinate::kAngle);
  add_moving(model, "rack", m, Coordinate::kDisplacement);
  const int gear = add_gear(model, "mesh", {{1, Coordinate::kDisplacement, -1.0}, {0, Coordinate::kAngle, r}});
  push(model, 0, Coordinate::kAngle, T);
  test::Run run(model, GetParam().first, test::precise(1e-11), GetParam().second);
  run.to(t, 2);
  const double acc = (T - m * g * r) / (I + m * r * r);
  EXPECT_NEAR(q_rate(run, 0, Coordinate::kAngle), acc * t, kGearTolerance * acc * t);
  EXPECT_NEAR(run.body(1).r.z(), 0.5 * r * acc * t * t, kGearTolerance * r * acc * t * t);
  EXPECT_NEAR(reaction(run, gear), m * (g + r * acc), kGearTolerance * m * g);
  EXPECT_NEAR(run.imbalance(), 0.0, kGearTolerance * run.energy().stored.total());
}

// q1 + q2 = 2 q3:  I_i q_i'' = T_i - lambda f_i,  lambda = sum f_i T_i / I_i / sum f_i^2 / I_i
TEST_P(Gears, DifferentialSharesTorques) {
  const double I[3] = {0.1, 0.25, 0.4}, f[3] = {1.0, 1.0, -2.0}, T[3] = {0.3, -0.1, 0.5}, t = 6.0;
  Model model;
  double top = 0.0, bottom = 0.0;
  for (int i = 0; i < 3; ++i) {
    add_moving(model, "shaft_" + std::to_string(i), I[i], Coordinate::kAngle);
    push(model, i, Coordinate::kAngle, T[i]);
    top += f[i] * T[i] / I[i];
    bottom += f[i] * f[i] / I[i];
  }
  const int gear =
      add_gear(model, "differential",
               {{0, Coordinate::kAngle, f[0]}, {1, Coordinate::kAngle, f[1]}, {2, Coordinate::kAngle, f[2]}});
  test::Run run(model, GetParam().first, test::precise(1e-11), GetParam().second);
  run.to(t, 4);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(q_rate(run, i, Coordinate::kAngle), (T[i] - top / bottom * f[i]) / I[i] * t, kGearTolerance * 30.0);
  EXPECT_NEAR(reaction(run, gear), -top / bottom, kGearTolerance);
  EXPECT_NEAR(run.imbalance(), 0.0, kGearTolerance * run.energy().stored.total());
}

// A shaft with the inertia I under a torque T lifts a mass m by e (1 - cos q), in its own equation
//   (I + m y'^2) q'' + m y' y'' q'^2 = T - m g y'
// over several turns; the spline through 96 points is off by less than 1e-7 of the lift.
TEST_P(Gears, CamLiftsAMass) {
  const double I = 0.05, m = 3.0, g = 9.81, T = 0.8, e = 0.02, t = 3.0;
  std::vector<double> angle, lift;
  for (int i = 0; i <= 96; ++i) {
    angle.push_back(2.0 * kPi * i / 96.0);
    lift.push_back(i == 96 ? 0.0 : e * (1.0 - std::cos(angle.back())));
  }
  Model model(Eigen::Vector3d(0.0, 0.0, -g));
  add_moving(model, "shaft", I, Coordinate::kAngle);
  add_moving(model, "rod", m, Coordinate::kDisplacement);
  const auto curve = std::make_shared<CubicSpline>("lift", angle, lift, CubicSpline::Ends::kClosed);
  const int cam = add_gear(model, "cam", {{1, Coordinate::kDisplacement, 1.0}, {0, Coordinate::kAngle, -1.0, curve}});
  push(model, 0, Coordinate::kAngle, T);
  test::Run run(model, GetParam().first, test::precise(1e-11), GetParam().second);

  const auto acc = [&](double q, double dq) {
    const double slope = e * std::sin(q), bend = e * std::cos(q);
    return (T - m * g * slope - m * slope * bend * dq * dq) / (I + m * slope * slope);
  };
  double q = 0.0, dq = 0.0;
  const int steps = 30000;
  const double h = t / steps;
  for (int i = 0; i < steps; ++i) {  // Runge and Kutta's fourth order
    const double k1 = acc(q, dq), k2 = acc(q + 0.5 * h * dq, dq + 0.5 * h * k1);
    const double k3 = acc(q + 0.5 * h * dq + 0.25 * h * h * k1, dq + 0.5 * h * k2);
    const double k4 = acc(q + h * dq + 0.5 * h * h * k2, dq + h * k3);
    q += h * dq + h * h * (k1 + k2 + k3) / 6.0;
    dq += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
  }
  ASSERT_GT(q, 4.0 * 2.0 * kPi);
  run.to(t, 3);
  EXPECT_NEAR(q_rate(run, 0, Coordinate::kAngle), dq, 1e-6 * dq);
  EXPECT_NEAR(q_rate(run, 1, Coordinate::kDisplacement), e * std::sin(q) * dq, 1e-5 * e * dq);
  EXPECT_NEAR(reaction(run, cam), m * (g + e * (std::cos(q) * dq * dq + std::sin(q) * acc(q, dq))), 1e-4 * m * g);
  EXPECT_LT(run.equations.saddle().drift(run.state).position, 1e-7);
  // The third derivative of the curve jumps 96 times in a turn, over which methods of high order do not step so well.
  EXPECT_NEAR(run.imbalance(), 0.0, 10.0 * kGearTolerance * run.energy().stored.total());
}

INSTANTIATE_TEST_SUITE_P(Integrators, Gears,
                         ::testing::Values(std::pair("one_step", Baumgarte{}),
                                           std::pair("one_step", Baumgarte{20.0, 20.0}), std::pair("ida", Baumgarte{})),
                         [](const auto& with) {
                           return with.param.first + (with.param.second.alpha > 0.0 ? "_baumgarte" : "");
                         });

// Two gears in a row, ten and four times as fast: the last wheel starts at 80 rad, far beyond a turn.
TEST(GearStart, OtherWheelsFollowOverManyTurns) {
  Model model;
  for (const char* name : {"first", "second", "third"}) add_moving(model, name, 0.1, Coordinate::kAngle);
  const int one = add_gear(model, "one", {{0, Coordinate::kAngle, 10.0}, {1, Coordinate::kAngle, 1.0}});
  const int two = add_gear(model, "two", {{1, Coordinate::kAngle, -4.0}, {2, Coordinate::kAngle, -1.0}});
  AssemblyOptions options;
  options.start = {{0, Coordinate::kAngle, 2.0}};
  const Assembly assembly = assemble(model, options);
  const Layout layout(model);
  const auto angle = [&](int joint) { return assembly.state.z[layout.joint_turns[static_cast<std::size_t>(joint)]]; };
  EXPECT_NEAR(angle(one), 2.0, 1e-9);
  EXPECT_NEAR(angle(one + 1), -20.0, 1e-9);
  EXPECT_NEAR(angle(two + 1), 80.0, 1e-9);
  Equations equations(model, assembly);
  EXPECT_LT(equations.saddle().drift(assembly.state).position, 1e-9);
}

// Wheels that turn towards each other at speeds that do not fit: the smallest change makes them fit, and a note tells.
TEST(GearStart, SpeedsAreMadeToFit) {
  Model model;
  const double I[2] = {0.1, 0.3}, w = 5.0;
  for (int i = 0; i < 2; ++i) {
    BodyState state;
    state.r = Eigen::Vector3d(i, 0.0, 0.0);
    state.w = i == 0 ? Eigen::Vector3d(w * kZ) : Eigen::Vector3d::Zero();
    model.add_body(Body("wheel_" + std::to_string(i), 1.0, I[i] * Eigen::Matrix3d::Identity()), state);
    model.add_joint(
        revolute_joint("axle_" + std::to_string(i), model.marker_at(kGround, state.r), model.marker_at(i, state.r)));
  }
  add_gear(model, "mesh", {{0, Coordinate::kAngle, 1.0}, {1, Coordinate::kAngle, 1.0}});
  const Assembly assembly = assemble(model);
  ASSERT_EQ(assembly.notes.size(), 1u);
  EXPECT_TRUE(test::names(assembly.notes[0], {"mesh"}));
  // An impact: I0 (w0' - w) = I1 w1' with w1' = -w0'
  EXPECT_NEAR(assembly.state.v[5], I[0] * w / (I[0] + I[1]), 1e-12);
  EXPECT_NEAR(assembly.state.v[11], -I[0] * w / (I[0] + I[1]), 1e-12);
}

// A gear that says again what another one says is redundant, not contradictory.
TEST(GearStart, GearTwiceIsRedundant) {
  Model model;
  for (const char* name : {"first", "second"}) add_moving(model, name, 0.1, Coordinate::kAngle);
  for (const char* name : {"mesh", "again"})
    add_gear(model, name, {{0, Coordinate::kAngle, 1.0}, {1, Coordinate::kAngle, 2.0}});
  push(model, 0, Coordinate::kAngle, 0.3);
  test::Run run(model, "one_step", test::precise(1e-11));
  ASSERT_EQ(run.assembly.redundant.size(), 1u);
  run.to(2.0);
  EXPECT_NEAR(run.body(0).w.z(), 0.3 / (0.1 + 0.1 / 4.0) * 2.0, 1e-7);
}

// mbd_solver/model/elements/rolling.h: rolling without slip against closed forms: down a slope, on a turntable, and a coin that
// rolls in a circle.

constexpr double kRollingTolerance = 1e-8;  // rtol of the runs is 1e-11, over some hundred steps
constexpr double kG = 9.81;                 // [m/s2]

// Multipliers of the three rows of joint 0 turned into the force on the wheel, in the axes of the plane.
Eigen::Vector3d force_on_wheel(test::Run& run, int joint = 0) {
  Eigen::VectorXd rates(run.equations.layout().size());
  run.equations.saddle().accelerations(run.state, run.inputs, rates);
  const Layout& layout = run.equations.layout();
  return -rates.segment<3>(layout.lambda0() + layout.joint_row[static_cast<std::size_t>(joint)]);
}

class Rolls : public ::testing::TestWithParam<std::string> {};

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
  // the touching point moves as the table does: w x (-R n) = Omega x r - dr
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
