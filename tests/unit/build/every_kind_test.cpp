// Every kind of joint, strut law, spring and controller that a scene can name (mbd_solver/build/mechanism.h): it is built as what it is called, its
// derivatives are those of its residual, and it keeps the account of the energy. The kinds are those of the reader's
// own lists; a kind without a scene in kind_scenes.h fails.

#include <gtest/gtest.h>

#include <algorithm>

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/model/elements/strut.h"
#include "tests/unit/build/kind_scenes.h"
#include "tests/unit/dynamics/jacobian_check.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::TestWithParam;
using ::testing::ValuesIn;

std::string name_of_test(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  const StrutSpec strut;
  each_law(strut, [&](const char* key, const auto&) { names.emplace_back(key); });
  return names;
}

Mechanism build(const std::string& toml) { return build_mechanism(SceneText().read(toml)); }

Inputs inputs_of(const Mechanism& mechanism) {
  Inputs inputs;
  inputs.voltages = mechanism.voltages;
  return inputs;
}

// At a random velocity and somewhat off the design position. Forces and joints of kind_scenes.h vary over some 0.1 m
// and are of order 100 N, so that differences over 1e-6 are exact to some 1e-9 of the largest entry; curvatures of a
// stop's toe and of a tabulated law take up to 1e-7.
void expect_derivatives(const Mechanism& mechanism) {
  constexpr double kTolerance = 1e-7;
  test::Random random(11);
  const Assembly given = test::as_given(mechanism.model);
  Equations equations(mechanism.model, given);
  const Layout& layout = equations.layout();
  Eigen::VectorXd y(layout.size());
  State state = given.state;
  state.v = random.vector_x(layout.v_size);
  equations.pack(state, random.vector_x(layout.row_count, 5.0), y);
  y.head(layout.q_size) += random.vector_x(layout.q_size, 0.01);
  const Eigen::VectorXd ydot = random.vector_x(layout.size(), 3.0);
  std::string where;
  EXPECT_LT(test::jacobian_error(equations, y, ydot, 7.0, inputs_of(mechanism), &where), kTolerance) << where;
}

constexpr double kActs = 1e-4;  // of the kinetic energy: less than this share, and an element does nothing

// Free motion for a while: what energy there is, is what there was, plus what prescribed motions brought, minus what
// was dissipated. Returns what the elements held or took at most, over the kinetic energy at the start.
double expect_energy_balance(const Mechanism& mechanism) {
  // Of the largest energy in play. The error of the integration is a tenth of it; a force that is missing from the
  // account, or a wrong sign, shows with its whole work, kActs and more.
  constexpr double kTolerance = 1e-6;
  test::Run run(mechanism.model, "one_step", test::tight(1e-11));
  run.inputs = inputs_of(mechanism);
  const double kinetic = run.energy().stored[Stored::kKinetic];
  double exchanged = 0.0, largest = kinetic;
  for (int i = 1; i <= 4; ++i) {
    run.to(0.025 * i);
    const StoredEnergy stored = run.energy().stored;
    exchanged = std::max(exchanged, stored[Stored::kStrain] + stored[Stored::kGas] + run.state.dissipated.total());
    largest = std::max(largest, stored[Stored::kKinetic] + exchanged);
    EXPECT_LT(std::abs(run.imbalance()), kTolerance * largest) << "at " << run.state.time << " s";
    EXPECT_LT(run.equations.drift(run.state).position, 1e-8);  // what the projection leaves [m, rad]
  }
  for (const double part : run.state.dissipated.by_kind) EXPECT_GE(part, 0.0);
  return exchanged / kinetic;
}

class EveryJointType : public TestWithParam<std::string> {};

TEST_P(EveryJointType, IsBuiltAsWhatItIsCalledAndClosed) {
  const Mechanism mechanism = build(test::joint_scene(GetParam()));
  ASSERT_EQ(mechanism.model.joint_count(), 1);
  EXPECT_EQ(mechanism.model.joint(0).kind, GetParam());
  EXPECT_LT(assemble(mechanism.model).largest_gap, 1e-12);  // round-off of numbers of order one
}

TEST_P(EveryJointType, HasTheDerivativesOfItsResidual) { expect_derivatives(build(test::joint_scene(GetParam()))); }

TEST_P(EveryJointType, DoesNoWorkButThatOfItsMotion) { expect_energy_balance(build(test::joint_scene(GetParam()))); }

INSTANTIATE_TEST_SUITE_P(Registered, EveryJointType, ValuesIn(names_of<JointType>()), name_of_test);

TEST(Gears, HaveTheDerivativesOfTheirResidualAndDoNoWork) {
  const Mechanism mechanism = build(test::gear_scene());
  ASSERT_EQ(mechanism.gears.size(), 2u);
  EXPECT_EQ(mechanism.gears[0].coordinate, Coordinate::kDisplacement);
  EXPECT_EQ(mechanism.model.joint(mechanism.gears[0].joint).kind, "gear");
  expect_derivatives(mechanism);
  expect_energy_balance(mechanism);
}

TEST(PlanarJoints, HaveLawsDrivesAndGearsOnTheirThreeCoordinates) {
  const Mechanism mechanism = build(test::planar_scene());
  ASSERT_EQ(mechanism.coordinates.size(), 3u);
  EXPECT_EQ(mechanism.coordinates[1].coordinate, Coordinate::kDisplacementX);
  EXPECT_EQ(mechanism.drives[0].coordinate, Coordinate::kDisplacementY);
  // x lies as drawn, across the axis.
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized(), x(1, -1, 0.2);
  const Eigen::Vector3d drawn = mechanism.placement.R_WD * (x - x.dot(axis) * axis).normalized();
  const Joint& table = mechanism.model.joint(0);
  const BodyState& a = mechanism.model.initial(0);
  EXPECT_LT((rotation_matrix(a.L) * table.m1.axes.col(0) - drawn).norm(), 1e-12);
  expect_derivatives(mechanism);
  EXPECT_GT(expect_energy_balance(mechanism), kActs);
}

// The tests of tests/unit/dynamics take their joints, between flexible bodies too, from one list.
TEST(JointSpecimens, AreOneOfEachType) {
  test::Random random(1);
  const Model model = test::random_bodies(random);
  std::vector<std::string> kinds;
  for (const Joint& joint : test::all_joints(random, model, 0, 1)) kinds.push_back(joint.kind);
  EXPECT_EQ(kinds, names_of<JointType>());
}

class EveryStrutLaw : public TestWithParam<std::string> {};

TEST_P(EveryStrutLaw, HasTheDerivativesOfItsResidual) { expect_derivatives(build(test::law_scene(GetParam()))); }

TEST_P(EveryStrutLaw, StoresOrDissipatesWhatItTakes) {
  const Mechanism mechanism = build(test::law_scene(GetParam()));
  ASSERT_EQ(mechanism.struts.size(), 1u);
  EXPECT_FALSE(static_cast<const Strut&>(mechanism.model.force(0)).laws().empty());
  EXPECT_GT(expect_energy_balance(mechanism), kActs);
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryStrutLaw, ValuesIn(law_names()), name_of_test);

class EverySpringKind : public TestWithParam<std::string> {};

TEST_P(EverySpringKind, HasTheDerivativesOfItsResidual) { expect_derivatives(build(test::spring_scene(GetParam()))); }

TEST_P(EverySpringKind, StoresOrDissipatesWhatItTakes) {
  const Mechanism mechanism = build(test::spring_scene(GetParam()));
  ASSERT_EQ(mechanism.model.force_count(), 1);
  EXPECT_GT(expect_energy_balance(mechanism), kActs);
}

INSTANTIATE_TEST_SUITE_P(Registered, EverySpringKind, ValuesIn(names_of<SpringKind>()), name_of_test);

class EveryForceFrame : public TestWithParam<std::string> {};

TEST_P(EveryForceFrame, HasTheDerivativesOfItsResidual) { expect_derivatives(build(test::force_scene(GetParam()))); }

TEST_P(EveryForceFrame, BringsTheEnergyThatTheBodyGets) {
  const Mechanism mechanism = build(test::force_scene(GetParam()));
  test::Run run(mechanism.model, "one_step", test::tight(1e-11));
  const double before = run.energy().stored.total();
  run.to(0.1);
  EXPECT_GT(std::abs(run.state.supplied[Supply::kForce]), kActs * before);
  EXPECT_LT(std::abs(run.imbalance()), 1e-8 * before);  // of the integration
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryForceFrame, ValuesIn(names_of<ForceFrame>()), name_of_test);

class EveryDriveKind : public TestWithParam<std::string> {};

TEST_P(EveryDriveKind, HasTheDerivativesOfItsResidual) { expect_derivatives(build(test::drive_scene(GetParam()))); }

TEST_P(EveryDriveKind, BringsTheEnergyThatTheMechanismGets) {
  const Mechanism mechanism = build(test::drive_scene(GetParam()));
  ASSERT_EQ(mechanism.drives.size(), 1u);
  EXPECT_GT(expect_energy_balance(mechanism), kActs);
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryDriveKind, ValuesIn(names_of<MotorKind>()), name_of_test);

class EverySignalKind : public TestWithParam<std::string> {};

TEST_P(EverySignalKind, HasTheDerivativesOfItsResidual) { expect_derivatives(build(test::signal_scene(GetParam()))); }

TEST_P(EverySignalKind, DrivesAForceWhoseWorkIsCounted) {
  const Mechanism mechanism = build(test::signal_scene(GetParam()));
  ASSERT_EQ(mechanism.signals.size(), 1u);
  EXPECT_EQ(mechanism.sampled.empty(), GetParam() != "rate_limit");
  EXPECT_EQ(mechanism.model.signals() == nullptr, GetParam() == "rate_limit");
  test::Run run(mechanism.model, "one_step", test::tight(1e-12));
  run.inputs = inputs_of(mechanism);
  const double before = run.energy().stored.total();
  run.to(0.1);
  EXPECT_GT(std::abs(run.state.supplied[Supply::kForce]), kActs * before);
  EXPECT_LT(std::abs(run.imbalance()), 1e-8 * before);  // of the integration
}

INSTANTIATE_TEST_SUITE_P(Registered, EverySignalKind, ValuesIn(names_of<SignalKind>()), name_of_test);

// The law of a strut is called by its section alone: two sections must not build the same law.
TEST(StrutLaws, EachSectionBuildsALawOfItsOwn) {
  std::vector<std::string> kinds;
  for (const std::string& law : law_names()) {
    const Mechanism mechanism = build(test::law_scene(law));
    kinds.emplace_back(static_cast<const Strut&>(mechanism.model.force(0)).laws().front()->kind());
  }
  std::sort(kinds.begin(), kinds.end());
  EXPECT_EQ(std::adjacent_find(kinds.begin(), kinds.end()), kinds.end());
}

class EveryControllerKind : public TestWithParam<std::string> {
 protected:
  // A landing in short: free fall, a blow, and some rocking.
  static ControllerMeasurement measurement(int k, double period) {
    const double t = k * period;
    ControllerMeasurement m;
    m.time = t;
    m.acceleration = t < 0.02 ? -1.6 : 30.0 * std::exp(-20.0 * (t - 0.02));
    m.velocity = -2.0 + 10.0 * t;
    m.pitch = 0.05 * std::sin(40.0 * t);
    m.roll = 0.03 * std::cos(30.0 * t);
    m.strut_rate = Eigen::Vector3d(std::sin(60.0 * t), std::cos(50.0 * t), 0.5);
    return m;
  }
};

TEST_P(EveryControllerKind, IsBuiltAsWhatItIsCalledAndStaysWithinItsVoltages) {
  const Mechanism mechanism = build(test::controller_scene(GetParam()));
  ASSERT_EQ(mechanism.controllers.size(), 1u);
  Controller& controller = *mechanism.controllers[0].controller;
  EXPECT_EQ(controller.kind(), GetParam());
  ASSERT_EQ(controller.output_count(), 3);
  Eigen::VectorXd voltages(3);
  for (int k = 0; k < 100; ++k) {
    controller.sample(measurement(k, controller.period()), voltages);
    EXPECT_TRUE(voltages.allFinite());
    EXPECT_GE(voltages.minCoeff(), 0.0);
    EXPECT_LE(voltages.maxCoeff(), 1.0);
  }
}

TEST_P(EveryControllerKind, ResumesToTheBit) {
  const Mechanism whole = build(test::controller_scene(GetParam())), later = build(test::controller_scene(GetParam()));
  Controller& first = *whole.controllers[0].controller;
  Controller& second = *later.controllers[0].controller;
  Eigen::VectorXd voltages(3), resumed(3);
  for (int k = 0; k < 30; ++k) first.sample(measurement(k, first.period()), voltages);
  second.restore(first.memory());
  for (int k = 30; k < 60; ++k) {
    first.sample(measurement(k, first.period()), voltages);
    second.sample(measurement(k, second.period()), resumed);
    EXPECT_EQ(voltages, resumed) << "sample " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryControllerKind, ValuesIn(names_of<ControllerKind>()), name_of_test);

}  // namespace
}  // namespace footfall
