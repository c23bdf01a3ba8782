#include "mbd_solver/scene/scene_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/scene/scene_json.h"
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

// Keys that contradict another key of the same entry and so cannot stand in one good scene with it.
const std::set<std::string> kAlternatives = {"ground.plane.stiffness", "ground.plane.damping",
                                             "boundaries[].surface.from_script"};

// All functions of time have the same keys: those of one of them are enough.
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

TEST(SceneReader, TellsThatANameIsEmpty) {
  try {
    read_scene("");
    FAIL() << "there is no such scene";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("the name of the scene is empty"), 0u);
    EXPECT_EQ(std::string(error.what()).find("Did you mean"), std::string::npos);
  }
}

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
  EXPECT_NEAR(*scene.struts[0].stops->max, 0.3, kValueRoundOff);
  EXPECT_NEAR(scene.struts[0].spring->preload, 2000.0, 1e-9);
}

TEST(SceneReader, RefusesTwoUnitsOfOneKey) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum + "[solver]\nmax_step = 1e-3\nmax_step_ms = 1\n"),
              HasSubstr("solver.max_step_ms: is given twice"));
}

TEST(SceneReader, NamesFileLineAndKeyOfAnUnknownKeyAndGuessesTheRightOne) {
  const SceneText text;
  const std::string findings = text.findings(kPendulum + "[solver]\nintegrater = \"ida\"\n");
  EXPECT_THAT(findings, HasSubstr("scene.toml:14: solver.integrater: unknown key."));
  EXPECT_THAT(findings, HasSubstr("Did you mean \"integrator\"?"));
}

TEST(SceneReader, ReportsAllFindingsAtOnce) {
  const SceneText text;
  const std::string findings = text.findings(R"(end_time = -1
gravity = "down"
[[bodies]]
name = "bob"
mass = -2.0
inertia = [0.1, 0.1, 0.2]
position = [0, 0]
[[joints]]
name = "hinge"
type = "revolut"
bodies = ["ground", "bub"]
)");
  EXPECT_THAT(findings, HasSubstr(":1: end_time: is -1 s, expected more than 0"));
  EXPECT_THAT(findings, HasSubstr(":2: gravity: is text \"down\", expected a list of 3 numbers [m/s2]"));
  EXPECT_THAT(findings, HasSubstr(":5: bodies.bob.mass: is -2 kg, expected more than 0"));
  EXPECT_THAT(findings, HasSubstr(":7: bodies.bob.position: is a list of 2, expected a list of 3 numbers [m]"));
  EXPECT_THAT(findings, HasSubstr(":10: joints.hinge.type: is text \"revolut\", which is none of the choices."));
  EXPECT_THAT(findings, HasSubstr("Did you mean \"revolute\"?"));
}

TEST(SceneReader, GuessesTheBodyThatWasMeant) {
  const SceneText text;
  const std::string findings = text.findings(kPendulum + "[output]\nbodies = [\"bop\"]\n");
  EXPECT_THAT(findings,
              HasSubstr(":14: output.bodies: unknown body \"bop\". Known bodies: bob. Did you mean \"bob\"?"));
}

TEST(SceneReader, RefusesWhatIsNotToml) {
  const SceneText text;
  EXPECT_THAT(text.findings("end_time = 1\ntitle = oops\n"), HasSubstr("scene.toml:2: this is not valid TOML"));
}

TEST(SceneReader, RefusesNumbersThatAreNotFinite) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum + "[initial]\nroll = nan\nvelocity = [0, inf, 0]\n"),
              HasSubstr("expected a finite number"));
}

TEST(SceneReader, RefusesAZeroAxis) {
  const SceneText text;
  std::string toml = kPendulum;
  toml.replace(toml.find("axis = \"y\""), 10, "axis = [0, 0, 0]");
  EXPECT_THAT(text.findings(toml), HasSubstr("joints.hinge.axis: is zero and has no direction"));
}

TEST(SceneReader, NamesAMissingFileWithTheFolderItLookedIn) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum + "[[boundaries]]\nbody = \"bob\"\nsurface = { file = \"bob.stl\" }\n"),
              HasSubstr("boundaries.bob.surface.file: there is no file \"bob.stl\""));
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
  EXPECT_THAT(findings, HasSubstr("is given twice"));
  EXPECT_NEAR(text.read(kPendulum + "[initial]\nroll_deg = 10\n", {"initial.roll_deg=20"}).initial.roll, kPi / 9,
              kValueRoundOff);
}

TEST(SceneSettings, RefuseUnknownPathsWithAGuess) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum, {"bodies.bop.mass=5"}),
              HasSubstr("--set bodies.bop.mass: there is no entry \"bop\". Known entries: bob. Did you mean \"bob\"?"));
  EXPECT_THAT(text.findings(kPendulum, {"solver.rtoll=5"}), HasSubstr("--set solver.rtoll: unknown key."));
  EXPECT_THAT(text.findings(kPendulum, {"solvr.rtol=5"}), HasSubstr("Did you mean \"solver\"?"));
  EXPECT_THAT(text.findings(kPendulum, {"solver.rtol"}), HasSubstr("expected key=value"));
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
type = "revolute"
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

TEST(SceneArrays, NameThatBelongsToNoArrayIsAFinding) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum + "[arrays.leg]\ncount = 2\n[[springs]]\nname = \"s_{lag}\"\nkind = "
                                        "\"centring\"\nbodies = [\"ground\", \"bob\"]\nstiffness = 1\n"),
              HasSubstr("\"s_{lag}\" names no array. Known arrays: leg. Did you mean \"leg\"?"));
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

}  // namespace
}  // namespace footfall
