// From a scene file to a Scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/scene/shipped_files.h"
#include "tests/support/refused.h"
#include "tests/unit/scene/key_list.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kValueRoundOff = 1e-12;  // values here are of order one

std::set<std::string> difference(const std::set<std::string>& a, const std::set<std::string>& b) {
  std::set<std::string> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(result, result.end()));
  return result;
}

// Keys that contradict another key of the same entry and so cannot stand in one good scene with it, or need a file that only
// another code makes.
const std::set<std::string> kAlternatives = {"landing.rest_speed",  // of runs that end at rest
                                             "landing.rest_time",
                                             "ground.plane.point",
                                             "ground.plane.normal",
                                             "ground.plane.stiffness",
                                             "ground.plane.damping",
                                             "boundaries[].surface.from_script",
                                             "bodies[].flexible.stress_file",
                                             "cables[].stiffness",
                                             "cables[].length",
                                             "cables[].tension",
                                             "initial.from",
                                             "particles.box.size_distribution",
                                             "particles.box.zones[].size_distribution",
                                             "particles.box.size_distribution.kind",
                                             "particles.box.size_distribution.diameters",
                                             "particles.box.size_distribution.fractions",
                                             "particles.box.size_distribution.passing",
                                             "particles.box.size_distribution.median",
                                             "particles.box.size_distribution.deviation",
                                             "particles.box.size_distribution.finest",
                                             "particles.box.size_distribution.coarsest",
                                             "particles.box.size_distribution.classes",
                                             "particles.box.zones[].centre",
                                             "particles.box.zones[].size_distribution.kind",
                                             "particles.box.zones[].size_distribution.diameters",
                                             "particles.box.zones[].size_distribution.fractions",
                                             "particles.box.zones[].size_distribution.passing",
                                             "particles.box.zones[].size_distribution.median",
                                             "particles.box.zones[].size_distribution.deviation",
                                             "particles.box.zones[].size_distribution.finest",
                                             "particles.box.zones[].size_distribution.coarsest",
                                             "particles.box.zones[].size_distribution.classes",
                                             "particles.box.sources",
                                             "particles.box.follow",
                                             "particles.box.follow_directions",
                                             "particles.box.follow_distance",
                                             "particles.box.pour.young",
                                             "particles.box.sinks",
                                             "particles.box.sources[].region",
                                             "particles.box.sources[].from",
                                             "particles.box.sources[].until",
                                             "particles.box.sources[].rate",
                                             "particles.box.sources[].grains_per_second",
                                             "particles.box.sources[].velocity",
                                             "particles.box.sinks[].region",
                                             "particles.box.sinks[].from",
                                             "particles.box.sinks[].until"};

// All functions of time have the same keys: the keys of one are enough.
std::set<std::string> one_function(const std::set<std::string>& keys) {
  std::set<std::string> result;
  for (std::string key : keys) {
    for (const char* function :
         {"joints[].motion.x.", "joints[].motion.y.", "joints[].motion.z.", "joints[].motion.rotation.",
          "forces[].force.", "forces[].torque.", "drives[].command."})
      if (key.rfind(function, 0) == 0) key.replace(0, std::string(function).size(), "function.");
    result.insert(key);
  }
  return result;
}

TEST(ReferenceScene, HoldsEveryKeyTheReaderKnows) {
  const Scene scene = read_scene(FOOTFALL_SOURCE_DIR "/inputs/reference");
  const std::set<std::string> missing = difference(one_function(known_keys()), one_function(given_keys(scene)));
  EXPECT_EQ(missing, kAlternatives);
}

TEST(ReferenceScene, HoldsNoKeyTheListOfKeysLacks) {
  const Scene scene = read_scene(FOOTFALL_SOURCE_DIR "/inputs/reference");
  EXPECT_EQ(difference(given_keys(scene), known_keys()), std::set<std::string>());
}

TEST(SceneReader, ReadsTheFolderAsItsSceneToml) {
  const SceneText text;
  const std::string file = text.write("scene.toml", kPendulum);
  EXPECT_EQ(read_scene(std::filesystem::path(file).parent_path().string()).bodies.size(), 1u);
}

TEST(SceneReader, RefusesAnEmptyName) { EXPECT_THROW(read_scene(""), InputError); }

TEST(SceneReader, FillsDefaultsWhereTheFileIsSilent) {
  const SceneText text;
  const Scene scene = text.read(kPendulum);
  EXPECT_EQ(scene.gravity, Eigen::Vector3d(0, 0, -9.81));
  EXPECT_EQ(scene.solver.integrator, IntegratorKind::kOneStep);
  EXPECT_EQ(scene.coupling.scheme, kDefaultScheme);
  EXPECT_EQ(scene.ground.kind, GroundKind::kNone);
  EXPECT_FALSE(scene.bodies[0].flexible.has_value());
}

TEST(SceneReader, ConvertsUnitsNamedByTheSuffix) {
  const SceneText text;
  const Scene scene = text.read(kPendulum + R"(
[solver]
max_step_ms = 2
[initial]
roll_deg = 90
angular_velocity_rpm = [60, 0, 0]
[[struts]]
name = "s"
bodies = ["ground", "bob"]
points = [[0, 0, 1], [1, 0, 0]]
stops = { max_mm = 300 }
spring = { preload_kN = 2 }
)");
  EXPECT_NEAR(scene.solver.max_step, 0.002, kValueRoundOff);
  EXPECT_NEAR(scene.initial.roll, kPi / 2, kValueRoundOff);
  EXPECT_NEAR(scene.initial.angular_velocity[0], 2 * kPi, kValueRoundOff);
  EXPECT_NEAR(*scene.struts[0].stops->largest_stroke, 0.3, kValueRoundOff);
  EXPECT_NEAR(scene.struts[0].spring->preload, 2000.0, 1e-9);
}

TEST(SceneReader, RefusesTwoUnitsOfOneKey) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum + "[solver]\nmax_step = 1e-3\nmax_step_ms = 1\n"),
              HasSubstr("solver.max_step_ms"));
}

TEST(SceneReader, RefusesNumbersThatAreNotFinite) {
  const SceneText text;
  EXPECT_NE(text.findings(kPendulum + "[initial]\nroll = nan\nvelocity = [0, inf, 0]\n"), "");
}

TEST(SceneSettings, ChangeValuesByPathAndByNameOfTheEntry) {
  const SceneText text;
  const Scene scene = text.read(kPendulum, {"bodies.bob.mass=5", "solver.integrator=ida", "initial.velocity=[0, 0, -3]",
                                            "flexible=false", "title=two words"});
  EXPECT_EQ(scene.bodies[0].mass, 5.0);
  EXPECT_EQ(scene.solver.integrator, IntegratorKind::kIda);
  EXPECT_EQ(scene.initial.velocity, Eigen::Vector3d(0, 0, -3));
  EXPECT_FALSE(scene.flexible);
  EXPECT_EQ(scene.title, "two words");
}

TEST(SceneSettings, WinOverTheSameKeyInAnotherUnit) {
  const SceneText text;
  const std::string findings = text.findings(kPendulum + "[initial]\nroll_deg = 10\n", {"initial.roll=0.5"});
  EXPECT_NE(findings, "");
  EXPECT_NEAR(text.read(kPendulum + "[initial]\nroll_deg = 10\n", {"initial.roll_deg=20"}).initial.roll, kPi / 9,
              kValueRoundOff);
}

TEST(SceneSettings, RefuseUnknownPathsWithAGuess) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum, {"bodies.bop.mass=5"}), HasSubstr("--set bodies.bop.mass"));
  EXPECT_THAT(text.findings(kPendulum, {"solver.rtoll=5"}), HasSubstr("--set solver.rtoll"));
  EXPECT_THAT(text.findings(kPendulum, {"solvr.rtol=5"}), HasSubstr("\"solver\""));
  EXPECT_NE(text.findings(kPendulum, {"solver.rtol"}), "");
}

TEST(SceneArrays, CopyEntriesTurnThemAndNumberTheirNames) {
  const SceneText text;
  const Scene scene = text.read(R"(end_time = 1
[arrays.leg]
count = 4
start_deg = 45
step_deg = 90
[[bodies]]
name = "hub"
mass = 1
inertia = [1, 1, 1]
position = [0, 0, 0]
[[bodies]]
name = "leg_{leg}"
mass = 1
shape = { kind = "rod", from = [1, 0, 0], to = [2, 0, 0], diameter = 0.1 }
[[joints]]
name = "hip_{leg}"
kind = "revolute"
bodies = ["hub", "leg_{leg}"]
point = [1, 0, 0]
axis = [0, 1, 0]
[output]
bodies = ["leg_{leg}"]
)");
  ASSERT_EQ(scene.bodies.size(), 5u);
  ASSERT_EQ(scene.joints.size(), 4u);
  EXPECT_EQ(scene.output.bodies, (std::vector<std::string>{"leg_1", "leg_2", "leg_3", "leg_4"}));
  EXPECT_EQ(scene.joints[1].bodies[1], "leg_2");
  const double c = std::sqrt(0.5);
  EXPECT_NEAR((scene.bodies[2].position - Eigen::Vector3d(-1.5 * c, 1.5 * c, 0)).norm(), 0.0, kValueRoundOff);
  EXPECT_NEAR((scene.joints[1].axis - Eigen::Vector3d(-c, -c, 0)).norm(), 0.0, kValueRoundOff);
  // Body axes turn with the copy, so all copies have the same inertia in their own axes.
  EXPECT_NEAR((scene.bodies[1].inertia - scene.bodies[4].inertia).norm(), 0.0, kValueRoundOff);
  EXPECT_NEAR((scene.bodies[2].orientation * Eigen::Vector3d::UnitX() - Eigen::Vector3d(-c, c, 0)).norm(), 0.0,
              kValueRoundOff);
}

// One copy of an array, by its name: a leg that has failed.
TEST(SceneArrays, OneCopyCanDiffer) {
  const SceneText text;
  const std::string legs = R"(end_time = 1
[arrays.leg]
count = 3
step_deg = 120
[[bodies]]
name = "hub"
mass = 1
inertia = [1, 1, 1]
position = [0, 0, 0]
[[bodies]]
name = "leg_{leg}"
mass = 1
inertia = [1, 1, 1]
position = [1, 0, 0]
[[joints]]
name = "hip_{leg}"
kind = "revolute"
bodies = ["hub", "leg_{leg}"]
point = [1, 0, 0]
axis = [0, 1, 0]
angle = { spring = { stiffness = 5 } }
)";
  const auto differs = [](const Scene& scene) {
    ASSERT_EQ(scene.bodies.size(), 4u);
    for (std::size_t k = 1; k <= 3; ++k) {
      EXPECT_EQ(scene.bodies[k].name, "leg_" + std::to_string(k));
      EXPECT_EQ(scene.bodies[k].mass, k == 1 ? 1.0 : static_cast<double>(k) + 0.5);
      EXPECT_EQ(scene.joints[k - 1].name, "hip_" + std::to_string(k));
      EXPECT_EQ(scene.joints[k - 1].bodies[1], "leg_" + std::to_string(k));
      EXPECT_EQ(scene.joints[k - 1].angle->spring->stiffness, k == 2 ? 0.1 : 5.0);
    }
    const double c = std::cos(2.0 * kPi / 3.0), s = std::sin(2.0 * kPi / 3.0);
    EXPECT_NEAR((scene.bodies[2].position - Eigen::Vector3d(c, s, 0)).norm(), 0.0, kValueRoundOff);
  };
  differs(text.read(legs, {"bodies.leg_3.mass=3.5", "joints.hip_2.angle.spring.stiffness=9", "bodies.leg_2.mass=2.5",
                           "joints.hip_2.angle.spring.stiffness=0.1"}));
  text.write("legs.toml", legs);
  differs(text.read(R"(base = "legs.toml"
[[bodies]]
name = "leg_2"
mass = 2.5
[[joints]]
name = "hip_2"
angle = { spring = { stiffness = 0.1 } }
)",
                    {"bodies.leg_3.mass=3.5"}));
  EXPECT_THAT(text.findings(legs, {"bodies.leg_4.mass=3"}), HasSubstr("leg_4"));
}

TEST(SceneArrays, NameThatBelongsToNoArrayIsAFinding) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum + "[arrays.leg]\ncount = 2\n[[springs]]\nname = \"s_{lag}\"\nkind = "
                                        "\"centring\"\nbodies = [\"ground\", \"bob\"]\nstiffness = 1\n"),
              HasSubstr("\"s_{lag}\""));
}

TEST(SceneBase, ChangesAddsAndLeavesOut) {
  const SceneText text;
  text.write("base.toml", kPendulum + "[arrays.leg]\ncount = 2\n[[materials.x]]\n");
  text.write("base.toml", kPendulum);
  const Scene whole = text.read(kPendulum);
  const Scene changed =
      text.read("base = \"base.toml\"\nwithout = [\"joints\"]\n[[bodies]]\nname = \"bob\"\nmass = 7\n");
  ASSERT_EQ(changed.bodies.size(), whole.bodies.size());
  EXPECT_EQ(changed.bodies[0].mass, 7.0);
  EXPECT_EQ(changed.bodies[0].inertia, whole.bodies[0].inertia);
  EXPECT_FALSE(whole.joints.empty());
  EXPECT_TRUE(changed.joints.empty());
}

TEST(SceneSettings, AbsoluteTolerancesFollowTheRelativeOne) {
  const SceneText text;
  const Scene usual = text.read(kPendulum), fine = text.read(kPendulum, {"solver.rtol=1e-9"}),
              own = text.read(kPendulum, {"solver.rtol=1e-9", "solver.atol=1e-7"});
  EXPECT_DOUBLE_EQ(usual.solver.atol_position(), 1e-8);
  EXPECT_DOUBLE_EQ(usual.solver.atol_velocity(), 1e-6);
  EXPECT_DOUBLE_EQ(fine.solver.atol_position(), 1e-11);
  EXPECT_DOUBLE_EQ(own.solver.atol_position(), 1e-7);
  EXPECT_DOUBLE_EQ(own.solver.atol_velocity(), 1e-5);
}

TEST(SceneJson, HoldsEveryDefaultAndResolvedNumber) {
  const SceneText text;
  const nlohmann::json json = nlohmann::json::parse(scene_json(text.read(kPendulum, {"bodies.bob.mass=3"})));
  EXPECT_EQ(json["bodies"][0]["mass"], 3.0);
  EXPECT_EQ(json["solver"]["rtol"], 1e-6);
  EXPECT_EQ(json["solver"]["atol"], 1e-8);
  EXPECT_EQ(json["coupling"]["scheme"], "css-trapezoid");
  EXPECT_EQ(json["joints"][0]["point_b"], nlohmann::json({0.0, 0.0, 0.0}));
  EXPECT_TRUE(json["particles"].is_null());
}

// One mistake is one finding: what was refused when it was read is not complained of again: mbd_solver/scene/findings.h.

using ::testing::AllOf;

auto Only(const std::string& what) { return AllOf(HasSubstr(what), Not(HasSubstr("\n"))); }

TEST(OneFinding, OfStopsNamesTheKeyThatSetGave) {
  const SceneText text;
  const std::string stops = kPendulum + "[joints.angle]\nstops = { min_deg = -10, max_deg = 10, stiffness = 500 }\n";
  for (const auto& [end, value, other] : {std::array{"min", "20", "10"}, std::array{"max", "-20", "-10"}}) {
    const std::string found = text.findings(stops, {std::string("joints.hinge.angle.stops.") + end + "_deg=" + value});
    EXPECT_THAT(found, Only(std::string("--set joints.hinge.angle.stops.") + end + ": "));
    EXPECT_THAT(found, AllOf(HasSubstr(code::kRangeReversed.number), HasSubstr(std::string(value) + " degrees"),
                             HasSubstr(std::string(other) + " degrees")));
  }
}

TEST(OneFinding, SaysWhereItStands) {
  Source source{"signals.s", 40, {{"input", Source::kFromSet}, {"rate", 41}}, {}, {}};
  EXPECT_EQ(place_of("s.toml", source, "input"), "--set signals.s.input: ");
  EXPECT_EQ(place_of("s.toml", source, "rate"), "s.toml:41: signals.s.rate: ");
  EXPECT_EQ(place_of("s.toml", source), "s.toml:40: signals.s: ");
  EXPECT_TRUE(names_a_place("s.toml", "s.toml:40: signals.s: what"));
  EXPECT_TRUE(names_a_place("s.toml", "--set signals.s: what"));
  EXPECT_FALSE(names_a_place("s.toml", "what"));
}

TEST(Limits, OfDensityToleranceAndSteps) {
  const SceneText text;
  const std::vector<std::string> warnings = text.read(kPendulum + "[materials.al]\ndensity = 2.7\n").warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("materials.al.density"));
  EXPECT_THAT(warnings[0], HasSubstr("2.7"));
  EXPECT_TRUE(text.read(kPendulum + "[materials.al]\ndensity_g_cm3 = 2.7\n").warnings.empty());
  EXPECT_THAT(text.findings(kPendulum + "[solver]\nrtol = 2\n"), Only("solver.rtol: is 2, expected less than 0.1"));
  EXPECT_THAT(text.findings(kPendulum + "[solver]\nmax_step = 1e-12\n"),
              Only("solver.max_step: is 1e-12 s: 1e+12 steps until end_time, expected at most 1e+09"));
}

// [initial.joints]: numbers for joints of one coordinate, tables for all; starts beyond stops.

// The pendulum with its hinge of another type.
std::string pendulum_on(const std::string& type) {
  std::string toml = kPendulum;
  return toml.replace(toml.find("revolute"), 8, type);
}

const std::string kNumber = "[initial.joints]\nhinge = 0.3\n";

TEST(InitialJoints, ANumberIsTheOneCoordinate) {
  const SceneText text;
  const Scene turned = text.read(kPendulum + kNumber), moved = text.read(pendulum_on("prismatic") + kNumber);
  ASSERT_EQ(turned.initial.joints.size(), 1u);
  EXPECT_EQ(turned.initial.joints[0].angle, 0.3);
  EXPECT_FALSE(turned.initial.joints[0].displacement);
  EXPECT_EQ(moved.initial.joints.at(0).displacement, 0.3);
  EXPECT_FALSE(moved.initial.joints[0].angle);
  EXPECT_EQ(text.read(kPendulum, {"initial.joints.hinge=0.3"}).initial.joints.at(0).angle, 0.3);
}

TEST(InitialJoints, ANumberGoesToAnEntryOfAnArray) {
  const SceneText text;
  std::string toml = "end_time = 1\n[arrays.leg]\ncount = 2\n" + kPendulum.substr(kPendulum.find("[[bodies]]"));
  for (const std::string name : {"bob", "hinge"})
    for (std::size_t at = toml.find("\"" + name + "\""); at != std::string::npos; at = toml.find("\"" + name + "\""))
      toml.replace(at, name.size() + 2, "\"" + name + "_{leg}\"");
  const Scene scene = text.read(toml + "[initial.joints]\nhinge_2 = 0.3\n");
  ASSERT_EQ(scene.initial.joints.size(), 1u);
  EXPECT_EQ(scene.initial.joints[0].angle, 0.3);
}

TEST(InitialJoints, ANumberForSeveralCoordinatesTellsWhatToWrite) {
  const SceneText text;
  const std::string findings = text.findings(pendulum_on("cylindrical") + kNumber);
  EXPECT_THAT(findings, AllOf(HasSubstr("scene.toml:14: initial.joints.hinge"), Not(HasSubstr("\n"))));
}

TEST(InitialJoints, AStartBeyondAStopIsWarnedOf) {
  const SceneText text;
  const std::string stops = "[joints.angle]\nstops = { min_deg = -10, max_deg = 10, stiffness = 500 }\n";
  const auto warnings = [&](const std::string& degrees) {
    std::string all;
    for (const std::string& warning :
         text.read(kPendulum + stops + "[initial.joints.hinge]\nangle_deg = " + degrees + "\n").warnings)
      all += warning + "\n";
    return all;
  };
  EXPECT_THAT(warnings("12"), HasSubstr("initial.joints.hinge.angle"));
  EXPECT_THAT(warnings("-11"), HasSubstr("10"));
  EXPECT_EQ(warnings("9"), "");
}

// mbd_solver/scene/resolve.cpp: a tube or rod as several bodies in a row.

using ::testing::ElementsAre;

constexpr double kSegmentRoundOff = 1e-12;

std::string arm(const std::string& flexible, const std::string& more = "") {
  return "end_time = 1\n[materials.steel]\ndensity = 7850\nyoung_GPa = 207\n[[bodies]]\nname = \"arm\"\n"
         "material = \"steel\"\nshape = { kind = \"rod\", from = [0, 0, 1], to = [2, 0, 1], diameter = 0.02 }\n"
         "flexible = { " +
         flexible + " }\n" + more;
}

const std::string kHub =
    "[[joints]]\nname = \"hub\"\nkind = \"revolute\"\nbodies = [\"ground\", \"arm\"]\npoint = [0, 0, 1]\naxis = "
    "\"y\"\n";

TEST(Segments, AreEqualPiecesJoinedInARow) {
  const SceneText text;
  const Scene whole = text.read(arm("modes = 3", kHub)), cut = text.read(arm("segments = 4", kHub));
  ASSERT_EQ(cut.bodies.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    const BodySpec& body = cut.bodies[k];
    EXPECT_EQ(body.name, "arm_" + std::to_string(k + 1));
    EXPECT_NEAR(body.mass, whole.bodies[0].mass / 4, kSegmentRoundOff);
    EXPECT_NEAR((body.position - Eigen::Vector3d(0.25 + 0.5 * k, 0, 1)).norm(), 0.0, kSegmentRoundOff);
    EXPECT_EQ(body.flexible->modes, 2);  // what a short piece needs besides its static shapes
  }
  ASSERT_EQ(cut.joints.size(), 4u);
  EXPECT_THAT(cut.joints[0].bodies, ElementsAre("ground", "arm_1"));
  for (int k = 1; k < 4; ++k) {
    const JointSpec& joint = cut.joints[k];
    EXPECT_EQ(joint.type, JointType::kFixed);
    EXPECT_THAT(joint.bodies, ElementsAre("arm_" + std::to_string(k), "arm_" + std::to_string(k + 1)));
    EXPECT_NEAR((joint.point_b - Eigen::Vector3d(0.5 * k, 0, 1)).norm(), 0.0, kSegmentRoundOff);
  }
  EXPECT_NEAR(total_mass(cut), total_mass(whole), kSegmentRoundOff);
  EXPECT_NEAR((mass_centre(cut) - mass_centre(whole)).norm(), 0.0, kSegmentRoundOff);
}

TEST(Segments, WhatIsAttachedGoesToTheSegmentAtItsPoint) {
  const SceneText text;
  const Scene scene =
      text.read(arm("segments = 4", kHub + "[[struts]]\nname = \"stay\"\nbodies = [\"ground\", \"arm\"]\npoints = "
                                           "[[1.2, 0, 0], [1.2, 0, 1]]\nspring = { stiffness = 10 }\n"
                                           "[[springs]]\nname = \"end\"\nkind = \"torsion\"\nbodies = [\"ground\", "
                                           "\"arm\"]\npoint = [2, 0, 1]\naxis = \"y\"\nstiffness = 1\n"
                                           "[[boundaries]]\nbody = \"arm\"\nbeams = { segments = 8 }\n"
                                           "[initial]\nvelocity = [0, 0, 0]\n[[initial.bodies]]\nbody = "
                                           "\"arm\"\nvelocity = [1, 0, 0]\nangular_velocity = [0, 2, 0]\n"
                                           "[output]\nbodies = [\"arm\"]\n"));
  EXPECT_EQ(scene.struts[0].bodies[1], "arm_3");
  EXPECT_EQ(scene.springs[0].bodies[1], "arm_4");
  EXPECT_THAT(scene.output.bodies, ElementsAre("arm_1", "arm_2", "arm_3", "arm_4"));
  ASSERT_EQ(scene.boundaries.size(), 4u);
  EXPECT_EQ(scene.boundaries[2].body, "arm_3");
  EXPECT_EQ(scene.boundaries[2].beams->segments, 2);
  ASSERT_EQ(scene.initial.bodies.size(), 4u);
  // v = v_centre + w x (c_k - c): (0, 2, 0) x (-0.75, 0, 0) = (0, 0, 1.5)
  EXPECT_NEAR((*scene.initial.bodies[0].velocity - Eigen::Vector3d(1, 0, 1.5)).norm(), 0.0, kSegmentRoundOff);
}

TEST(Segments, ACutBelongsToTheEarlierOne) {
  const SceneText text;
  const Scene scene = text.read(arm(
      "segments = 4",
      kHub + "[[joints]]\nname = \"pin\"\nkind = \"spherical\"\nbodies = [\"arm\", \"ground\"]\npoint = [1, 0, 1]\n"));
  EXPECT_EQ(scene.joints[1].bodies[0], "arm_2");
}

// mbd_solver/scene/box_bed.h: published soils as beds by numbers.

const std::string kScene = R"(end_time = 1.0
[[bodies]]
name = "plate"
mass = 1.0
shape = { kind = "disc", centre = [0, 0, 0.05], radius = 0.05, thickness = 0.01 }
[[boundaries]]
body = "plate"
surface = {}
[ground]
kind = "particles"
[particles]
soil = "SOIL"
[particles.box]
size = [0.3, 0.2]
depth = 0.08
radius = 0.008
)";

std::string with_soil(const std::string& name, const std::string& more = "") {
  std::string text = kScene;
  return text.replace(text.find("SOIL"), 4, name) + more;
}

TEST(Soil, EveryOneIsReadAndSaysWhereItsNumbersComeFrom) {
  ASSERT_GE(shipped_tables("inputs/soils").size(), 6u);
  for (const std::string& name : shipped_tables("inputs/soils")) {
    const Scene scene = SceneText().read(with_soil(name));
    const BoxSpec& box = *scene.particles->box;
    EXPECT_EQ(box.packing, name.find("dense") != std::string::npos ? Packing::kDense : Packing::kLoose) << name;
    EXPECT_NE(box.material.density, GrainMaterialSpec{}.density) << name;
    const std::string text = read_whole_file(shipped_file("inputs/soils/" + name + ".toml")).value();
    EXPECT_NE(text.find("Source"), std::string::npos) << name;
    EXPECT_NE(text.find("assumed"), std::string::npos) << name;
  }
}

TEST(Soil, WhatTheSceneSaysItselfStays) {
  const Scene scene =
      SceneText().read(with_soil("grc-1-dense", "packing = \"loose\"\n[particles.box.material]\nfriction = 0.7\n"));
  EXPECT_EQ(scene.particles->box->packing, Packing::kLoose);
  EXPECT_EQ(scene.particles->box->material.friction, 0.7);
  EXPECT_EQ(scene.particles->box->material.density, 3098.0);
}

// Keys with a second spelling: read alike, with a warning that names the key's own.
TEST(SecondSpellings, AreReadWithAWarning) {
  const SceneText text;
  std::string second = kPendulum;
  second.replace(second.find("kind = \"revolute\""), 4, "type");
  const Scene own = text.read(kPendulum), other = text.read(second);
  EXPECT_EQ(own.joints[0].type, other.joints[0].type);
  EXPECT_TRUE(own.warnings.empty());
  ASSERT_EQ(other.warnings.size(), 1u);
  EXPECT_TRUE(test::names(other.warnings[0], {"joints.hinge.type", "kind", "W0171"}));
  EXPECT_NE(text.findings(second + "kind = \"revolute\"\n"), "");  // both
}

TEST(SecondSpellings, OfKindAreThoseOfAllLists) {
  const SceneText text;
  const std::string body = "bodies = [{ name = \"b\", mass = 1, shape = { type = \"sphere\", radius = 0.1 } }]\n",
                    joint =
                        "joints = [{ name = \"j\", type = \"prismatic\", bodies = [\"ground\", \"b\"], point = [0, 0, "
                        "0], axis = \"x\" }]\n",
                    drive =
                        "drives = [{ name = \"d\", type = \"torque\", joint = \"j\", command = { signal = \"s\" } }]\n",
                    signal = "signals = [{ name = \"s\", type = \"expression\", input = \"time\" }]\n",
                    ground = "[ground]\ntype = \"none\"\n";
  const Scene scene = text.read("end_time = 1\n" + body + joint + drive + signal + ground);
  ASSERT_EQ(scene.warnings.size(), 1u);  // of all
  EXPECT_TRUE(test::names(scene.warnings[0], {"type", "kind", "W0171"}));
}

TEST(SecondSpellings, ASettingInEitherChangesTheScene) {
  const SceneText text;
  for (const char* setting : {"joints.hinge.kind=fixed", "joints.hinge.type=fixed"}) {
    std::string plain = kPendulum;
    plain.erase(plain.find("axis = "), std::string("axis = \"y\"\n").size());
    EXPECT_EQ(text.read(plain, {setting}).joints[0].type, JointType::kFixed) << setting;
  }
}

TEST(SecondSpellings, ADriveOnADisplacementHasAForce) {
  const SceneText text;
  const std::string slide =
      "end_time = 1\nbodies = [{ name = \"b\", mass = 1, inertia = [1, 1, 1], position = [0, 0, 0] }]\njoints = [{ "
      "name = "
      "\"s\", kind = \"prismatic\", bodies = [\"ground\", \"b\"], point = [0, 0, 0], axis = \"x\" }]\ndrives = [{ name "
      "= "
      "\"d\", kind = \"torque\", joint = \"s\", command = { polynomial = [1] }, ";
  const Scene force = text.read(slide + "max_force_kN = 2 }]\n"), torque = text.read(slide + "max_torque = 2000 }]\n");
  EXPECT_EQ(force.drives[0].motor.largest_torque, 2000.0);
  EXPECT_EQ(torque.drives[0].motor.largest_torque, 2000.0);
  EXPECT_TRUE(force.warnings.empty());
  ASSERT_EQ(torque.warnings.size(), 1u);
  EXPECT_TRUE(test::names(torque.warnings[0], {"max_force", "W0171"}));
  EXPECT_NE(text.findings(slide + "max_force = 2, max_torque = 2 }]\n"), "");
}

}  // namespace
}  // namespace footfall
