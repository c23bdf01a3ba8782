// From a Scene to a mechanism.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/elements/soil_contact.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/rotation.h"
#include "tests/support/refused.h"
#include "tests/unit/assemble/kind_scenes.h"
#include "tests/unit/dynamics/jacobian_check.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

// Every kind of joint, strut law, spring and controller that a scene can name (mbd_solver/assemble/mechanism.h): it is built as what it is called, its
// derivatives agree with its residual, and it keeps the account of the energy. The kinds come from the reader's
// own lists; a kind without a scene in kind_scenes.h fails.

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
  inputs.values = mechanism.inputs;
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
  equations.layout().pack(state, random.vector_x(layout.row_count, 5.0), y);
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
    EXPECT_LT(run.equations.saddle().drift(run.state).position, 1e-8);  // what the projection leaves [m, rad]
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
  EXPECT_FALSE(mechanism.struts[0].force.of(mechanism.model).laws().empty());
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
  const std::string& kind = GetParam();
  const bool sampled = kind == "rate_limit" || kind == "fmu" || kind == "python";
  ASSERT_EQ(mechanism.signals.size(), kind == "fmu" ? 2u : 1u) << "an FMU has a signal per output, too";
  EXPECT_EQ(mechanism.sampled.empty(), !sampled);
  EXPECT_EQ(mechanism.model.signals() == nullptr, sampled || kind == "host") << "whose value is among the inputs";
  test::Run run(mechanism.model, "one_step", test::tight(1e-12));
  run.inputs = inputs_of(mechanism);
  const double before = run.energy().stored.total();
  run.to(0.1);
  EXPECT_GT(std::abs(run.state.supplied[Supply::kForce]), kActs * before);
  EXPECT_LT(std::abs(run.imbalance()), 1e-8 * before);  // of the integration
}

INSTANTIATE_TEST_SUITE_P(Registered, EverySignalKind, ValuesIn(names_of<SignalKind>()), name_of_test);

// Of the ground, of planes and of pairs, whatever their order in the scene: loads on a body are added in this order.
TEST(Contacts, AreOneListByKinds) {
  const std::string law = "stiffness = 1e6, damping = 1";
  const Mechanism mechanism = build(R"(end_time = 1.0
bodies = [{ name = "low", mass = 1, shape = { kind = "box", centre = [0, 0, 0.1], size = [0.3, 0.3, 0.2] } },
          { name = "ball", mass = 1, shape = { kind = "sphere", centre = [0, 0, 0.3], radius = 0.1 } }]
boundaries = [{ body = "low", surface = { element_size = 0.1 } }, { body = "ball", surface = { element_size = 0.1 } }]
contacts = [{ between = ["low", "ball"], )" +
                                    law + R"( },
            { between = ["low", "plane"], point = [0.2, 0, 0], normal = [-1, 0, 0], )" +
                                    law + R"( }]
[ground]
kind = "plane"
plane = { )" + law + " }\n");
  std::vector<std::string> names;
  for (const ContactEntry& entry : mechanism.contacts) names.push_back(entry.force.of(mechanism.model).name());
  EXPECT_EQ(names, (std::vector<std::string>{"ground/low", "ground/ball", "plane_2/low", "contact/low/ball"}));
  EXPECT_TRUE(mechanism.has(ContactKind::kPlane) && mechanism.has(ContactKind::kSurface));
  EXPECT_FALSE(mechanism.has(ContactKind::kTerrain) || mechanism.has(ContactKind::kSoil));
  const ContactElement& pair = mechanism.contacts.back().force.of(mechanism.model);
  EXPECT_EQ(pair.bodies(), (std::array<int, 2>{0, 1}));
}

// A flexible body has points and no surface, a ball has a surface: they touch in either order.
TEST(Contacts, OfAFlexibleBodyAndABallHavePoints) {
  for (const std::string pair : {"\"plate\", \"ball\"", "\"ball\", \"plate\""}) {
    const Mechanism mechanism = build(R"(end_time = 1.0
[materials.steel]
density = 7850
young = 2e11
poisson = 0.3
[[bodies]]
name = "plate"
material = "steel"
shape = { kind = "disc", centre = [0, 0, 0.2], radius = 0.1, thickness = 0.01 }
flexible = { modes = 3, mesh_size = 0.05 }
[[bodies]]
name = "ball"
mass = 1
shape = { kind = "sphere", centre = [0, 0, 0.05], radius = 0.05 }
[[boundaries]]
body = "plate"
surface = { element_size = 0.05 }
[[boundaries]]
body = "ball"
surface = { element_size = 0.05 }
[[contacts]]
stiffness = 1e6
damping = 1
between = [)" + pair + "]\n");
    EXPECT_EQ(mechanism.contacts.size(), 1u) << pair;
  }
}

// The law of a strut is called by its section alone: two sections must not build the same law.
TEST(StrutLaws, EachSectionBuildsALawOfItsOwn) {
  std::vector<std::string> kinds;
  for (const std::string& law : law_names()) {
    const Mechanism mechanism = build(test::law_scene(law));
    kinds.emplace_back(mechanism.struts[0].force.of(mechanism.model).laws().front()->kind());
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

// Where the mechanism starts: mbd_solver/assemble/mechanism.cpp, step by step.

// Two bodies, their mass centre at (1, 0, 2); the lower one touches the ground with a plate 0.4 m wide at z = 1.5.
const std::string kTwoBodies = R"(end_time = 0.1
gravity = [0, 0, -1.62]
[[bodies]]
name = "top"
mass = 1.0
inertia = [0.1, 0.1, 0.1]
position = [1, 0, 3.5]
[[bodies]]
name = "pad"
mass = 3.0
inertia = [0.1, 0.1, 0.1]
position = [1, 0, 1.5]
[[joints]]
name = "weld"
kind = "fixed"
bodies = ["top", "pad"]
point = [1, 0, 2]
[[boundaries]]
body = "pad"
[boundaries.beams]
points = [[0.8, 0, 1.5], [1.2, 0, 1.5]]
radius = 0.05
)";
const Eigen::Vector3d kCentre(1.0, 0.0, 2.0);
const std::string kOnPlane = kTwoBodies +
                             "[ground]\nkind = \"plane\"\n[ground.plane]\nyoung_MPa = 35\nrestitution = 0.4\n" +
                             "impact_speed = 1.0\n";
const std::string kOnGrains = kTwoBodies + "[ground]\nkind = \"particles\"\n[particles]\nscript = \"in.grains\"\n";
constexpr double kRoundOff = 1e-14;

// Of 12 corners the face of a disc would lose 4.5 % of its area.
TEST(SoilContacts, ADiscHasTheAreaOfItsCircle) {
  const SceneText folder;
  const std::string text = R"(end_time = 1
[[bodies]]
name = "pad"
mass = 1.0
shape = { kind = "disc", centre = [0, 0, 0.5], axis = "x", radius = 0.2, thickness = 0.02 }
[[boundaries]]
body = "pad"
surface = { element_size = 0.1 }
[ground]
kind = "soil"
soil = "dry-sand"
[initial]
yaw_deg = 20
)";
  for (const std::string faces : {"auto", "middle"}) {
    const Mechanism mechanism = build_mechanism(folder.read(text, {"boundaries.pad.surface.faces=\"" + faces + "\""}));
    const auto& soil = static_cast<const SoilContact&>(mechanism.contacts.front().force.of(mechanism.model));
    double face = 0.0;
    for (const SoilFacet& facet : soil.facets())
      if (facet.normal.x() > 0.9) face += facet.area;
    EXPECT_NEAR(face, kPi * 0.04, 1e-12) << faces;
  }
}

class PlacementTest : public ::testing::Test {
 protected:
  PlacementTest() {
    folder.write(
        "in.grains",
        "timestep 1e-4\nfix m all mesh/surface file m.stl type 1\nfix mbd all couple/mbd every 4 mesh m pad\nrun 1\n");
  }
  Mechanism built(const std::string& toml, const std::vector<std::string>& settings = {}) const {
    return build_mechanism(folder.read(toml, settings));
  }
  Placement placed(const std::string& toml, const std::vector<std::string>& settings = {}) const {
    return built(toml, settings).placement;
  }
  // Grains as LIGGGHTS dumps them: x y z radius.
  std::vector<std::string> grains(const std::string& lines) const {
    return {"particles.grains=\"" + folder.write("bed.grains", lines) + "\""};
  }
  std::string complaint(const std::string& toml, const std::vector<std::string>& settings) const {
    return test::refusal([&] { placed(toml, settings); });
  }
  SceneText folder;
};

const std::string kHead = "ITEM: TIMESTEP\n0\nITEM: ATOMS x y z radius\n";

std::vector<std::string> operator+(std::vector<std::string> a, const std::string& b) {
  a.push_back(b);
  return a;
}

TEST_F(PlacementTest, OfADrawingThatIsNotMovedIsTheDrawing) {
  const Placement placement = placed(kTwoBodies);
  EXPECT_LT((placement.R_WD - Eigen::Matrix3d::Identity()).norm(), kRoundOff);
  EXPECT_LT(placement.p_WD.norm(), kRoundOff);
  EXPECT_FALSE(placement.ground_known);
}

TEST_F(PlacementTest, TurnsAboutTheTotalMassCentre) {
  const Placement placement =
      placed(kTwoBodies, {"initial.roll_deg=20", "initial.pitch_deg=-35", "initial.yaw_deg=80"});
  EXPECT_LT((placement.point(kCentre) - kCentre).norm(), kRoundOff);
}

// The order of the history and of a body's orientation: Rz(yaw) Ry(pitch) Rx(roll).
TEST_F(PlacementTest, RollPitchAndYawReadBackAsGiven) {
  const Mechanism mechanism = built(kTwoBodies, {"initial.roll_deg=30", "initial.pitch_deg=20", "initial.yaw_deg=40"});
  const Eigen::Vector3d rpy = rpy_from_rotation(rotation_matrix(mechanism.model.initial(0).L));
  EXPECT_LT((rpy * 180.0 / kPi - Eigen::Vector3d(30, 20, 40)).norm(), 1e-12);  // round-off of degrees
  const Scene scene = folder.read(kTwoBodies, {"bodies.top.orientation={rpy_deg=[30,20,40]}"});
  EXPECT_LT((scene.bodies[0].orientation.toRotationMatrix() - mechanism.placement.R_WD).norm(), kRoundOff);
}

TEST_F(PlacementTest, MovesTheWholeDrawing) {
  const Placement placement = placed(kTwoBodies, {"initial.position=[1,2,3]", "initial.yaw_deg=50"});
  EXPECT_LT((placement.point(kCentre) - kCentre - Eigen::Vector3d(1, 2, 3)).norm(), kRoundOff);
}

// The beam touches with its radius of 0.05 m.
TEST_F(PlacementTest, ClearanceIsOfTheLowestPlaceAboveThePlane) {
  const Placement placement = placed(kOnPlane, {"ground.plane.point=[0,0,0.25]", "initial.clearance=0.1"});
  EXPECT_TRUE(placement.ground_known);
  EXPECT_NEAR(placement.ground_height, 0.25, kRoundOff);
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z() - 0.05, 0.35, kRoundOff);
}

// On a slope the nearest place counts, measured straight up.
TEST_F(PlacementTest, ClearanceOnASlopeIsOfThePlaceNearestToIt) {
  const Placement placement = placed(kOnPlane, {"ground.plane.normal=[-0.6,0,0.8]", "initial.clearance=0.1"});
  const double slope = 0.6 / 0.8;  // the plane rises with x
  double smallest = 1e9;
  for (const double x : {0.8, 1.2}) {
    const Eigen::Vector3d p = placement.point({x, 0, 1.5}) - 0.05 * Eigen::Vector3d(-0.6, 0, 0.8);
    smallest = std::min(smallest, p.z() - slope * p.x());
  }
  EXPECT_NEAR(smallest, 0.1, kRoundOff);
}

// A boundary that the plane leaves out does not count.
TEST_F(PlacementTest, ClearanceIsOfWhatThePlaneTouches) {
  const std::string second = "[[boundaries]]\nbody = \"top\"\nbeams = { points = [[1,0,0],[1,0,1]], radius = 0.1 }\n";
  const Placement placement = placed(kOnPlane + second, {"ground.plane.bodies=[\"pad\"]", "initial.clearance=0.1"});
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z() - 0.05, 0.1, kRoundOff);
}

TEST_F(PlacementTest, ClearanceFollowsGravityNotZ) {
  const Placement placement =
      placed(kOnPlane, {"gravity=[-1.62,0,0]", "ground.plane.normal=\"x\"", "initial.clearance=0.1"});
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).x() - 0.05, 0.1, kRoundOff);  // lowest: its ends, 0.05 m thick
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z(), 1.5, kRoundOff);
}

TEST_F(PlacementTest, AStatedSurfaceIsTheGround) {
  const Placement placement = placed(kOnGrains, {"particles.surface_height=0.4", "initial.clearance=0.1"});
  EXPECT_TRUE(placement.ground_known);
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z() - 0.05, 0.5, kRoundOff);
}

// The pad's outline reaches 0.2 m and its beam's radius: a higher grain outside does not count.
TEST_F(PlacementTest, TheHighestGrainUnderTheBoundaryIsItsGround) {
  const Placement placement = placed(
      kOnGrains, grains(kHead + "1.0 0 0.3 0.02\n1.1 0.1 0.35 0.02\n1.5 0 0.9 0.02\n") + "initial.clearance=0.1");
  EXPECT_NEAR(placement.ground_height, 0.37, kRoundOff);
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z() - 0.05, 0.47, kRoundOff);
}

// Its landing site is a tenth wider, and knows how far it may stray.
TEST_F(PlacementTest, TheLandingSiteSeesATenthFartherThanTheOutline) {
  const Placement placement =
      placed(kOnGrains, grains(kHead + "1.0 0 0.3 0.01\n1.28 0 0.5 0.01\n1.3 0 0.9 0.01\n") + "initial.clearance=0.1");
  ASSERT_EQ(placement.sites.size(), 1u);
  EXPECT_NEAR(placement.sites[0].stray, 0.025, kRoundOff);
  EXPECT_NEAR(placement.sites[0].height, 0.51, kRoundOff);  // at 0.28 m, beyond 0.26 but not 0.285
  EXPECT_NEAR(placement.ground_height, 0.31, kRoundOff);
  EXPECT_LT((placement.sites[0].r - placement.point({1, 0, 1.5})).norm(), kRoundOff);
}

// A bed lies level in its box, however gravity is tilted: depths are counted from its surface, along z.
TEST_F(PlacementTest, ABedIsLevelUnderTiltedGravity) {
  const std::vector<std::string> tilted = {"gravity=[0.5,0,-1.5]"};
  const double cosine = 1.5 / std::hypot(0.5, 1.5);
  const Placement known = placed(kOnGrains, tilted + grains(kHead + "1.0 0 0.3 0.02\n").front());
  EXPECT_NEAR(known.bed_height, 0.32, kRoundOff);
  const Placement stated = placed(kOnGrains, tilted + "particles.surface_height=0.4" + "initial.clearance=0.1");
  EXPECT_NEAR(stated.bed_height, 0.4, kRoundOff);
  EXPECT_NEAR(stated.point({0.8, 0, 1.5}).z() - 0.05, 0.4 + 0.1 * cosine, kRoundOff) << "0.1 m along up";
}

TEST_F(PlacementTest, OfSeveralFramesTheLastCounts) {
  const Placement placement = placed(kOnGrains, grains(kHead + "1 0 0.3 0.02\n" + kHead + "1 0 0.2 0.02\n"));
  EXPECT_NEAR(placement.ground_height, 0.22, kRoundOff);
}

TEST_F(PlacementTest, ClearanceAboveGrainsOfUnknownHeightIsRefused) {
  EXPECT_TRUE(test::names(complaint(kOnGrains, {"initial.clearance=0.1"}), {"particles.surface_height"}));
}

TEST_F(PlacementTest, ClearanceWithoutAGrainBelowIsRefused) {
  EXPECT_NE(complaint(kOnGrains, grains(kHead + "5 5 0.3 0.02\n") + "initial.clearance=0.1"), "");
}

TEST_F(PlacementTest, ABrokenDumpIsNamedWithItsLine) {
  EXPECT_TRUE(test::names(complaint(kOnGrains, grains(kHead + "1 0 0.3 0.02\n1 0 soil 0.02\n")),
                          {"bed.grains:5:", "bed.grains"}));
  EXPECT_NE(complaint(kOnGrains, grains("ITEM: TIMESTEP\n0\n")), "");
}

// A bed under a slope of 12 degrees that falls along x, with a rock that protrudes by 6 cm; another is outside of it.
const char* const kBedOnSlope = R"(end_time = 1
gravity = [0, 0, -9.81]
bodies = [{ name = "ball", mass = 1, shape = { kind = "sphere", centre = [0.1, 0, 1], radius = 0.05 } }]
boundaries = [{ body = "ball", surface = {} }]
[initial]
clearance = 0.01
[ground]
kind = "particles"
plane = { stiffness = 1e6 }
[ground.terrain]
slope_deg = 12
rocks = [{ x = -0.1, diameter = 0.1, buried = 0.4 }, { x = 0.6, diameter = 0.8 }]
[particles.box]
size = [0.6, 0.4]
depth = 0.1
radius = 0.01
)";

// By the distance from the plane, and from the rock's centre: 1 cm less. The nodes of the ball's mesh are 0.5 mm from such places at most.
TEST_F(PlacementTest, ClearanceOnABedIsAboveItsTerrainAndRocks) {
  const double slope = std::tan(12.0 * kPi / 180.0), secant = std::hypot(1.0, slope);
  const auto height = [&](const std::vector<std::string>& settings, double x) {
    return placed(kBedOnSlope, settings).point({x, 0, 1}).z();
  };
  EXPECT_NEAR(height({}, 0.1), -0.1 * slope + 0.05 * secant + 0.01, 5e-4);
  const double rock = 0.1 * slope + 0.01;  // its centre
  EXPECT_NEAR(height({"bodies.ball.shape.centre=[-0.1,0,1]"}, -0.1), rock + 0.1 + 0.01, 5e-4);
  EXPECT_NEAR(height({"bodies.ball.shape.centre=[-0.06,0,1]"}, -0.06), rock + std::sqrt(0.01 - 0.0016) + 0.01, 5e-4);
  // Grains of a made bed that stand out of the surface by 4 mm, against the plane, count instead.
  const double z = -0.12 * slope - 0.01 * secant + 0.004;
  const std::vector<std::string> bed = grains(kHead + "0.12 0 " + std::to_string(z) + " 0.01\n0.12 0 -0.06 0.01\n");
  EXPECT_NEAR(height(bed, 0.1) - height({}, 0.1), 0.004, 2e-6);  // six digits
}

// Legs of an array are reduced once: mbd_solver/fe/turned_model.h.

const char* const kHub = R"(end_time = 1.0
[arrays.leg]
count = 3
start_deg = 20
step_deg = 120
axis = [0, 0, 1]
[materials.steel]
density = 7850
young = 207e9
[[bodies]]
name = "hub"
mass = 50
inertia = [5, 5, 5]
position = [0, 0, 0]
)";
const char* const kHips = R"(
[[joints]]
name = "hip_{leg}"
kind = "fixed"
bodies = ["hub", "leg_{leg}"]
point = [0.3, 0, 0.2]
)";

// A tube in each place of the array.
std::string tubes(const std::string& name, const std::string& wall) {
  return "[[bodies]]\nname = \"" + name +
         "_{leg}\"\nmaterial = \"steel\"\nflexible = { modes = 4, elements = 6 }\n"
         "shape = { kind = \"tube\", from = [0.3, 0, 0.2], to = [1.1, 0.1, -0.4], diameter = 0.05, wall = " +
         wall + " }\n";
}

// Two that are reduced each for itself differ in their last bits; a copy does not.
TEST(FlexibleCopies, LegsOfAnArrayAreTurnedCopiesOfTheFirst) {
  const SceneText folder;
  const Scene scene =
      folder.read(kHub + tubes("leg", "0.004") + tubes("stiff", "0.005") + tubes("bare", "0.004") + kHips);
  std::vector<std::string> warnings;
  const std::vector<FlexibleBody> bodies = build_flexible_bodies(scene, warnings);
  const auto of = [&](const std::string& name) -> const FlexibleBody& {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      if (scene.bodies[i].name == name) return bodies[i];
    ADD_FAILURE() << name;
    return bodies.front();
  };
  const FlexibleBody& first = of("leg_1");
  for (const char* name : {"leg_2", "leg_3"}) {
    const FlexibleBody& copy = of(name);
    EXPECT_EQ(copy.modal->name, name);
    EXPECT_EQ(copy.modal->stiffness, first.modal->stiffness);
    EXPECT_EQ(copy.modal->stress_modes, first.modal->stress_modes);
    EXPECT_EQ(copy.modal->static_error, first.modal->static_error);
    // Where it is: turned about the axis of the array, a third of a turn each.
    EXPECT_NEAR(copy.p_DBo.norm(), first.p_DBo.norm(), 1e-12);
    EXPECT_NEAR(copy.p_DBo.head<2>().normalized().dot(first.p_DBo.head<2>().normalized()), -0.5, 1e-12);
    EXPECT_NEAR(copy.p_DBo.z(), first.p_DBo.z(), 1e-12);
  }
  EXPECT_NE(of("stiff_1").modal->stiffness, first.modal->stiffness);
  EXPECT_NE(of("bare_1").modal->stiffness, first.modal->stiffness) << "the same tube, held nowhere";
  EXPECT_EQ(of("stiff_3").modal->stiffness, of("stiff_1").modal->stiffness);
}

// Rigid spheres, rods and discs meet the plane as what they are, not by the nodes of their triangles:
// mbd_solver/assemble/build_bodies.cpp and the round edges of mbd_solver/model/elements/rigid_plane.h.

constexpr double kRadius = 0.1, kGravity = 9.81, kStiffness = 1e6;

// One body of 2 kg that touches the plane with its surface.
Mechanism built(const std::string& shape, const std::vector<std::string>& settings = {}) {
  const SceneText folder;
  return build_mechanism(
      folder.read("end_time = 1\ngravity = [0, 0, -9.81]\n[[bodies]]\nname = \"b\"\nmass = 2\nshape = " + shape +
                      "\n[[boundaries]]\nbody = \"b\"\nsurface = {}\n[ground]\nkind = \"plane\"\n"
                      "[ground.plane]\nstiffness = 1e6\ndamping = 1\nfriction = 0.5\n"
                      "[initial]\nclearance = 0\n",
                  settings));
}

const char* const kBall = "{ kind = \"sphere\", centre = [0, 0, 0.3], radius = 0.1 }";
const char* const kRod = "{ kind = \"rod\", from = [0, -0.15, 0], to = [0, 0.15, 0], diameter = 0.2 }";
const char* const kTube = "{ kind = \"tube\", from = [0, -0.15, 0], to = [0, 0.15, 0], diameter = 0.2, wall = 0.02 }";
const char* const kWheel = "{ kind = \"disc\", axis = \"y\", radius = 0.1, thickness = 0.05 }";
const char* const kRoller = "{ kind = \"cylinder\", axis = \"y\", radius = 0.1, length = 0.3 }";
const char* const kCapsule = "{ kind = \"capsule\", from = [0, -0.15, 0], to = [0, 0.15, 0], diameter = 0.2 }";
const char* const kPlate = "{ kind = \"disc\", axis = \"z\", radius = 0.1, thickness = 0.05 }";

TEST(RoundShape, StandsOnThePlaneWithItsLowestPlace) {
  for (const char* shape : {kBall, kRod, kTube, kWheel, kRoller, kCapsule})
    EXPECT_NEAR(built(shape).model.initial(0).r.z(), kRadius, 1e-15) << shape;
  EXPECT_NEAR(built(kPlate).model.initial(0).r.z(), 0.025, 1e-15);
  // Tilted: half the thickness along the axis, the radius across.
  const double tilt = 0.3;
  EXPECT_NEAR(built(kPlate, {"initial.roll=0.3"}).model.initial(0).r.z(),
              0.025 * std::cos(tilt) + kRadius * std::sin(tilt), 1e-15);
}

// From rest down a slope of 10 degrees without slip: a = g sin / (1 + J / (m R^2)).
TEST(RoundShape, RollsDownASlopeAsRoundAsItIs) {
  const double sine = std::sin(10.0 * kPi / 180.0), cosine = std::sqrt(1.0 - sine * sine);
  const std::string normal = "ground.plane.normal=[" + std::to_string(-sine) + ",0," + std::to_string(cosine) + "]";
  const double inner = 0.08;
  const std::pair<const char*, double> shapes[] = {{kBall, 2.0 / 5.0},
                                                   {kRod, 1.0 / 2.0},
                                                   {kTube, 0.5 * (1.0 + inner * inner / (kRadius * kRadius))},
                                                   {kWheel, 1.0 / 2.0},
                                                   {kRoller, 1.0 / 2.0},
                                                   // A cylinder 0.3 long and a ball: 9/13 and 4/13 of the mass.
                                                   {kCapsule, (9.0 * 0.5 + 4.0 * 0.4) / 13.0}};
  for (const auto& [shape, J] : shapes) {
    const Mechanism mechanism = built(shape, {normal});
    test::Run run(mechanism.model);
    run.to(0.4, 10);
    const double speed = run.body(0).dr.dot(Eigen::Vector3d(-cosine, 0.0, -sine));
    const double rolling = 0.4 * kGravity * sine / (1.0 + J);
    // It slips by v_s (2/7 of tan 10 degrees) / mu at most, 1e-4 of this speed, while it settles by 1e-3 m: 1e-3.
    EXPECT_NEAR(speed, rolling, 1e-3 * rolling) << shape;
    EXPECT_LT(std::abs(run.imbalance()), 1e-3 * run.energy().stored[Stored::kKinetic])
        << shape;  // the integrator's tolerance
  }
}

// m places of a rim that lies flat carry alike: m k delta^1.5 = m g.
TEST(RoundShape, DiscLiesOnItsWholeRim) {
  const Mechanism mechanism = built(kPlate, {"ground.plane.damping=100"});  // it comes to rest soon
  test::Run run(mechanism.model);
  run.to(1.0, 10);
  const double overlap = std::pow(2.0 * kGravity / (12.0 * kStiffness), 2.0 / 3.0);
  EXPECT_NEAR(run.body(0).r.z(), 0.025 - overlap, 0.01 * overlap);  // what is left of its bounce
  EXPECT_NEAR(run.body(0).A(2, 2), 1.0, 1e-12);
}

// What sticks stays; with smooth friction it creeps, slowly, and as fast as the summary says.
TEST(RoundShape, PlateOnASlopeCreepsAsSlowlyAsIsSaid) {
  const double slope = 10.0 * kPi / 180.0, v_s = 1e-4;
  const std::string normal =
      "ground.plane.normal=[" + std::to_string(-std::sin(slope)) + ",0," + std::to_string(std::cos(slope)) + "]";
  const auto speed_after = [&](std::vector<std::string> settings) {
    for (const char* other : {"initial.pitch_deg=-10", "ground.plane.friction=0.3", "ground.plane.damping=100"})
      settings.push_back(other);
    const Mechanism mechanism = built(kPlate, settings);
    test::Run run(mechanism.model);
    run.to(1.0, 10);
    return run.body(0).dr.dot(Eigen::Vector3d(-std::cos(slope), 0.0, -std::sin(slope)));
  };
  const double creep = creep_speed(0.3, v_s, slope);
  EXPECT_NEAR(creep, 0.727 * v_s, 1e-3 * v_s);  // tan 10 deg = 0.1763: 0.1763 / sqrt(0.09 - 0.0311)
  EXPECT_NEAR(speed_after({normal, "ground.plane.friction_speed=1e-4"}), creep, 0.02 * creep);  // left of its bounce
  EXPECT_LT(std::abs(speed_after({normal})), 1e-6);
}

// Grains meet both faces of a rigid disc and a rim of its thickness, unless its mid-surface is asked for.
TEST(RoundShape, DiscHasItsThicknessForGrains) {
  const auto half_width = [](const std::vector<std::string>& settings) {
    return built(kPlate, settings).boundaries[0].boundary.rho0().row(2).cwiseAbs().maxCoeff();
  };
  EXPECT_NEAR(half_width({}), 0.025, 1e-15);
  EXPECT_NEAR(half_width({"boundaries.b.surface.faces=\"middle\""}), 0.0, 1e-15);
}

TEST(RoundShape, DerivativesOfItsForceAreThoseOfDifferences) {
  for (const char* shape : {kBall, kRod, kWheel, kPlate, kCapsule}) {
    for (const char* roll : {"initial.roll=0.02", "initial.roll=0.7"}) {
      const Mechanism mechanism =
          built(shape, {roll, "initial.pitch=0.4", "initial.clearance=-0.02", "ground.plane.friction_speed=0.5",
                        "ground.plane.normal=[0.1,0.2,1]", "initial.velocity=[0.3,-0.2,-0.1]",
                        "initial.angular_velocity=[1,-2,3]"});
      test::Run run(mechanism.model);
      Eigen::VectorXd rates(run.equations.layout().size()), y(run.equations.layout().size());
      run.equations.saddle().accelerations(run.state, run.inputs, rates);
      run.equations.layout().pack(run.state, rates.tail(run.equations.layout().row_count), y);
      std::string where;
      EXPECT_LT(test::jacobian_error(run.equations, y, rates, 10.0, run.inputs, &where), 1e-7)  // see its step
          << shape << ", " << roll << ": " << where;
    }
  }
}

// A plate thrown on its edge falls flat, turning all the while: what its places travel along the rim does no work.
TEST(RoundShape, EnergyClosesWhileAPlateFallsFlat) {
  const Mechanism mechanism =
      built(kPlate, {"initial.roll=0.5", "initial.clearance=0.01", "initial.angular_velocity=[1,2,5]"});
  test::Run run(mechanism.model, "one_step", test::tight(1e-9));
  run.to(0.3, 20);
  EXPECT_GT(run.state.dissipated[Dissipation::kContact], 0.05);
  EXPECT_GT(run.state.dissipated[Dissipation::kFriction], 0.01);
  EXPECT_LT(std::abs(run.imbalance()), 1e-4 * run.state.dissipated.total());  // at a tolerance of 1e-9
}

// A rock and a ramp stand as they are drawn; the lander next to them is turned about its own mass centre, moved and thrown.
const std::string kLanderAndRock = R"(end_time = 1
[[bodies]]
name = "lander"
mass = 2
inertia = [1, 1, 1]
position = [0, 0, 2]
[[bodies]]
name = "rock"
mass = 50
inertia = [1, 1, 1]
position = [3, 0, 0.5]
[[joints]]
name = "anchor"
kind = "fixed"
bodies = ["ground", "rock"]
point = [3, 0, 0]
[[boundaries]]
body = "lander"
[boundaries.beams]
points = [[-1, 0, 2], [1, 0, 2]]
radius = 0.1
[[boundaries]]
body = "rock"
[boundaries.beams]
points = [[3, 0, 0.2], [3, 0, 0.8]]
radius = 0.1
[ground]
kind = "plane"
plane = { stiffness = 1e6, damping = 1 }
[initial]
pitch_deg = 90
clearance = 0.5
velocity = [1, 0, -2]
angular_velocity = [0, 0, 3]
)";

TEST(InitialGroups, WhatStandsStillIsAsItIsDrawn) {
  const SceneText text;
  for (const char* groups : {"initial.groups.still=[\"rock\"]", "initial.groups.moving=[\"lander\"]"}) {
    const Mechanism mechanism = build_mechanism(text.read(kLanderAndRock, {groups}));
    const BodyState &lander = mechanism.model.initial(0), &rock = mechanism.model.initial(1);
    EXPECT_TRUE(rock.r.isApprox(Eigen::Vector3d(3.0, 0.0, 0.5), 1e-15));
    EXPECT_EQ(rock.L, Eigen::Vector4d::UnitX());
    EXPECT_TRUE(rock.dr.isZero(0.0) && rock.w.isZero(0.0));
    // Upright: its beam of 1 m and 0.1 m below the mass centre, 0.5 m above the plane.
    EXPECT_TRUE(lander.r.isApprox(Eigen::Vector3d(0.0, 0.0, 1.6), 1e-12)) << lander.r;
    EXPECT_TRUE(lander.dr.isApprox(Eigen::Vector3d(1.0, 0.0, -2.0), 1e-15));
    EXPECT_EQ(lander.w.z(), 3.0);
    const Joint& anchor = mechanism.model.joint(0);
    EXPECT_TRUE(mechanism.model.initial_position(anchor.m1).isApprox(Eigen::Vector3d(3.0, 0.0, 0.0), 1e-12));
  }
}

TEST(InitialGroups, MistakesAreTold) {
  const SceneText text;
  EXPECT_TRUE(test::names(text.findings(kLanderAndRock, {"initial.groups.still=[\"stone\"]"}), {"stone", "E0123"}));
  EXPECT_TRUE(test::names(text.findings(kLanderAndRock, {"initial.groups.still=[\"rock\",\"lander\"]"}), {"groups"}));
  const std::string tied = kLanderAndRock +
                           "[[springs]]\nname = \"tie\"\nkind = \"bushing\"\nbodies = [\"lander\", "
                           "\"rock\"]\npoint = [1, 0, 1]\nstiffness = 1\n";
  EXPECT_TRUE(test::names(text.findings(tied, {"initial.groups.still=[\"rock\"]"}), {"springs.tie", "lander", "rock"}));
}

}  // namespace
}  // namespace footfall
