// mbd_solver/model/force_element.h:
// energy of every force element: what it takes from the motion is stored or dissipated.

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/laws/gas_spring.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

// d(stored)/dt by central differences along the motion at constant v (stored energy does not depend on v) and dz.
double stored_rate(const ForceElement& element, const Model& model, const Layout& layout, const State& state,
                   const Eigen::VectorXd& dz, const Eigen::VectorXd& voltages) {
  const double dt = 1e-6;
  double stored[2];
  for (int side = 0; side < 2; ++side) {
    State moved = state;
    add_increment(layout, (side == 0 ? -dt : dt) * state.v, moved.q);
    moved.z += (side == 0 ? -dt : dt) * dz;
    Kinematics kinematics(model);
    kinematics.load(layout, moved.q, moved.v, Eigen::VectorXd());
    StoredEnergy energy;
    Dissipated power;
    element.add_energy({kinematics.pair(element.bodies()[0], element.bodies()[1]), moved.z, voltages}, energy, power);
    stored[side] = energy.total();
  }
  return (stored[1] - stored[0]) / (2.0 * dt);
}

class ForceElementEnergy : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(ForceElementEnergy, WhatIsTakenIsStoredOrDissipated) {
  test::Random random(23);
  Model model = test::random_bodies(random);
  std::vector<std::unique_ptr<ForceElement>> elements =
      test::all_forces(random, model, GetParam().first, GetParam().second);
  // Those of the test law, which is not conservative; real laws take its place.
  elements.erase(std::remove_if(elements.begin(), elements.end(),
                                [](const auto& element) {
                                  const std::string kind = element->name().substr(0, element->name().find('_'));
                                  return kind == "strut" || kind == "coordinate";
                                }),
                 elements.end());
  for (const Coordinate coordinate : every<Coordinate>()) {
    std::vector<std::unique_ptr<StrutLaw>> spring;
    spring.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{50.0, 4.0, 0.1, 2.0}));
    const test::MarkerPair at = test::random_markers(random, model, GetParam().first, GetParam().second);
    elements.push_back(
        std::make_unique<JointForce>(std::string(name_of(coordinate)), at.m1, at.m2, coordinate, std::move(spring)));
  }
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{50.0, 4.0, 0.1, 2.0}));
  laws.push_back(std::make_unique<GasSpring>(GasSpringParameters{0.01, 1e5, 4e-4, 1.1, {}}));
  laws.push_back(std::make_unique<MrDamper>(MrDamperParameters{30.0, 2.0, 0.05, 0.0, 0.0, {}}));
  const test::MarkerPair ends = test::random_markers(random, model, GetParam().first, GetParam().second);
  elements.push_back(std::make_unique<Strut>("real", ends.m1, ends.m2, std::move(laws), 1.1, 0));
  const Layout layout(model);
  State state = test::as_given(model).state;
  Kinematics kinematics(model);
  kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
  const Eigen::VectorXd voltages = Eigen::Vector2d(0.7, 0.2);
  for (const std::unique_ptr<ForceElement>& element : elements) {
    const PairMotion pair = kinematics.pair(element->bodies()[0], element->bodies()[1]);
    state.z = element->initial_state();
    const ElementInput in{pair, state.z, voltages};
    Eigen::VectorXd Q = Eigen::VectorXd::Zero(pair.size()), dz(element->state_count()), v(pair.size());
    for (std::size_t i = 0; i < 2; ++i) {
      if (element->bodies()[i] == kGround) continue;
      v.segment(pair.offset(static_cast<int>(i)), pair.body[i]->size()) =
          state.v.segment(layout.body_v[static_cast<std::size_t>(element->bodies()[i])], pair.body[i]->size());
    }
    element->add_force(in, Q, dz);
    StoredEnergy stored;
    Dissipated power;
    element->add_energy(in, stored, power);
    const double taken = -Q.dot(v);
    Supplied supplied;
    element->add_supply(in, supplied);
    const double given = stored_rate(*element, model, layout, state, dz, voltages) + power.total() - supplied.total();
    EXPECT_NEAR(taken, given, 1e-7 * (std::abs(taken) + power.total() + std::abs(supplied.total())))
        << element->name();  // error of the difference
    for (double part : power.by_kind) EXPECT_GE(part, 0.0) << element->name();
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, ForceElementEnergy,
                         ::testing::Values(std::make_pair(0, 2), std::make_pair(0, 1), std::make_pair(1, 3),
                                           std::make_pair(kGround, 1), std::make_pair(2, kGround)));

TEST(RigidPlane, NeverPulls) {
  // However fast the body leaves, the plane pushes or does nothing.
  test::Random random(5);
  Model model;
  const int ball = model.add_body(Body("ball", 1.0, 0.4 * Eigen::Matrix3d::Identity()), {});
  RigidPlane::Parameters parameters;
  parameters.stiffness = 1e5;
  parameters.damping = 2.0;
  parameters.point = {0.0, 0.0, -0.9};
  const RigidPlane plane("plane", {{body_marker(ball, model.body(ball), Eigen::Vector3d::Zero()), 1.0}}, parameters);
  const Layout layout(model);
  Kinematics kinematics(model);
  State state = test::as_given(model).state;
  for (double speed : {-100.0, -1.0, 0.0, 1.0, 100.0}) {
    state.v[2] = speed;
    kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
    EXPECT_GE(plane.wrench({kinematics.pair(ball, kGround), plane.initial_state(), Eigen::VectorXd()})[2], 0.0)
        << speed;
  }
}

TEST(RigidPlane, CostsNothingFarAway) {
  // A body clear of the plane reports no derivatives and no force; it has no springs here, which would relax.
  test::Random random(6);
  Model model = test::random_bodies(random);
  RigidPlane::Parameters parameters;
  parameters.stiffness = 1e5;
  parameters.stick_time = 0.0;
  parameters.point = model.initial(1).r - Eigen::Vector3d(0.0, 0.0, 50.0);
  const RigidPlane plane("plane", {{test::random_marker(random, model, 1), 0.1}}, parameters);
  const Layout layout(model);
  Kinematics kinematics(model);
  const State state = test::as_given(model).state;
  kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
  const ElementInput in{kinematics.pair(1, kGround), state.z, Eigen::VectorXd()};
  ElementDerivatives unsized;  // would not survive being written to
  EXPECT_FALSE(plane.add_derivatives(in, unsized));
  EXPECT_EQ(plane.wrench(in).norm(), 0.0);
}

TEST(RigidPlane, DampingForRestitutionIsItsInverse) {
  for (double e : {0.05, 0.4, 0.9, 0.999}) {
    const double u = contact_damping_for_restitution(e, 2.0) * 2.0;
    const double w = e * u;
    EXPECT_NEAR(u - std::log1p(u), (w - 1.0) * std::exp(w) + 1.0, 1e-9 * u)
        << e;  // bisection to round-off of the terms
  }
  EXPECT_EQ(contact_damping_for_restitution(1.0, 2.0), 0.0);
  EXPECT_THROW(contact_damping_for_restitution(0.0, 2.0), InputError);
  EXPECT_THROW(contact_damping_for_restitution(1.1, 2.0), InputError);
}

// A wheel of 0.1 kg m2 on a bearing, with a spring of 0.4 N m/rad about it, thrown at 12 rad/s:
//   phi = 6 sin(2 t): nearly a whole turn to either side.
class WheelOnASpring : public ::testing::TestWithParam<const char*> {
 protected:
  WheelOnASpring() {
    BodyState thrown;
    thrown.w = {0.0, 0.0, 12.0};
    const int wheel = model.add_body(Body("wheel", 1.0, 0.1 * Eigen::Matrix3d::Identity()), thrown);
    model.add_joint(revolute_joint("bearing", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                   model.marker_at(wheel, Eigen::Vector3d::Zero())));
    LinearSpringDamperParameters parameters;
    parameters.stiffness = 0.4;
    model.add_force(torsional_spring("spring", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                     model.marker_at(wheel, Eigen::Vector3d::Zero()), parameters));
  }
  // Angle [rad] and rate [rad/s] of the spring.
  static JointForceSample spring(test::Run& run) {
    run.equations.load(run.state);
    return static_cast<const JointForce&>(run.equations.model().force(0))
        .sample(run.equations.element_input(0, run.state, run.inputs));
  }
  // Of angles of 6 rad and rates of 12 rad/s, each of some ten thousand steps exact to 1e-9. A missed turn is 6.3.
  static constexpr double kTolerance = 1e-4;
  Model model;
};

TEST_P(WheelOnASpring, TurnsBackAtSixRadians) {
  test::Run run(model, GetParam(), test::tight(1e-9));
  for (int k = 1; k <= 12; ++k) {
    run.to(0.25 * k);
    const double t = run.state.time;
    EXPECT_NEAR(spring(run).q, 6.0 * std::sin(2.0 * t), kTolerance) << t;
    EXPECT_NEAR(spring(run).rate, 12.0 * std::cos(2.0 * t), kTolerance) << t;
    EXPECT_LT(std::abs(run.imbalance()), 1e-6 * run.start_energy()) << t;  // order of the integrator's own error
  }
}

TEST_P(WheelOnASpring, KnowsItsTurnsAfterAResumption) {
  // The state alone tells the turn: a run that starts from it goes on the same.
  test::Run first(model, GetParam(), test::tight(1e-9)), second(model, GetParam(), test::tight(1e-9));
  first.to(0.7);
  second.state = first.state;
  EXPECT_NEAR(spring(second).q, 6.0 * std::sin(1.4), kTolerance);
  second.to(1.2);
  EXPECT_NEAR(spring(second).q, 6.0 * std::sin(2.4), kTolerance);
}

TEST_P(WheelOnASpring, CountsAHundredTurns) {
  // Driven at 100 rad/s, the angle is that of the drive, whatever the inner state has gathered of errors.
  Model driven;
  const int wheel = driven.add_body(Body("wheel", 1.0, 0.1 * Eigen::Matrix3d::Identity()), {});
  PrescribedMotion motion;
  motion.translation = {polynomial({0.0}), polynomial({0.0}), polynomial({0.0})};
  motion.rotation = polynomial({0.0, 100.0});
  motion.hold_other_rotations = true;
  driven.add_joint(prescribed_joint("drive", driven.marker_at(kGround, Eigen::Vector3d::Zero()),
                                    driven.marker_at(wheel, Eigen::Vector3d::Zero()), motion));
  LinearSpringDamperParameters parameters;
  parameters.stiffness = 0.4;
  driven.add_force(torsional_spring("spring", driven.marker_at(kGround, Eigen::Vector3d::Zero()),
                                    driven.marker_at(wheel, Eigen::Vector3d::Zero()), parameters));
  test::Run run(driven, GetParam());
  run.to(6.3, 63);
  EXPECT_NEAR(spring(run).q, 630.0, 1e-6);  // what the projection leaves of the drive's angle, and more
}

INSTANTIATE_TEST_SUITE_P(Integrators, WheelOnASpring, ::testing::Values("one_step", "ida"));

// A body turned by `phi` about a unit axis away from a bushing to the ground: generalized force [6] and energy [J].
struct TurnedBushing {
  TurnedBushing(const Bushing::Parameters& parameters, const Eigen::Vector3d& axis, double phi) {
    BodyState turned;
    turned.L << std::cos(0.5 * phi), std::sin(0.5 * phi) * axis;
    const int body = model.add_body(Body("body", 1.0, Eigen::Matrix3d::Identity()), turned);
    const Bushing bushing("pivot", ground_marker(Eigen::Vector3d::Zero()),
                          body_marker(body, model.body(body), Eigen::Vector3d::Zero()), parameters);
    const Layout layout(model);
    Kinematics kinematics(model);
    const State state = test::as_given(model).state;
    kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
    const ElementInput in{kinematics.pair(kGround, body), state.z, Eigen::VectorXd()};
    Eigen::VectorXd no_states;
    bushing.add_force(in, Q, no_states);
    StoredEnergy stored;
    Dissipated power;
    bushing.add_energy(in, stored, power);
    energy = stored[Stored::kStrain];
  }
  Model model;
  Eigen::VectorXd Q = Eigen::VectorXd::Zero(6);
  double energy = 0.0;
};

TEST(Bushing, TurnsBackByStiffnessTimesAngleAtAnyAngle) {
  Bushing::Parameters parameters;
  parameters.rotational_stiffness.setConstant(0.4);
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 2.0) / 3.0;
  for (const double degrees : {0.0, 1e-6, 0.1, 1.0, 5.7, 5.8, 30.0, 90.0, 120.0, 170.0, 174.9}) {
    const double phi = degrees * kPi / 180.0;
    const TurnedBushing turned(parameters, axis, phi);
    const Eigen::Vector3d torque = turned.Q.tail<3>();
    // Round-off of the dot products, which the nearness of half a turn magnifies.
    EXPECT_LT((torque + 0.4 * phi * axis).norm(), 1e-13) << degrees;
    EXPECT_NEAR(turned.energy, 0.5 * 0.4 * phi * phi, 1e-13) << degrees;
  }
}

TEST(Bushing, StoresTheSquareOfEachAxisShareOfTheRotation) {
  // V = 1/2 sum k_i theta_i^2, theta = phi times the axis.
  Bushing::Parameters parameters;
  parameters.rotational_stiffness = {3.0, 4.0, 6.0};
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 2.0) / 3.0;
  for (const double phi : {1e-3, 0.5, 2.0, 3.0}) {
    const Eigen::Vector3d theta = phi * axis;
    const double energy = 0.5 * theta.dot(parameters.rotational_stiffness.cwiseProduct(theta));
    EXPECT_NEAR(TurnedBushing(parameters, axis, phi).energy, energy, 1e-12 * energy) << phi;  // round-off
  }
}

TEST(Bushing, SaysThatHalfATurnIsTooMuch) {
  Bushing::Parameters parameters;
  parameters.rotational_stiffness = {3.0, 4.0, 6.0};
  for (const double degrees : {175.1, 180.0, 184.0}) {
    try {
      TurnedBushing(parameters, Eigen::Vector3d::UnitX(), degrees * kPi / 180.0);
      ADD_FAILURE() << degrees;
    } catch (const NumericalError& error) {
      EXPECT_NE(std::string(error.what()).find("\"pivot\""), std::string::npos) << error.what();
    }
  }
  // A damper knows no angle.
  parameters.rotational_stiffness.setZero();
  EXPECT_NO_THROW(TurnedBushing(parameters, Eigen::Vector3d::UnitX(), kPi));
}

TEST(Strut, SharesStrokeAndRateAmongItsLaws) {
  Model model;
  BodyState above;
  above.r = {0.0, 0.0, 0.8};
  above.dr = {0.3, 0.0, -0.5};
  const int body = model.add_body(Body("body", 1.0, Eigen::Matrix3d::Identity()), above);
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{100.0, 0.0, 0.0, 0.0}));
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{0.0, 10.0, 0.0, 0.0}));
  const Strut strut("strut", ground_marker(Eigen::Vector3d::Zero()),
                    body_marker(body, model.body(body), Eigen::Vector3d::Zero()), std::move(laws), 1.0);
  const Layout layout(model);
  Kinematics kinematics(model);
  const State state = test::as_given(model).state;
  kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
  const StrutSample sample = strut.sample({kinematics.pair(kGround, body), state.z, Eigen::VectorXd()});
  EXPECT_DOUBLE_EQ(sample.stroke, 1.0 - 0.8);
  EXPECT_DOUBLE_EQ(sample.rate, 0.5);
  EXPECT_DOUBLE_EQ(sample.force, 100.0 * (1.0 - 0.8) + 10.0 * 0.5);
}

TEST(Strut, RefusesALengthThatIsNotPositive) {
  EXPECT_THROW(Strut("s", ground_marker(Eigen::Vector3d::Zero()),
                     Marker{0, {}, Eigen::Matrix3d::Identity(), {}, {}, {}}, {}, 0.0),
               InputError);
}

}  // namespace
}  // namespace footfall
