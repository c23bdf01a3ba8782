#include "mbd_solver/scene/scene_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;

// The pendulum with a strut of the given laws.
std::string with_strut(const std::string& laws) {
  return kPendulum + "[[struts]]\nname = \"s\"\nbodies = [\"ground\", \"bob\"]\npoints = [[0, 0, 1], [1, 0, 0]]\n" +
         laws + "\n";
}

TEST(SceneCheck, GoodSceneHasNoFindings) {
  const SceneText text;
  EXPECT_EQ(text.findings(kPendulum), "no findings");
}

TEST(SceneCheck, NamesMustDiffer) {
  const SceneText text;
  EXPECT_THAT(
      text.findings(kPendulum + "[[bodies]]\nname = \"bob\"\nmass = 1\ninertia = [1, 1, 1]\nposition = [0, 0, 0]\n"),
      HasSubstr("bodies.bob.name: there is already a body of this name (line 2)"));
}

TEST(SceneCheck, AJointFarFromClosedIsNamedWithItsGap) {
  const SceneText text;
  std::string toml = kPendulum;
  toml.replace(toml.find("point = [0, 0, 0]"), 17, "point_a = [0, 0, 0]\npoint_b = [0, 0, 0.25]");
  EXPECT_THAT(text.findings(toml),
              HasSubstr("joints.hinge.point_b: the joint is open by 0.25 m between \"ground\" and \"bob\""));
}

TEST(SceneCheck, JointsNeedWhatTheirTypeNeeds) {
  const SceneText text;
  const std::string joint = "[[joints]]\nname = \"j\"\nbodies = [\"ground\", \"bob\"]\n";
  EXPECT_THAT(text.findings(kPendulum + joint + "type = \"prismatic\"\npoint = [0, 0, 0]\n"),
              HasSubstr("joints.j.axis: is missing"));
  EXPECT_THAT(text.findings(kPendulum + joint + "type = \"distance\"\n"), HasSubstr("give point_a and point_b"));
  EXPECT_THAT(
      text.findings(kPendulum + joint + "type = \"distance\"\npoint_a = [0, 0, 0]\npoint_b = [1, 0, 0]\nlength = 2\n"),
      HasSubstr("joints.j.length: is 2 m, but the points are 1 m apart"));
  EXPECT_THAT(
      text.findings(kPendulum + joint + "type = \"universal\"\npoint = [0, 0, 0]\naxis = \"x\"\naxis2 = [1, 1, 0]\n"),
      HasSubstr("makes 45 degrees with axis"));
  EXPECT_THAT(text.findings(kPendulum + joint + "type = \"prescribed\"\npoint = [0, 0, 0]\n"),
              HasSubstr("joints.j.motion: prescribes nothing"));
}

TEST(SceneCheck, AStrutOfNoLawIsAFinding) {
  const SceneText text;
  EXPECT_THAT(text.findings(with_strut("")), HasSubstr("struts.s: has no force law"));
}

TEST(SceneCheck, GasMustOutlastTheStop) {
  const SceneText text;
  // V0 / A = 1e-3 / (pi 0.1^2 / 4) = 0.12732 m.
  const std::string gas = "gas = { piston_diameter = 0.1, pressure = 1e5, volume = 1e-3 }\n";
  EXPECT_THAT(text.findings(with_strut(gas)),
              HasSubstr("struts.s.stops.max: is missing; the gas is used up at a stroke of 0.127324 m"));
  EXPECT_THAT(text.findings(with_strut(gas + "stops = { max = 0.13 }")),
              HasSubstr("struts.s.stops.max: is 0.13 m, but the gas is used up"));
  EXPECT_EQ(text.findings(with_strut(gas + "stops = { max = 0.12 }")), "no findings");
}

TEST(SceneCheck, VoltageTablesMustRise) {
  const SceneText text;
  EXPECT_THAT(text.findings(with_strut("mr = { viscous = 1, yield_table = [[0, 0], [0.5, 200], [1, 100]] }")),
              HasSubstr("struts.s.mr.yield_table: falls to 100 at U = 1"));
  EXPECT_THAT(text.findings(with_strut("mr = { viscous = 1, yield_table = [[0, 0], [0.5, 200]] }")),
              HasSubstr("runs from U = 0 to 0.5, expected from 0 to 1"));
}

TEST(SceneCheck, ControllersAreFoundByTheirOutput) {
  const SceneText text;
  const std::string controller =
      "[[controllers]]\nname = \"brain\"\nkind = \"constant\"\nbody = \"bob\"\noutputs = [\"U1\"]\nvoltages = 0.5\n";
  const auto strut = [](const std::string& name) {
    return with_strut("mr = { yield_force = 1, viscous = 1, controller = \"" + name + "\" }");
  };
  EXPECT_EQ(text.findings(strut("brain.U1") + controller), "no findings");
  EXPECT_THAT(text.findings(strut("brain.U2") + controller),
              HasSubstr("there is no controller output \"brain.U2\". Known outputs: brain.U1."));
}

// A scene compares controllers by changing the kind alone: what the other kind needs is left over without a word.
// Written down beside a kind that does not use it, a key is worth a warning.
TEST(SceneCheck, KeysOfAnotherKindAreWarnedOfUnlessTheKindWasSet) {
  const SceneText text;
  const std::string controller =
      kPendulum +
      "[[controllers]]\nname = \"brain\"\nkind = \"skyhook\"\nbody = \"bob\"\noutputs = [\"U1\"]\ndeadband = 0.1\n";
  EXPECT_EQ(text.read(controller, {"controllers.brain.kind=constant"}).warnings, std::vector<std::string>());
  const Scene warned = text.read(controller + "kp = 1\n");
  ASSERT_EQ(warned.warnings.size(), 1u);
  EXPECT_THAT(warned.warnings[0],
              HasSubstr("scene.toml:19: controllers.brain.kp: means nothing for this kind of controller"));
}

TEST(SceneCheck, GroundNeedsItsSectionAndSomethingThatTouchesIt) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum + "[ground]\nkind = \"plane\"\n"), HasSubstr("ground.plane: is missing"));
  EXPECT_THAT(text.findings(kPendulum + "[ground]\nkind = \"particles\"\n"),
              HasSubstr("there is no [particles] section"));
  EXPECT_THAT(text.findings(kPendulum + "[ground]\nkind = \"plane\"\nplane = { young = 1e6, restitution = 1 }\n"),
              HasSubstr("a ground that nothing touches"));
}

// The spline of a motion swings out beside points that are not smooth, and goes on beyond its end.
TEST(SceneCheck, TellsWhereTheSplineOfAMotionLeavesItsPoints) {
  const auto warnings = [](const std::string& table) {
    return SceneText()
        .read(
            "end_time = 2.0\n[[bodies]]\nname = \"plate\"\nmass = 1.0\ninertia = [0.1, 0.1, 0.1]\nposition = [0, 0, "
            "0]\n[[joints]]\nname = "
            "\"press\"\n"
            "type = \"prescribed\"\nbodies = [\"ground\", \"plate\"]\npoint = [0, 0, 0]\naxis = "
            "\"z\"\n[joints.motion]\nz = { table = " +
            table + " }\n")
        .warnings;
  };
  const std::vector<std::string> sharp = warnings("[[0, 0], [1, 0], [1.01, -0.1], [2, -0.1]]");
  ASSERT_EQ(sharp.size(), 1u);
  EXPECT_THAT(sharp[0], HasSubstr("it leaves their range by"));
  const std::vector<std::string> beyond = warnings("[[0, 0], [0.5, -0.1], [1, -0.2]]");
  ASSERT_EQ(beyond.size(), 1u);
  EXPECT_THAT(beyond[0], HasSubstr("goes on with its last speed, -0.2 per s"));
  EXPECT_TRUE(warnings("[[0, 0], [1, -0.1], [2, -0.2]]").empty());
}

}  // namespace
}  // namespace footfall
