// One body at a time, against closed forms: free top, damped oscillators, impact and rolling on the rigid
// plane.

#include <cmath>
#include <string>

#include "coupler/base/pi.h"
#include "mbd_solver/model/laws/linear_spring_damper.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "mbd_solver/model/mass_properties.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

class SingleBodyBy : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, SingleBodyBy, ::testing::Values("one_step", "ida"));

TEST_P(SingleBodyBy, SymmetricTopNutatesAsInClosedForm) {
  // w = H / J1 + w3 (1 - J3 / J1) e3: the attitude turns about H at |H| / J1 and about its own axis at w3 (1
  // - J3 / J1).
  Model model;
  const double J1 = 2.0, J3 = 3.0;
  BodyState state;
  state.L = quaternion_about({1.0, 2.0, -0.5}, 0.7);
  const Eigen::Matrix3d A0 = rotation_matrix(state.L);
  const Eigen::Vector3d w_B(1.0, 0.5, 4.0);
  state.w = A0 * w_B;
  state.dr = {0.1, 0.2, 0.3};
  const Eigen::Matrix3d J = Eigen::Vector3d(J1, J1, J3).asDiagonal();
  const int top = model.add_body(Body("top", 1.5, J), state);
  const Eigen::Vector3d H = A0 * J * w_B;
  test::Run run(model, GetParam(), test::tight(1e-9));
  const double t = 2.0;
  run.to(t, 4);
  const Eigen::Matrix3d expected =
      rotation_matrix(quaternion_about(H, H.norm() / J1 * t)) * A0 *
      rotation_matrix(quaternion_about(Eigen::Vector3d::UnitZ(), w_B[2] * (1.0 - J3 / J1) * t));
  const BodyKinematics now = run.body(top);
  // second-order method at 1e-9 per step: steps of 2e-4 s, 1e4 of them
  EXPECT_LT((now.A - expected).norm(), 1e-5);
  EXPECT_LT((now.A * J * now.A.transpose() * now.w - H).norm(), 1e-5 * H.norm());
  EXPECT_LT((now.r - t * state.dr).norm(), 1e-12);  // free flight is linear: exact
}

// A body that slides along z over the ground, tied to it by a strut of the given law; its free length is 1 m.
struct Oscillator {
  explicit Oscillator(std::unique_ptr<StrutLaw> spring, std::unique_ptr<StrutLaw> damper, double mass, double z0) {
    BodyState state;
    state.r = {0.0, 0.0, 1.0 + z0};
    body = model.add_body(Body("mass", mass, Eigen::Matrix3d::Identity()), state);
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    model.add_joint(prismatic_joint("slide", model.marker_at(kGround, origin), model.marker_at(body, state.r)));
    std::vector<std::unique_ptr<StrutLaw>> laws;
    laws.push_back(std::move(spring));
    laws.push_back(std::move(damper));
    model.add_force(std::make_unique<Strut>("strut", ground_marker(origin), model.marker_at(body, state.r),
                                            std::move(laws), 1.0, 0));
  }
  Model model;
  int body = 0;
};

std::unique_ptr<StrutLaw> spring(double k) {
  return std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{k, 0.0, 0.0, 0.0});
}
std::unique_ptr<StrutLaw> dashpot(double c) {
  return std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{0.0, c, 0.0, 0.0});
}

TEST_P(SingleBodyBy, ViscousOscillatorDecaysAsInClosedForm) {
  const double k = 200.0, m = 2.0, c = 4.0, z0 = 0.1, t = 1.3;
  Oscillator o(spring(k), dashpot(c), m, z0);
  test::Run run(o.model, GetParam(), test::tight(1e-9));
  run.to(t, 5);
  const double delta = 0.5 * c / m, omega = std::sqrt(k / m - delta * delta);
  const double z = z0 * std::exp(-delta * t) * (std::cos(omega * t) + delta / omega * std::sin(omega * t));
  EXPECT_NEAR(run.body(o.body).r.z() - 1.0, z, 1e-5 * z0);
  // Dissipated energy has its place, its name, and the size of what is missing.
  EXPECT_GT(run.state.dissipated[Dissipation::kDamper], 0.5);
  // second-order method, tolerance 1e-9 over 1e4 steps
  EXPECT_LT(std::abs(run.imbalance()), 1e-5 * run.start_energy());
}

TEST_P(SingleBodyBy, CoulombOscillatorLosesTheSameAmplitudeEveryHalfPeriod) {
  // Turning points 2 F / k closer to the middle after each half period. Regularised at 1e-5 m/s, against
  // speeds of 1 m/s.
  const double k = 400.0, m = 1.0, F = 2.0, z0 = 0.05;
  Oscillator o(spring(k), std::make_unique<MrDamper>(MrDamperParameters{F, 0.0, 1e-5, 0.0, 0.0, {}}), m, z0);
  test::Run run(o.model, GetParam(), test::tight(1e-8));
  run.inputs.voltages = Eigen::VectorXd::Ones(1);
  const double half_period = kPi * std::sqrt(m / k);
  for (int i = 1; i <= 4; ++i) {
    run.to(i * half_period, 3);
    const double expected = (i % 2 == 0 ? 1.0 : -1.0) * (z0 - i * 2.0 * F / k);
    EXPECT_NEAR(run.body(o.body).r.z() - 1.0, expected, 1e-5)
        << i;  // v_s times the time spent at that speed, and tolerance
  }
  // After 4 half periods the rest amplitude is 0.01; the fifth ends where the spring cannot overcome friction
  // (k z < F): it stays.
  run.to(5.5 * half_period, 3);
  const double rest = run.body(o.body).r.z();
  run.to(8.0 * half_period, 3);
  EXPECT_NEAR(run.body(o.body).r.z(), rest, 1e-5);  // creep at most 1e-5 m/s for 0.4 s
  EXPECT_LT(std::abs(run.imbalance()), 1e-4 * run.start_energy());
}

// A ball on the plane z = 0.
struct Ball {
  Ball(const RigidPlane::Parameters& plane, double radius, const BodyState& state, const Eigen::Vector3d& gravity)
      : model(gravity) {
    const MassProperties sphere = with_mass(sphere_properties(radius, 1.0), 2.0);
    body = model.add_body(Body("ball", sphere.mass, sphere.inertia), state);
    auto contact = std::make_unique<RigidPlane>(
        "plane", std::vector<ContactPoint>{{body_marker(body, model.body(body), Eigen::Vector3d::Zero()), radius}},
        plane);
    element = contact.get();
    model.add_force(std::move(contact));
  }
  Model model;
  int body = 0;
  const RigidPlane* element = nullptr;
};

TEST_P(SingleBodyBy, ElasticImpactHasHertzDepthAndDuration) {
  RigidPlane::Parameters plane;
  plane.stiffness = 1e6;
  plane.friction = 0.0;
  const double radius = 0.1, v = 2.0, m = 2.0;
  BodyState state;
  state.r = {0.0, 0.0, radius + 1e-9};
  state.dr = {0.0, 0.0, -v};
  Ball ball(plane, radius, state, Eigen::Vector3d::Zero());
  // depth = (5 m v^2 / (4 k))^(2/5), duration 2.9432 depth / v
  const double depth = std::pow(1.25 * m * v * v / plane.stiffness, 0.4), duration = 2.9432 * depth / v;
  test::Run run(ball.model, GetParam(), test::tight(1e-9));
  run.to(0.5 * duration, 3);
  run.equations.load(run.state);
  const ElementInput in = run.equations.element_input(0, run.state, run.inputs);
  EXPECT_NEAR(ball.element->largest_overlap(in), depth, 1e-4 * depth);
  EXPECT_NEAR(ball.element->wrench(in)[2], plane.stiffness * std::pow(depth, 1.5),
              1e-3 * plane.stiffness * std::pow(depth, 1.5));
  run.to(0.999 * duration);
  EXPECT_LT(run.body(ball.body).r.z(), radius);
  run.to(1.001 * duration);
  EXPECT_GT(run.body(ball.body).r.z(), radius);
  EXPECT_NEAR(run.body(ball.body).dr.z(), v, 1e-5 * v);
}

TEST_P(SingleBodyBy, BounceHasItsRestitution) {
  for (double e : {0.3, 0.8}) {
    RigidPlane::Parameters plane;
    plane.stiffness = 1e6;
    plane.friction = 0.0;
    const double radius = 0.1, v = 2.0;
    plane.damping = contact_damping_for_restitution(e, v);
    BodyState state;
    state.r = {0.0, 0.0, radius + 1e-3};
    state.dr = {0.0, 0.0, -v};
    Ball ball(plane, radius, state, Eigen::Vector3d::Zero());
    test::Run run(ball.model, GetParam(), test::tight(1e-9));
    run.to(0.05, 10);
    EXPECT_GT(run.body(ball.body).r.z(), radius);
    EXPECT_NEAR(run.body(ball.body).dr.z(), e * v, 1e-5 * v) << e;
    EXPECT_NEAR(run.state.dissipated[Dissipation::kContact], 0.5 * 2.0 * v * v * (1.0 - e * e), 1e-4) << e;
  }
}

TEST_P(SingleBodyBy, SlidingBallEndsUpRollingAtFiveSevenths) {
  // Friction at the lowest point: m v changes by its impulse, J w by its moment; rolling without slip leaves
  // 5/7 of the speed.
  RigidPlane::Parameters plane;
  plane.stiffness = 1e6;
  plane.damping = 0.5;
  plane.friction = 0.5;
  plane.slip_speed = 1e-4;
  const double radius = 0.1, g = 9.81, v = 1.0;
  BodyState state;
  state.r = {0.0, 0.0, radius - std::pow(2.0 * g / plane.stiffness, 2.0 / 3.0)};  // resting overlap
  state.dr = {v, 0.0, 0.0};
  Ball ball(plane, radius, state, {0.0, 0.0, -g});
  test::Run run(ball.model, GetParam(), test::tight(1e-7));
  run.to(0.3, 10);  // slips for 2/7 v / (mu g) = 0.06 s
  EXPECT_NEAR(run.body(ball.body).dr.x(), 5.0 / 7.0 * v, 1e-4 * v);
  EXPECT_NEAR(run.body(ball.body).w.y(), 5.0 / 7.0 * v / radius, 2e-4 * v / radius);
  EXPECT_NEAR(run.state.dissipated[Dissipation::kFriction], 0.5 * 2.0 * v * v * 2.0 / 7.0, 1e-3);
  EXPECT_LT(std::abs(run.imbalance()), 1e-5);
}

TEST_P(SingleBodyBy, PrescribedMotionDoesTheWorkItReports) {
  // A mass shaken along z, turned about z: kinetic energy comes from the drive alone.
  Model model({0.0, 0.0, -2.0});
  const int body = model.add_body(Body("plate", 3.0, Eigen::Vector3d(1.0, 1.0, 2.0).asDiagonal()), {});
  PrescribedMotion motion;
  motion.translation = {polynomial({0.0}), polynomial({0.0, 0.5}), ramp(0.0, 0.4, 0.0, 1.0)};
  motion.rotation = ramp(0.0, 7.0, 0.0, 0.8);  // more than one turn
  motion.hold_other_rotations = true;
  model.add_joint(prescribed_joint("drive", ground_marker(Eigen::Vector3d::Zero()),
                                   body_marker(body, model.body(body), Eigen::Vector3d::Zero()), motion));
  test::Run run(model, GetParam(), test::tight(1e-8));
  run.to(0.6, 7);
  const BodyKinematics now = run.body(body);
  const TimeValue height = motion.translation[2]->at(0.6), angle = motion.rotation->at(0.6);
  // Position constraints: projected after every step, with IDA where a drift of 1e-9 is passed (5e-9 of a speed).
  const bool always = std::string(GetParam()) == "one_step";
  const double place = always ? 1e-12 : 1e-9, speed = always ? 1e-11 : 5e-9;
  EXPECT_NEAR(now.r.z(), height.value, place);
  EXPECT_NEAR(now.dr.z(), height.rate, speed);
  EXPECT_NEAR(now.r.y(), 0.3, place);
  EXPECT_NEAR(std::atan2(now.A(1, 0), now.A(0, 0)), std::remainder(angle.value, 2.0 * kPi), place);
  EXPECT_NEAR(now.w.z(), angle.rate, speed);
  EXPECT_GT(run.state.supplied[Supply::kMotion], 1.0);
  EXPECT_LT(std::abs(run.imbalance()), 1e-5 * run.state.supplied[Supply::kMotion]);
}

TEST_P(SingleBodyBy, ConstantLoadDoesForceTimesWay) {
  Model model;
  const int body = model.add_body(Body("body", 2.0, Eigen::Vector3d(1.0, 2.0, 2.5).asDiagonal()), {});
  test::Run run(model, GetParam(), test::tight(1e-8));
  run.inputs.loads.resize(1);
  run.inputs.loads[0].F_W = {1.0, -2.0, 0.5};
  run.inputs.loads[0].T_B = {0.0, 0.0, 0.7};  // about a principal axis: w = T t / J
  run.to(1.5, 4);
  // quadratic in t: exact for both
  EXPECT_LT((run.body(body).r - 0.5 * 1.5 * 1.5 * run.inputs.loads[0].F_W / 2.0).norm(), 1e-8);
  EXPECT_NEAR(run.body(body).w.z(), 0.7 * 1.5 / 2.5, 1e-8);
  const double expected = run.inputs.loads[0].F_W.dot(run.body(body).r) + 0.5 * 2.5 * run.body(body).w.squaredNorm();
  EXPECT_NEAR(run.state.load_work[0], expected, 1e-7);
}

}  // namespace
}  // namespace footfall
