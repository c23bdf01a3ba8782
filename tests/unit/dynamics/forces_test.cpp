// Force elements: their law, their energy, contact with a plane.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <type_traits>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/dynamics/energy_flow.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "mbd_solver/model/laws/springs.h"
#include "tests/support/refused.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

// mbd_solver/model/force_element.h:
// energy of every force element: what it takes from the motion is stored or dissipated.

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
    const test::OwnScratch own(element);
    element.add_energy(own.with({kinematics.pair(element.bodies()[0], element.bodies()[1]), moved.z, voltages}), energy,
                       power);
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
    const test::OwnScratch own(*element);
    const ElementInput in = own.with({pair, state.z, voltages});
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
    EXPECT_NEAR(taken, given, 1e-7 * (std::abs(taken) + std::abs(power.total()) + std::abs(supplied.total())))
        << element->name();  // error of the difference
    // What elastic ground gives back within its rebound counts with what it has taken.
    const bool soil = element->name().rfind("rft", 0) == 0 || element->name().rfind("sinkage", 0) == 0;
    for (double part : power.by_kind) EXPECT_TRUE(soil || part >= 0.0) << element->name();
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, ForceElementEnergy,
                         ::testing::Values(std::make_pair(0, 2), std::make_pair(0, 1), std::make_pair(1, 3),
                                           std::make_pair(kGround, 1), std::make_pair(2, kGround)));

// mbd_solver/model/elements/contact_element.h
TEST(ContactElement, OfEveryKindReportsTheForceThatItExertsOnItsFirstBody) {
  test::Random random(29);
  const Model model = test::random_bodies(random);
  const Layout layout(model);
  const State state = test::as_given(model).state;
  Kinematics kinematics(model);
  kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
  std::set<ContactKind> kinds;
  for (const std::unique_ptr<ForceElement>& element : test::all_forces(random, model, 0, 2)) {
    const auto* contact = dynamic_cast<const ContactElement*>(element.get());
    if (contact == nullptr) continue;
    kinds.insert(contact->kind());
    const PairMotion pair = kinematics.pair(contact->bodies()[0], contact->bodies()[1]);
    const Eigen::VectorXd z = contact->initial_state();
    const test::OwnScratch own(*contact);
    const ElementInput in = own.with({pair, z, Eigen::VectorXd()});
    Eigen::VectorXd Q = Eigen::VectorXd::Zero(pair.size()), dz(contact->state_count());
    contact->add_force(in, Q, dz);
    EXPECT_GT(contact->largest_overlap(in), 0.0) << contact->name();
    EXPECT_GT(Q.norm(), 0.0) << contact->name();
    EXPECT_LT((contact->wrench(in) - Q.segment<6>(pair.offset(0))).norm(), 1e-12 * Q.norm()) << contact->name();
  }
  EXPECT_EQ(kinds.size(), every<ContactKind>().size());
}

// mbd_solver/model/model.h
TEST(Handle, HasTheTypeOfItsElement) {
  static_assert(std::is_convertible_v<Handle<RigidPlane>, Handle<ContactElement>>);
  static_assert(!std::is_convertible_v<Handle<ContactElement>, Handle<RigidPlane>>);
  static_assert(!std::is_constructible_v<Handle<Strut>, int>, "only a model makes handles");
  test::Random random(31);
  Model model = test::random_bodies(random);
  const test::MarkerPair at = test::random_markers(random, model, 0, 2);
  const auto first = model.add_force(torsional_spring("first", at.m1, at.m2, {1.0, 0.0, 0.0, 0.0})),
             second = model.add_force(torsional_spring("second", at.m1, at.m2, {2.0, 0.0, 0.0, 0.0}));
  static_assert(std::is_same_v<decltype(second), const Handle<JointForce>>);
  EXPECT_EQ(first.of(model).name(), "first");
  EXPECT_EQ(second.of(model).name(), "second");
  EXPECT_EQ(second.index(), 1);
  EXPECT_TRUE(second);
  EXPECT_FALSE(Handle<JointForce>());
}

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
  SharedCopies shared;
  const std::unique_ptr<ElementScratch> scratch = plane.scratch(shared);
  for (double speed : {-100.0, -1.0, 0.0, 1.0, 100.0}) {
    state.v[2] = speed;
    kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
    ElementInput in{kinematics.pair(ball, kGround), plane.initial_state(), Eigen::VectorXd()};
    in.scratch = scratch.get();
    EXPECT_GE(plane.wrench(in)[2], 0.0) << speed;
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
  const test::OwnScratch own(plane);
  const ElementInput in = own.with({kinematics.pair(1, kGround), state.z, Eigen::VectorXd()});
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
    spring = model.add_force(torsional_spring("spring", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                              model.marker_at(wheel, Eigen::Vector3d::Zero()), parameters));
  }
  // Of angles of 6 rad and rates of 12 rad/s, each of some ten thousand steps exact to 1e-9. A missed turn is 6.3.
  static constexpr double kTolerance = 1e-4;
  Model model;
  Handle<JointForce> spring;
};

TEST_P(WheelOnASpring, TurnsBackAtSixRadians) {
  test::Run run(model, GetParam(), test::tight(1e-9));
  for (int k = 1; k <= 12; ++k) {
    run.to(0.25 * k);
    const double t = run.state.time;
    EXPECT_NEAR(sample_of(run, spring).q, 6.0 * std::sin(2.0 * t), kTolerance) << t;
    EXPECT_NEAR(sample_of(run, spring).rate, 12.0 * std::cos(2.0 * t), kTolerance) << t;
    EXPECT_LT(std::abs(run.imbalance()), 1e-6 * run.start_energy()) << t;  // order of the integrator's own error
  }
}

TEST_P(WheelOnASpring, KnowsItsTurnsAfterAResumption) {
  // The state alone tells the turn: a run that starts from it continues the same.
  test::Run first(model, GetParam(), test::tight(1e-9)), second(model, GetParam(), test::tight(1e-9));
  first.to(0.7);
  second.state = first.state;
  EXPECT_NEAR(sample_of(second, spring).q, 6.0 * std::sin(1.4), kTolerance);
  second.to(1.2);
  EXPECT_NEAR(sample_of(second, spring).q, 6.0 * std::sin(2.4), kTolerance);
}

TEST_P(WheelOnASpring, CountsAHundredTurns) {
  // Driven at 100 rad/s, the angle follows the drive, whatever the inner state has gathered of errors.
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
  const Handle<JointForce> spring_of_it =
      driven.add_force(torsional_spring("spring", driven.marker_at(kGround, Eigen::Vector3d::Zero()),
                                        driven.marker_at(wheel, Eigen::Vector3d::Zero()), parameters));
  test::Run run(driven, GetParam());
  run.to(6.3, 63);
  EXPECT_NEAR(sample_of(run, spring_of_it).q, 630.0,
              1e-6);  // what the projection leaves of the drive's angle, and more
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
    const test::OwnScratch own(bushing);
    const ElementInput in = own.with({kinematics.pair(kGround, body), state.z, Eigen::VectorXd()});
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
    EXPECT_TRUE(test::names(test::error_of<NumericalError>(
                                [&] { TurnedBushing(parameters, Eigen::Vector3d::UnitX(), degrees * kPi / 180.0); }),
                            {"pivot"}));
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
  const StrutSample sample =
      strut.sample(test::OwnScratch(strut).with({kinematics.pair(kGround, body), state.z, Eigen::VectorXd()}));
  EXPECT_DOUBLE_EQ(sample.stroke, 1.0 - 0.8);
  EXPECT_DOUBLE_EQ(sample.rate, 0.5);
  EXPECT_DOUBLE_EQ(sample.force, 100.0 * (1.0 - 0.8) + 10.0 * 0.5);
}

TEST(Strut, RefusesALengthThatIsNotPositive) {
  EXPECT_THROW(Strut("s", ground_marker(Eigen::Vector3d::Zero()),
                     Marker{0, {}, Eigen::Matrix3d::Identity(), {}, {}, {}}, {}, 0.0),
               InputError);
}

// mbd_solver/model/elements/forces.h: forces and torques over time on free bodies, against exact motions.

// Of fifth order: a second-order run would take ten thousand steps for the same.
constexpr double kMass = 2.0, kInertia = 0.5;  // [kg], about every axis [kg m2]
// rtol of the runs is 1e-11; positions, speeds and works are of order one to ten, and works are summed step by step.
constexpr double kTolerance = 1e-7;

struct FreeBody {
  FreeBody(const Eigen::Vector3d& p_B, std::optional<Eigen::Vector3d> direction, TimeFunctionPtr force,
           TimeFunctionPtr torque, const BodyState& initial = {}) {
    model.add_body(Body("body", kMass, kInertia * Eigen::Matrix3d::Identity()), initial);
    Eigen::Matrix3d axes;  // z of the marker is x of the body
    axes << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
    model.add_force(std::make_unique<AppliedForce>("push", body_marker(0, model.body(0), p_B, axes), direction,
                                                   std::move(force), std::move(torque)));
  }
  Model model;
};

TEST(AppliedForce, ConstantMovesABodyAlongAParabola) {
  const FreeBody body(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), polynomial({3.0}), nullptr);
  test::Run run(body.model, "one_step", test::precise(1e-11));
  run.to(2.0);
  EXPECT_NEAR(run.body(0).r.z(), 0.5 * 3.0 / kMass * 4.0, kTolerance);
  EXPECT_NEAR(run.body(0).dr.z(), 3.0 / kMass * 2.0, kTolerance);
  EXPECT_NEAR(run.state.supplied[Supply::kForce], 3.0 * 3.0, kTolerance);  // F s
  EXPECT_NEAR(run.imbalance(), 0.0, kTolerance);
}

TEST(AppliedForce, TorqueSpinsUpOverTime) {
  // m(t) = 0.2 + 0.6 t:  w = (0.2 t + 0.3 t^2) / I, about x of the body
  const FreeBody body(Eigen::Vector3d(0.3, 0.2, 0.1), std::nullopt, nullptr, polynomial({0.2, 0.6}));
  test::Run run(body.model, "one_step", test::precise(1e-11));
  run.to(2.0);
  const double w = (0.4 + 1.2) / kInertia;
  EXPECT_NEAR(run.body(0).w.x(), w, kTolerance);
  EXPECT_NEAR(run.body(0).r.norm(), 0.0, kTolerance);
  EXPECT_NEAR(run.state.supplied[Supply::kForce], 0.5 * kInertia * w * w, kTolerance);
}

// A force along x of a body that spins about z at W turns with it: the acceleration is a circle.
//   v = F / (m W) [sin W t, 1 - cos W t],  r = F / (m W^2) [1 - cos W t, W t - sin W t]
TEST(AppliedForce, FollowsTheBody) {
  const double F = 3.0, W = 5.0, t = 1.7;
  BodyState initial;
  initial.w = W * Eigen::Vector3d::UnitZ();
  const FreeBody body(Eigen::Vector3d::Zero(), std::nullopt, polynomial({F}), nullptr, initial);
  test::Run run(body.model, "one_step", test::precise(1e-11));
  run.to(t);
  const Eigen::Vector3d r = F / (kMass * W * W) * Eigen::Vector3d(1.0 - std::cos(W * t), W * t - std::sin(W * t), 0.0);
  const Eigen::Vector3d v = F / (kMass * W) * Eigen::Vector3d(std::sin(W * t), 1.0 - std::cos(W * t), 0.0);
  EXPECT_LT((run.body(0).r - r).norm(), kTolerance);
  EXPECT_LT((run.body(0).dr - v).norm(), kTolerance);
  EXPECT_NEAR(run.imbalance(), 0.0, kTolerance);
}

// At a point off the centre a fixed force is a pendulum's weight, and conserves F.p - energy.
TEST(AppliedForce, StandsInSpaceAndMovesWithItsPoint) {
  const double F = 4.0;
  const FreeBody body(Eigen::Vector3d(0.4, 0.0, 0.0), -F / F * Eigen::Vector3d::UnitZ(), polynomial({F}), nullptr);
  test::Run run(body.model, "one_step", test::precise(1e-11));
  run.to(1.5);
  const BodyKinematics at = run.body(0);
  const double fallen = 0.0 - (at.r + at.A * Eigen::Vector3d(0.4, 0.0, 0.0)).z();
  EXPECT_NEAR(at.r.z(), -0.5 * F / kMass * 1.5 * 1.5, kTolerance);  // the centre moves as a point
  EXPECT_NEAR(run.state.supplied[Supply::kForce], F * fallen, kTolerance);
  EXPECT_GT(std::abs(at.w.y()), 1.0);
}

TEST(AppliedForce, IsTheSameOnBothIntegrators) {
  const FreeBody body(Eigen::Vector3d(0.1, 0.2, 0.3), std::nullopt, sine(3.0, 2.0), sine(0.5, 1.0, 0.3));
  test::Run one(body.model, "one_step", test::precise(1e-10)), other(body.model, "ida", test::precise(1e-10));
  one.to(1.0);
  other.to(1.0);
  EXPECT_LT((one.state.q - other.state.q).norm(), 1e-6);  // the errors of both
}

// mbd_solver/model/elements/rigid_plane.h. Friction on a slope and on the flat: what sticks stays, what slides has mu f_n.

constexpr double kGravity = 9.81, kBlockMass = 2.0, kStiffness = 1e6;

// A block that stands on a plane through the origin, inclined about y, on a grid of points; x runs down the slope.
struct Block {
  Block(double slope, double friction, double speed, int points_per_side = 2)
      : down(std::cos(slope), 0.0, -std::sin(slope)) {
    plane.normal = {std::sin(slope), 0.0, std::cos(slope)};
    plane.stiffness = kStiffness;
    plane.damping = 10.0;
    plane.friction = friction;
    const int count = points_per_side * points_per_side;
    const double overlap = std::pow(kBlockMass * kGravity * std::cos(slope) / (count * kStiffness), 2.0 / 3.0);
    BodyState state;
    state.L = quaternion_about(Eigen::Vector3d::UnitY(), slope);
    state.r = (0.05 - overlap) * plane.normal;
    state.dr = speed * down;
    model.add_body(Body("block", kBlockMass, 0.02 * Eigen::Matrix3d::Identity()), state);
    std::vector<ContactPoint> points;
    for (int i = 0; i < count; ++i) {
      const double x = i % points_per_side, y = i / points_per_side;
      const double step = 0.2 / (points_per_side - 1);
      points.push_back({body_marker(0, model.body(0), {x * step - 0.1, y * step - 0.1, -0.05}), 0.0});
    }
    model.add_force(std::make_unique<RigidPlane>("plane", points, plane));
  }
  double way(test::Run& run) const { return run.body(0).r.dot(down); }
  double speed(test::Run& run) const { return run.body(0).dr.norm(); }

  Eigen::Vector3d down;
  RigidPlane::Parameters plane;
  Model model{{0.0, 0.0, -kGravity}};
};

class OnThePlane : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, OnThePlane, ::testing::Values("one_step", "ida"));

TEST_P(OnThePlane, BlockOnASlopeStaysWhereItIs) {
  // 10 degrees ask for 59 % of the friction there is; 16.5 for 98.7 %.
  constexpr double kRest = 1e-6;  // [m/s]
  for (double degrees : {10.0, 16.5}) {
    for (int points_per_side : {2, 12}) {
      const Block block(degrees * kPi / 180.0, 0.3, 0.0, points_per_side);
      test::Run run(block.model, GetParam());
      // Near the limit it slides a little first, until the springs are nearly full: they fill ever more slowly.
      const double settled = degrees < 15.0 ? 1.0 : 3.0;  // [s]
      run.to(settled);
      const double way = block.way(run);
      EXPECT_LT(block.speed(run), kRest) << degrees;
      run.to(settled + 2.0);
      EXPECT_LT(block.speed(run), kRest) << degrees;
      EXPECT_LT(std::abs(block.way(run) - way), 1e-7) << degrees;
      EXPECT_LT(std::abs(run.imbalance()), 1e-4);
    }
  }
}

TEST_P(OnThePlane, BlockSlidesWithMuTimesTheNormalForce) {
  const double slope = 30.0 * kPi / 180.0, mu = 0.2, v = 0.1;
  const Block block(slope, mu, v);
  test::Run run(block.model, GetParam(), test::tight(1e-8));
  const double way = block.way(run);
  run.to(0.5, 3);
  const double acceleration = kGravity * (std::sin(slope) - mu * std::cos(slope));
  // Friction lacks (v_s / v)^2 / 2 of mu f_n, 5e-5 at the start; the block rocks for a moment, as friction acts below it.
  EXPECT_NEAR(block.way(run) - way, 0.5 * v + 0.125 * acceleration, 1e-4);
  EXPECT_LT(std::abs(run.imbalance()), 1e-5 * run.state.dissipated[Dissipation::kFriction]);
}

TEST_P(OnThePlane, ThrownBlockStopsAndStays) {
  const double mu = 0.3, v = 0.5;
  const Block block(0.0, mu, v);
  test::Run run(block.model, GetParam());
  run.to(1.0, 5);
  EXPECT_NEAR(block.way(run), v * v / (2.0 * mu * kGravity), 1e-3);  // it rocks when it stops
  EXPECT_LT(block.speed(run), 1e-6);
  EXPECT_NEAR(run.state.dissipated.total(), 0.5 * kBlockMass * v * v, 1e-4);
  EXPECT_LT(std::abs(run.imbalance()), 1e-4);
}

TEST_P(OnThePlane, TurnedBlockStopsTurning) {
  // Spin about the normal on a slope on which it would stick: friction takes it, and then holds.
  Block block(10.0 * kPi / 180.0, 0.5, 0.0, 4);
  test::Run run(block.model, GetParam());
  run.state.v.segment<3>(3) = 3.0 * block.plane.normal;
  run.to(1.0, 2);
  EXPECT_LT(run.body(0).w.norm(), 1e-5);
  EXPECT_LT(block.speed(run), 1e-6);
}

// The scale of energy errors: what has moved from one form to another, whoever looks on.

// Runs to t_end in windows and takes the flow at each.
double flow_of(test::Run& run, const Model& model, double t_end, int windows) {
  EnergyFlow flow(model);
  Kinematics kinematics(model);
  const auto take = [&] {
    kinematics.load(run.equations.layout(), run.state.q, run.state.v, Eigen::VectorXd());
    flow.sample(run.energy().stored, run.state, kinematics);
  };
  take();
  for (int k = 1; k <= windows; ++k) {
    run.to(t_end * k / windows);
    take();
  }
  return flow.scale();
}

// A crank of 1 kg on an arm of 0.5 m, driven once round within `period` about a level axis.
Model driven_crank(double period) {
  Model model({0.0, 0.0, -10.0});
  BodyState start;
  start.r = {0.0, 0.0, -0.5};
  const int crank = model.add_body(Body("crank", 1.0, 0.01 * Eigen::Matrix3d::Identity()), start);
  PrescribedMotion motion;
  motion.translation = {polynomial({0.0}), polynomial({0.0}), polynomial({0.0})};
  motion.rotation = ramp(0.0, 2.0 * kPi, 0.0, period);
  motion.rotation_axis = 1;
  motion.hold_other_rotations = true;
  model.add_joint(prescribed_joint("drive", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                   model.marker_at(crank, Eigen::Vector3d::Zero()), motion));
  return model;
}

TEST(EnergyFlow, OfASlowCrankIsTheWorkOfItsDrive) {
  // Up by 1 m and down again: the drive lifts 10 J and takes 10 J back. The kinetic energy is 1e-4 of it.
  const Model model = driven_crank(100.0);
  test::Run run(model);
  EXPECT_NEAR(flow_of(run, model, 100.0, 200), 20.0, 0.01);  // extremes between the samples: 1 - cos(pi / 200)
  // The account of that run closes to some mJ: well of 20 J, and three times the kinetic energy it was set against.
  EXPECT_LT(std::abs(run.imbalance()), 0.01 * 20.0);
}

// Two wheels of unequal inertia on a spring that turns them against each other, thrown; the bearing flies with them.
Model two_wheels(const Eigen::Vector3d& frame) {
  Model model;
  BodyState a, b;
  a.dr = b.dr = frame;
  a.w = {0.0, 0.0, 1.0};
  const int first = model.add_body(Body("a", 2.0, 0.3 * Eigen::Matrix3d::Identity()), a);
  const int second = model.add_body(Body("b", 1.0, 0.1 * Eigen::Matrix3d::Identity()), b);
  model.add_joint(revolute_joint("bearing", model.marker_at(first, Eigen::Vector3d::Zero()),
                                 model.marker_at(second, Eigen::Vector3d::Zero())));
  LinearSpringDamperParameters parameters;
  parameters.stiffness = 4.0;
  parameters.damping = 0.05;
  model.add_force(torsional_spring("spring", model.marker_at(first, Eigen::Vector3d::Zero()),
                                   model.marker_at(second, Eigen::Vector3d::Zero()), parameters));
  return model;
}

TEST(EnergyFlow, IsTheSameInAMovingFrame) {
  const Model still = two_wheels(Eigen::Vector3d::Zero());
  const Model moving = two_wheels({100.0, -30.0, 20.0});
  test::Run at_rest(still, "one_step", test::tight(1e-9)), in_flight(moving, "one_step", test::tight(1e-9));
  const double flow = flow_of(at_rest, still, 2.0, 100);
  EXPECT_GT(flow, 0.1);
  // Tolerances are relative to velocities of 100 m/s there.
  EXPECT_NEAR(flow_of(in_flight, moving, 2.0, 100), flow, 1e-5 * flow);
}

TEST(EnergyFlow, OfAFreeSpinIsItsKineticEnergy) {
  Model model;
  BodyState spin;
  spin.dr = {100.0, 0.0, 0.0};
  spin.w = {0.0, 0.0, 3.0};
  model.add_body(Body("top", 1.0, 0.2 * Eigen::Matrix3d::Identity()), spin);
  test::Run run(model);
  EXPECT_NEAR(flow_of(run, model, 1.0, 10), 0.5 * 0.2 * 9.0, 1e-9);  // round-off of 5000 J
}

// A scale by each of its parts: energy that flows, a spin that is over, a form that was large.
TEST(EnergyFlow, IsTheSameFromACheckpoint) {
  Model model;
  BodyState spin;
  spin.w = {0.0, 0.0, 3.0};
  model.add_body(Body("top", 1.0, 0.2 * Eigen::Matrix3d::Identity()), spin);
  const Layout layout(model);
  Kinematics kinematics(model);
  State state = test::as_given(model).state;
  kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
  for (const auto& [kinetic, gravity] : {std::pair(3.0, 0.0), std::pair(0.0, 1e12), std::pair(0.01, 0.02)}) {
    EnergyFlow flow(model), resumed(model);
    StoredEnergy stored{};
    stored[Stored::kKinetic] = kinetic;
    stored[Stored::kGravity] = gravity;
    flow.sample(stored, state, kinematics);
    Archive saved;
    flow.visit(saved);
    Archive text("run.txt", saved.text());
    resumed.visit(text);
    text.finish();
    EXPECT_GT(flow.scale(), 0.0);
    EXPECT_EQ(resumed.scale(), flow.scale());
    stored[Stored::kKinetic] = 0.5 * kinetic;
    flow.sample(stored, state, kinematics);
    resumed.sample(stored, state, kinematics);
    EXPECT_EQ(resumed.scale(), flow.scale());
  }
}

}  // namespace
}  // namespace footfall
