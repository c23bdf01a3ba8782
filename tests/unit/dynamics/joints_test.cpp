// Joints, their coordinates and what acts on these.
#include <gtest/gtest.h>

#include <cmath>

#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/laws/friction.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/springs.h"
#include "tests/support/linear_algebra.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

// mbd_solver/model/elements/joint.h:
// every condition of every joint: value, rate, acceleration and Jacobian row against differences along a
// random motion.

struct Motion {
  Eigen::VectorXd q, v, dv;
};

// Where the motion is a time dt later: q to third order along v and dv (constant dv), so central
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

// mbd_solver/model/elements/joint_coordinate.h, elements/joint_force.h and rotors: what acts on a joint's coordinate,
// against exact motions of a wheel or a slider.

// Of fifth order: a second-order run would take ten thousand steps for the same.
constexpr double kWheelInertia = 0.1;          // of the wheel about its axis [kg m2]; mass of the slider in kg
constexpr double kCoordinateTolerance = 1e-7;  // rtol of the runs is 1e-10, over some hundred steps

// A body on the ground that turns about, or slides along, z; or slides along x or y of a planar joint.
struct Axle {
  explicit Axle(Coordinate coordinate = Coordinate::kAngle, double rate = 0.0,
                const Eigen::Vector3d& gravity = {0, 0, 0})
      : model(gravity), kind(coordinate) {
    BodyState initial;
    (kind == Coordinate::kAngle ? initial.w : initial.dr)(axis_of(kind)) = rate;
    model.add_body(
        Body("body", kWheelInertia, Eigen::Vector3d(kWheelInertia, kWheelInertia, kWheelInertia).asDiagonal()),
        initial);
    const Marker m1 = ground_marker(Eigen::Vector3d::Zero()),
                 m2 = body_marker(0, model.body(0), Eigen::Vector3d::Zero());
    switch (kind) {
      case Coordinate::kAngle: model.add_joint(revolute_joint("axle", m1, m2)); break;
      case Coordinate::kDisplacement: model.add_joint(prismatic_joint("axle", m1, m2)); break;
      case Coordinate::kDisplacementX:
      case Coordinate::kDisplacementY: model.add_joint(planar_joint("axle", m1, m2)); break;
    }
  }
  void add(std::unique_ptr<StrutLaw> law) {
    std::vector<std::unique_ptr<StrutLaw>> laws;
    laws.push_back(std::move(law));
    forces.push_back(model.add_force(std::make_unique<JointForce>(
        "force_" + std::to_string(model.force_count()), model.joint(0).m1, model.joint(0).m2, kind, std::move(laws))));
  }
  void add_rotor(double inertia) {
    model.add_joint(rotor("rotor", model.joint(0).m1, model.joint(0).m2, kind, inertia));
  }
  Model model;
  Coordinate kind;
  std::vector<Handle<JointForce>> forces;
};

double rate(test::Run& run, Coordinate kind) {
  return (kind == Coordinate::kAngle ? run.body(0).w : run.body(0).dr)(axis_of(kind));
}

MotorParameters motor(MotorKind kind, TimeFunctionPtr command) {
  MotorParameters p;
  p.kind = kind;
  p.command = std::move(command);
  return p;
}

class EveryCoordinate : public ::testing::TestWithParam<Coordinate> {};

// A torque tau on an axle with a rotor behind a gear: (I + J g^2) q'' = g tau.
TEST_P(EveryCoordinate, RotorAddsItsInertiaBehindTheGear) {
  const double g = 20.0, J = 1e-3, tau = 0.05, t = 3.0;
  Axle axle(GetParam());
  MotorParameters p = motor(MotorKind::kTorque, polynomial({tau}));
  p.gear_ratio = g;
  axle.add(std::make_unique<Motor>(p));
  axle.add_rotor(J * g * g);
  for (const char* integrator : {"one_step", "ida"}) {
    test::Run run(axle.model, integrator, test::precise(1e-10));
    run.to(t, 3);
    const double speed = g * tau * t / (kWheelInertia + J * g * g);
    EXPECT_NEAR(rate(run, GetParam()), speed, kCoordinateTolerance * speed) << integrator;
    EXPECT_NEAR(sample_of(run, axle.forces[0]).q, 0.5 * speed * t, 1e-6 * speed * t)
        << integrator;  // more than one turn
    EXPECT_NEAR(run.energy().stored[Stored::kKinetic], 0.5 * (kWheelInertia + J * g * g) * speed * speed, 1e-6)
        << integrator;
    EXPECT_NEAR(run.imbalance(), 0.0, 1e-6) << integrator;
  }
}

// Torque falls from tau_0 at rest to 0 at omega_0: w = w_0 (1 - exp(-t tau_0 / (I w_0))).
TEST_P(EveryCoordinate, MotorSpeedsUpToItsNoLoadSpeed) {
  const double tau_0 = 0.4, omega_0 = 8.0, t = 2.5;
  Axle axle(GetParam());
  MotorParameters p = motor(MotorKind::kTorque, polynomial({10.0}));
  p.largest_torque = tau_0;
  p.no_load_speed = omega_0;
  axle.add(std::make_unique<Motor>(p));
  test::Run run(axle.model, "one_step", test::precise(1e-10));
  run.to(t);
  EXPECT_NEAR(rate(run, GetParam()), omega_0 * (1.0 - std::exp(-t * tau_0 / (kWheelInertia * omega_0))),
              kCoordinateTolerance);
  EXPECT_NEAR(run.state.supplied[Supply::kDrive], 0.5 * kWheelInertia * std::pow(rate(run, GetParam()), 2),
              kCoordinateTolerance);
}

// The whole motor: its rotor behind the gear, and a torque that falls with the motor's speed. It speeds up to omega_0 / g,
// (I + J g^2) w' = g tau_0 (1 - g w / omega_0), and gives less the faster it is.
TEST_P(EveryCoordinate, MotorWithRotorAndLimitsSpinsUp) {
  const double tau_0 = 0.03, omega_0 = 60.0, g = 5.0, J = 2e-3, t = 1.5;
  Axle axle(GetParam());
  MotorParameters p = motor(MotorKind::kTorque, polynomial({10.0}));
  p.largest_torque = tau_0;
  p.no_load_speed = omega_0;
  p.gear_ratio = g;
  axle.add(std::make_unique<Motor>(p));
  axle.add_rotor(J * g * g);
  const double inertia = kWheelInertia + J * g * g, end = omega_0 / g;
  for (const char* integrator : {"one_step", "ida"}) {
    test::Run run(axle.model, integrator, test::precise(1e-10));
    for (const double at : {0.3 * t, t, 20.0 * t}) {
      run.to(at, 4);
      const double speed = end * (1.0 - std::exp(-g * tau_0 * at / (inertia * end)));
      EXPECT_NEAR(rate(run, GetParam()), speed, kCoordinateTolerance * end) << integrator;
      EXPECT_NEAR(sample_of(run, axle.forces[0]).force, g * tau_0 * (1.0 - speed / end), kCoordinateTolerance)
          << integrator;
      EXPECT_NEAR(run.state.supplied[Supply::kDrive], 0.5 * inertia * speed * speed, kCoordinateTolerance * end * end)
          << integrator;
    }
  }
}

// I q'' = -kp q - kd q' towards a command of 0.3, from rest: the damped oscillator.
TEST_P(EveryCoordinate, MotorHoldsAPosition) {
  const double kp = 4.0, kd = 0.3, c = 0.3, t = 0.7;
  Axle axle(GetParam());
  MotorParameters p = motor(MotorKind::kPosition, polynomial({c}));
  p.kp = kp;
  p.kd = kd;
  axle.add(std::make_unique<Motor>(p));
  test::Run run(axle.model, "one_step", test::precise(1e-10));
  run.to(t);
  const double d = 0.5 * kd / kWheelInertia, w = std::sqrt(kp / kWheelInertia - d * d);
  const double exact = c * (1.0 - std::exp(-d * t) * (std::cos(w * t) + d / w * std::sin(w * t)));
  EXPECT_NEAR(sample_of(run, axle.forces[0]).q, exact, kCoordinateTolerance);
  EXPECT_NEAR(run.imbalance(), 0.0, kCoordinateTolerance);
}

// Under a load a proportional motor stays short; the integral takes the rest away.
TEST_P(EveryCoordinate, IntegralTakesTheErrorAway) {
  Axle axle(GetParam());
  MotorParameters load = motor(MotorKind::kTorque, polynomial({-0.7})),
                  p = motor(MotorKind::kPosition, polynomial({2.0}));
  p.kp = 4.0;
  p.kd = 1.0;
  p.ki = 5.0;
  axle.add(std::make_unique<Motor>(load));
  axle.add(std::make_unique<Motor>(p));
  test::Run run(axle.model, "one_step", test::precise(1e-9));
  run.to(20.0);
  EXPECT_NEAR(sample_of(run, axle.forces[1]).q, 2.0, 1e-6);  // exp(-20 / 1.2 s) of the start
  EXPECT_NEAR(sample_of(run, axle.forces[1]).force, 0.7, 1e-6);
}

// A far command with a small motor, against drag: 6 s at full torque. An integral that grew all the way, to 9 rad s,
// would carry it over the command by more than its length; with anti-windup it holds what the limit leaves it.
TEST_P(EveryCoordinate, LimitedMotorDoesNotWindUp) {
  Axle axle(GetParam());
  MotorParameters p = motor(MotorKind::kPosition, polynomial({3.0}));
  p.kp = 4.0;
  p.kd = 1.2;
  p.ki = 2.0;
  p.largest_torque = 0.1;
  axle.add(std::make_unique<Motor>(p));
  axle.add(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{0.0, 0.2, 0.0, 0.0}));
  test::Run run(axle.model, "one_step", test::precise(1e-7));
  double largest = 0.0;
  for (int i = 1; i <= 150; ++i) {
    run.to(0.2 * i);
    largest = std::max(largest, sample_of(run, axle.forces[0]).q);
    EXPECT_LE(std::abs(sample_of(run, axle.forces[0]).force), 0.1 * (1.0 + 1e-12));
  }
  EXPECT_NEAR(sample_of(run, axle.forces[0]).q, 3.0, 1e-3);  // exp(-t / 2 s) of the integral's rest
  EXPECT_LT(largest, 3.0 * 1.1);
}

TEST_P(EveryCoordinate, GearLosesItsShare) {
  const double eta = 0.8, tau = 0.3, g = 5.0, t = 2.0;
  Axle axle(GetParam());
  MotorParameters p = motor(MotorKind::kTorque, polynomial({tau}));
  p.gear_ratio = g;
  p.efficiency = eta;
  axle.add(std::make_unique<Motor>(p));
  test::Run run(axle.model, "one_step", test::precise(1e-10));
  run.to(t);
  const double speed = eta * g * tau * t / kWheelInertia;
  EXPECT_NEAR(rate(run, GetParam()), speed, 1e-4 * speed);  // the loss sets in over 1e-3 rad/s at the start
  EXPECT_NEAR(run.state.dissipated[Dissipation::kFriction], (1.0 - eta) * run.state.supplied[Supply::kDrive],
              1e-4 * run.state.supplied[Supply::kDrive]);
  EXPECT_NEAR(run.imbalance(), 0.0, 1e-6 * run.state.supplied[Supply::kDrive]);
}

// mbd_solver/model/force_element.h: modes are looked for in elements that have them.
TEST_P(EveryCoordinate, HasModesWhereItsFrictionSticks) {
  static_assert(!std::is_base_of_v<Switching, Strut> && !std::is_base_of_v<Remembering, JointForce>);
  Axle smooth(GetParam()), rough(GetParam());
  smooth.add(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{1.0, 0.0, 0.0, 0.0}));
  rough.add(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{1.0, 0.0, 0.0, 0.0}));
  JointFrictionParameters p;
  p.breakaway = p.coulomb = 0.2;
  rough.add(std::make_unique<JointFriction>(p));
  EXPECT_FALSE(Equations(smooth.model, test::as_given(smooth.model)).has_modes());
  EXPECT_TRUE(Equations(rough.model, test::as_given(rough.model)).has_modes());
}

// Sliding friction stops the axle after w I / F_c, and then it stays.
TEST_P(EveryCoordinate, FrictionStopsAndHolds) {
  const double F = 0.2, w = 3.0;
  Axle axle(GetParam(), w);
  JointFrictionParameters p;
  p.breakaway = p.coulomb = F;
  axle.add(std::make_unique<JointFriction>(p));
  test::Run run(axle.model, "one_step", test::precise(1e-8));
  const double half = 0.5 * w * kWheelInertia / F;
  run.to(half);
  // The bristle is bent within 1e-4 / 3 s: the speed lags by F / I of that.
  EXPECT_NEAR(rate(run, GetParam()), 0.5 * w, 1e-3);
  run.to(half + 5.0);
  EXPECT_LT(std::abs(rate(run, GetParam())), 1e-6);
  EXPECT_NEAR(run.state.dissipated[Dissipation::kFriction], 0.5 * kWheelInertia * w * w, 1e-4);
  EXPECT_NEAR(run.imbalance(), 0.0, 1e-5);
}

// Below what it holds it does not creep: less than 1e-9 rad or m in 20 s under 60 % of F_c, also when the load wavers.
TEST_P(EveryCoordinate, FrictionSticksWithoutCreeping) {
  const double F = 0.2;
  Axle axle(GetParam());
  JointFrictionParameters p;
  p.breakaway = p.coulomb = F;
  axle.add(std::make_unique<JointFriction>(p));
  axle.add(std::make_unique<Motor>(motor(MotorKind::kTorque, sum({polynomial({0.5 * F}), sine(0.1 * F, 1.0)}))));
  test::Run run(axle.model, "one_step", test::precise(1e-9));
  run.to(2.0);
  const double before = sample_of(run, axle.forces[0]).q;
  run.to(22.0, 10);
  EXPECT_LT(std::abs(sample_of(run, axle.forces[0]).q - before), 1e-9);
  EXPECT_LT(std::abs(rate(run, GetParam())), 1e-3);
}

TEST_P(EveryCoordinate, FrictionLetsGoAboveBreakaway) {
  const double F = 0.2, load = 0.35, t = 2.0;
  Axle axle(GetParam());
  JointFrictionParameters p;
  p.coulomb = F;
  p.breakaway = 0.3;
  p.viscous = 0.05;
  axle.add(std::make_unique<JointFriction>(p));
  axle.add(std::make_unique<Motor>(motor(MotorKind::kTorque, polynomial({load}))));
  test::Run run(axle.model, "one_step", test::precise(1e-9));
  run.to(t + 10.0);
  EXPECT_NEAR(rate(run, GetParam()), (load - F) / 0.05, 0.05 * (load - F) / 0.05);  // exp(-t c / I) of the start
  EXPECT_NEAR(run.imbalance(), 0.0, 1e-6);
}

// Against a stop without loss the axle comes back as fast as it came.
TEST_P(EveryCoordinate, StopTurnsItBack) {
  Axle axle(GetParam(), 2.0);
  EndStopParameters p;
  p.smallest_stroke = -0.5;
  p.largest_stroke = 0.5;
  p.stiffness = 1e4;
  p.dissipation = 0.0;
  axle.add(std::make_unique<EndStop>(p));
  test::Run run(axle.model, "one_step", test::precise(1e-9));
  run.to(0.4);
  EXPECT_NEAR(rate(run, GetParam()), -2.0, 1e-5);
  run.to(0.9);
  EXPECT_NEAR(rate(run, GetParam()), 2.0, 1e-5);
  EXPECT_NEAR(run.imbalance(), 0.0, 1e-5);
}

std::string name_of_test(const ::testing::TestParamInfo<Coordinate>& info) { return std::string(name_of(info.param)); }

INSTANTIATE_TEST_SUITE_P(Coordinates, EveryCoordinate, ::testing::ValuesIn(every<Coordinate>()), name_of_test);

// 12 rad/s against 0.4 N m/rad: 6 sin(2 t) rad, twice beyond half a turn.
TEST(JointForce, SpringGoesOnOverTurns) {
  Axle axle(Coordinate::kAngle, 12.0);
  LinearSpringDamperParameters p;
  p.stiffness = 0.4;
  axle.add(std::make_unique<LinearSpringDamper>(p));
  test::Run run(axle.model, "one_step", test::precise(1e-10));
  for (int i = 1; i <= 40; ++i) {
    run.to(0.1 * i);
    EXPECT_NEAR(sample_of(run, axle.forces[0]).q, 6.0 * std::sin(2.0 * run.state.time), 1e-6);
  }
}

// A rotor on a joint between two free bodies takes no outside moment: the sum of spins stays.
TEST(Rotor, KeepsTheSpinsOfFreeBodies) {
  Model model;
  const double I1 = 0.3, I2 = 0.1, J = 0.5;
  BodyState s1, s2;
  s1.w = 2.0 * Eigen::Vector3d::UnitZ();
  s2.w = 5.0 * Eigen::Vector3d::UnitZ();
  model.add_body(Body("a", 1.0, I1 * Eigen::Matrix3d::Identity()), s1);
  model.add_body(Body("b", 1.0, I2 * Eigen::Matrix3d::Identity()), s2);
  const Marker m1 = body_marker(0, model.body(0), Eigen::Vector3d::Zero());
  const Marker m2 = body_marker(1, model.body(1), Eigen::Vector3d::Zero());
  model.add_joint(revolute_joint("axle", m1, m2));
  model.add_joint(rotor("rotor", m1, m2, Coordinate::kAngle, J));
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{0.0, 0.2, 0.0, 0.0}));
  model.add_force(std::make_unique<JointForce>("drag", m1, m2, Coordinate::kAngle, std::move(laws)));
  test::Run run(model, "one_step", test::precise(1e-10));
  run.to(3.0, 3);
  // mu = I1 I2 / (I1 + I2):  (mu + J) q'' = -c q'
  const double mu = I1 * I2 / (I1 + I2), q_rate = 3.0 * std::exp(-0.2 * 3.0 / (mu + J));
  EXPECT_NEAR(run.body(1).w.z() - run.body(0).w.z(), q_rate, kCoordinateTolerance);
  EXPECT_NEAR(I1 * run.body(0).w.z() + I2 * run.body(1).w.z(), I1 * 2.0 + I2 * 5.0, kCoordinateTolerance);
  EXPECT_NEAR(run.imbalance(), 0.0, kCoordinateTolerance);
}

// A light wheel with a heavy rotor: the rotor does not count as redundant, nor is it held against the joint's closing.
TEST(Rotor, IsNoCondition) {
  Axle axle;
  axle.add_rotor(100.0);
  const Assembly assembly = assemble(axle.model);
  EXPECT_TRUE(assembly.redundant.empty());
  EXPECT_TRUE(assembly.notes.empty());
  EXPECT_EQ(assembly.rank, 5);
}

// Input and output of a constant-velocity joint turn alike while bent by 30 degrees; in a universal joint they do not.
TEST(Joints, ConstantVelocityTurnsEvenly) {
  Model model;
  const double bend = 0.5, speed = 4.0;  // [rad], [rad/s]
  const Eigen::Vector3d out(std::sin(bend), 0.0, std::cos(bend));
  BodyState first, second;
  second.L << std::cos(0.5 * bend), 0.0, std::sin(0.5 * bend), 0.0;
  first.w = speed * Eigen::Vector3d::UnitZ();
  second.w = speed * out;
  for (const BodyState& state : {first, second})
    model.add_body(Body(model.body_count() == 0 ? "in" : "out", 1.0, 0.1 * Eigen::Matrix3d::Identity()), state);
  const Eigen::Matrix3d bent = rotation_matrix(second.L);
  const auto at = [&](int body, const Eigen::Matrix3d& axes) {
    return model.marker_at(body, Eigen::Vector3d::Zero(), axes);
  };
  PrescribedMotion driven;
  driven.rotation = polynomial({0.0, speed});
  driven.hold_other_rotations = true;
  driven.translation = {polynomial({0.0}), polynomial({0.0}), polynomial({0.0})};
  const Eigen::Matrix3d straight = Eigen::Matrix3d::Identity();
  model.add_joint(prescribed_joint("drive", ground_marker(Eigen::Vector3d::Zero()), at(0, straight), driven));
  model.add_joint(constant_velocity_joint("joint", at(0, straight), at(1, bent)));
  Joint axle = revolute_joint("axle", ground_marker(Eigen::Vector3d::Zero(), bent), at(1, bent));
  axle.rows.erase(axle.rows.begin(), axle.rows.begin() + 3);  // the joint holds the points
  model.add_joint(axle);
  test::Run run(model, "one_step", test::precise(1e-9));
  for (int i = 1; i <= 20; ++i) {
    run.to(0.1 * i);
    EXPECT_NEAR(run.body(1).w.dot(out), speed, 1e-6) << run.state.time;
  }
}

// A puck on a table: it slides as a point, and spins.
TEST(Joints, PlanarSlidesAndTurns) {
  Model model(Eigen::Vector3d(0.0, 0.0, -9.81));
  BodyState state;
  state.dr = Eigen::Vector3d(1.0, 2.0, 0.0);
  state.w = 3.0 * Eigen::Vector3d::UnitZ();
  model.add_body(Body("puck", 1.0, 0.1 * Eigen::Matrix3d::Identity()), state);
  model.add_joint(
      planar_joint("table", ground_marker(Eigen::Vector3d::Zero()), model.marker_at(0, Eigen::Vector3d::Zero())));
  test::Run run(model, "one_step", test::precise(1e-9));
  run.to(2.0);
  EXPECT_LT((run.body(0).r - Eigen::Vector3d(2.0, 4.0, 0.0)).norm(), kCoordinateTolerance);
  EXPECT_NEAR(run.body(0).w.z(), 3.0, kCoordinateTolerance);
}

// The three coordinates of a planar joint (mbd_solver/model/elements/joint_coordinate.h) with springs and dampers on each,
// against exact motions.

constexpr double kPlanarTolerance = 1e-7;              // rtol of the runs is 1e-10, over some hundred steps
constexpr double kPuckMass = 2.0, kPuckInertia = 0.1;  // [kg], [kg m2]

Handle<JointForce> add_spring(Model& model, int joint, Coordinate coordinate, double stiffness, double damping) {
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{stiffness, damping, 0.0, 0.0}));
  return model.add_force(std::make_unique<JointForce>("spring_" + std::to_string(model.force_count()),
                                                      model.joint(joint).m1, model.joint(joint).m2, coordinate,
                                                      std::move(laws)));
}

Body puck() { return Body("puck", kPuckMass, kPuckInertia * Eigen::Matrix3d::Identity()); }

class PlanarJoint : public ::testing::TestWithParam<const char*> {};

// On a ground at rest, at an oblique attitude: q = q'_0 / w sin(w t) in each coordinate, the angle over more than a turn.
TEST_P(PlanarJoint, SwingsInItsThreeCoordinatesApart) {
  test::Random random(5);
  const Eigen::Matrix3d axes = random.axes();
  const double k[3] = {0.4, 50.0, 18.0}, rate[3] = {20.0, 0.7, -1.3};
  const double inertia[3] = {kPuckInertia, kPuckMass, kPuckMass};
  BodyState state;
  state.w = rate[0] * axes.col(2);
  state.dr = rate[1] * axes.col(0) + rate[2] * axes.col(1);
  Model model;
  model.add_body(puck(), state);
  model.add_joint(planar_joint("table", ground_marker(Eigen::Vector3d::Zero(), axes),
                               model.marker_at(0, Eigen::Vector3d::Zero(), axes)));
  const Handle<JointForce> springs[3] = {add_spring(model, 0, Coordinate::kAngle, k[0], 0.0),
                                         add_spring(model, 0, Coordinate::kDisplacementX, k[1], 0.0),
                                         add_spring(model, 0, Coordinate::kDisplacementY, k[2], 0.0)};
  test::Run run(model, GetParam(), test::precise(1e-10));
  for (int i = 1; i <= 20; ++i) {
    run.to(0.17 * i);
    for (int c = 0; c < 3; ++c) {
      const double w = std::sqrt(k[c] / inertia[c]);
      EXPECT_NEAR(sample_of(run, springs[c]).q, rate[c] / w * std::sin(w * run.state.time),
                  kPlanarTolerance * (1.0 + std::abs(rate[c] / w)) * 10.0)
          << "coordinate " << c << " at " << run.state.time;
    }
    EXPECT_LT(std::abs(run.imbalance()), 1e-6) << run.state.time;
  }
}

// On a table that turns evenly, whose axes x and y the springs follow. With v = (x, y) on the table, J = [0, -1; 1, 0]:
//   v'' = -diag(k) v / m - diag(c) v' / m + W^2 v - 2 W J v'
// The angle of the puck against the table is a third oscillator.
TEST_P(PlanarJoint, CarriesItsAxesWithTheFirstBody) {
  const double W = 3.0, k[2] = {60.0, 90.0}, c[2] = {0.8, 0.3}, k_turn = 1.5;
  const Eigen::Vector4d start(0.0, 0.0, 0.9, -0.4);  // x, y, x', y'
  Model model;
  BodyState turning, thrown;
  turning.w = W * Eigen::Vector3d::UnitZ();
  thrown.dr << start[2], start[3], 0.0;
  thrown.w = (W + 2.0) * Eigen::Vector3d::UnitZ();
  model.add_body(Body("table", 5.0, Eigen::Matrix3d::Identity()), turning);
  model.add_body(puck(), thrown);
  PrescribedMotion motion;
  motion.rotation = polynomial({0.0, W});
  motion.hold_other_rotations = true;
  motion.translation = {polynomial({0.0}), polynomial({0.0}), polynomial({0.0})};
  model.add_joint(prescribed_joint("drive", ground_marker(Eigen::Vector3d::Zero()),
                                   model.marker_at(0, Eigen::Vector3d::Zero()), motion));
  model.add_joint(
      planar_joint("top", model.marker_at(0, Eigen::Vector3d::Zero()), model.marker_at(1, Eigen::Vector3d::Zero())));
  const Handle<JointForce> springs[3] = {add_spring(model, 1, Coordinate::kDisplacementX, k[0], c[0]),
                                         add_spring(model, 1, Coordinate::kDisplacementY, k[1], c[1]),
                                         add_spring(model, 1, Coordinate::kAngle, k_turn, 0.0)};
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  A.topRightCorner<2, 2>().setIdentity();
  for (int i = 0; i < 2; ++i) {
    A(2 + i, i) = W * W - k[i] / kPuckMass;
    A(2 + i, 2 + i) = -c[i] / kPuckMass;
  }
  A(2, 3) = 2.0 * W;
  A(3, 2) = -2.0 * W;
  test::Run run(model, GetParam(), test::precise(1e-10));
  for (int i = 1; i <= 10; ++i) {
    run.to(0.2 * i);
    const Eigen::Vector4d exact = test::exponential(A * run.state.time) * start;
    EXPECT_NEAR(sample_of(run, springs[0]).q, exact[0], kPlanarTolerance) << run.state.time;
    EXPECT_NEAR(sample_of(run, springs[1]).q, exact[1], kPlanarTolerance) << run.state.time;
    const double w = std::sqrt(k_turn / kPuckInertia);
    EXPECT_NEAR(sample_of(run, springs[2]).q, 2.0 / w * std::sin(w * run.state.time), kPlanarTolerance);
    EXPECT_LT(std::abs(run.imbalance()), 1e-6) << run.state.time;
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, PlanarJoint, ::testing::Values("one_step", "ida"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace footfall
