// Findings of a scene and of its LIGGGHTS scripts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/particle_script.h"
#include "mbd_solver/scene/scene_check.h"
#include "tests/support/refused.h"
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
  EXPECT_EQ(text.findings(kPendulum), "");
}

TEST(SceneCheck, JointsNeedWhatTheirTypeNeeds) {
  const SceneText text;
  const std::string joint = "[[joints]]\nname = \"j\"\nbodies = [\"ground\", \"bob\"]\n";
  EXPECT_THAT(text.findings(kPendulum + joint + "kind = \"prismatic\"\npoint = [0, 0, 0]\n"),
              HasSubstr("joints.j.axis"));
  EXPECT_NE(text.findings(kPendulum + joint + "kind = \"distance\"\n"), "");
  EXPECT_THAT(
      text.findings(kPendulum + joint + "kind = \"distance\"\npoint_a = [0, 0, 0]\npoint_b = [1, 0, 0]\nlength = 2\n"),
      HasSubstr("joints.j.length"));
  EXPECT_THAT(
      text.findings(kPendulum + joint + "kind = \"universal\"\npoint = [0, 0, 0]\naxis = \"x\"\naxis2 = [1, 1, 0]\n"),
      HasSubstr("45"));
  EXPECT_THAT(text.findings(kPendulum + joint + "kind = \"prescribed\"\npoint = [0, 0, 0]\n"),
              HasSubstr("joints.j.motion"));
}

TEST(SceneCheck, AStrutOfNoLawIsAFinding) {
  const SceneText text;
  EXPECT_THAT(text.findings(with_strut("")), HasSubstr("struts.s"));
}

// A scene compares controllers by changing the kind alone: what the other kind needs is left over without a word.
// Written down with a kind that does not use it, a key is worth a warning.
TEST(SceneCheck, KeysOfAnotherKindAreWarnedOfUnlessTheKindWasSet) {
  const SceneText text;
  const std::string controller =
      kPendulum +
      "[[controllers]]\nname = \"brain\"\nkind = \"skyhook\"\nbody = \"bob\"\noutputs = [\"U1\"]\ndeadband = 0.1\n";
  EXPECT_EQ(text.read(controller, {"controllers.brain.kind=constant"}).warnings, std::vector<std::string>());
  const Scene warned = text.read(controller + "kp = 1\n");
  ASSERT_EQ(warned.warnings.size(), 1u);
  EXPECT_THAT(warned.warnings[0], HasSubstr("scene.toml:19: controllers.brain.kp"));
}

TEST(SceneCheck, GroundNeedsItsSectionAndSomethingThatTouchesIt) {
  const SceneText text;
  EXPECT_THAT(text.findings(kPendulum + "[ground]\nkind = \"plane\"\n"), HasSubstr("ground.plane"));
  EXPECT_NE(text.findings(kPendulum + "[ground]\nkind = \"particles\"\n"), "");
  EXPECT_NE(text.findings(kPendulum + "[ground]\nkind = \"plane\"\nplane = { young = 1e6, restitution = 1 }\n"), "");
}

TEST(SceneCheck, GrainsWithoutAGroundAreWarnedOf) {
  const SceneText text;
  const std::string grains = kPendulum + "[particles.box]\nsize = [1, 1]\ndepth = 0.1\nradius = 0.01\n";
  const std::vector<std::string> warnings = text.read(grains).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("particles: has no effect, because the scene names no ground"));
  EXPECT_TRUE(text.read(grains + "[ground]\nkind = \"none\"\n").warnings.empty());
  EXPECT_TRUE(text.read(grains, {"ground.kind=none"}).warnings.empty());
}

// The spline of a motion swings out near points that are not smooth, and continues beyond its end.
TEST(SceneCheck, TellsWhereTheSplineOfAMotionLeavesItsPoints) {
  const auto warnings = [](const std::string& table) {
    return SceneText()
        .read(
            "end_time = 2.0\n[[bodies]]\nname = \"plate\"\nmass = 1.0\ninertia = [0.1, 0.1, 0.1]\nposition = [0, 0, "
            "0]\n[[joints]]\nname = "
            "\"press\"\n"
            "kind = \"prescribed\"\nbodies = [\"ground\", \"plate\"]\npoint = [0, 0, 0]\naxis = "
            "\"z\"\n[joints.motion]\nz = { table = " +
            table + " }\n")
        .warnings;
  };
  const std::vector<std::string> sharp = warnings("[[0, 0], [1, 0], [1.01, -0.1], [2, -0.1]]");
  ASSERT_EQ(sharp.size(), 1u);
  EXPECT_NE(sharp[0], "");
  const std::vector<std::string> beyond = warnings("[[0, 0], [0.5, -0.1], [1, -0.2]]");
  ASSERT_EQ(beyond.size(), 1u);
  EXPECT_THAT(beyond[0], HasSubstr("0.2"));
  EXPECT_TRUE(warnings("[[0, 0], [1, -0.1], [2, -0.2]]").empty());
}

class ScriptCheck : public ::testing::Test {
 protected:
  // A scene on grains whose script is `script`, between the mesh that it couples and the run.
  std::string findings(const std::string& script, const std::string& particles = "") const {
    return findings_of_whole("fix pad1 all mesh/surface file pad.stl type 1\n" + script + "run 1000\n", particles);
  }
  std::string findings_of_whole(const std::string& script, const std::string& particles = "",
                                const std::string& name = "in.grains") const {
    text_.write(name, script);
    const std::string scene = R"(end_time = 1
[[bodies]]
name = "pad"
mass = 1
shape = { kind = "disc", radius = 0.2, thickness = 0.01 }
[[boundaries]]
body = "pad"
surface = {}
[ground]
kind = "particles"
[particles]
script = ")" + name + "\"\n" + particles;
    return test::refusal([&] { warnings_ = text_.read(scene).warnings; });
  }
  SceneText text_;
  mutable std::vector<std::string> warnings_;  // of the last scene without findings
};

TEST_F(ScriptCheck, AcceptsAScriptThatCouples) {
  EXPECT_EQ(findings("variable dt index 1e-4\ntimestep ${dt}\nfix m all couple/mbd every 5 &\n mesh pad1 pad\n"), "");
}

TEST_F(ScriptCheck, FollowsIncludes) {
  text_.write("couple.in", "fix m all couple/mbd every 5 mesh pad1 pad\n");
  EXPECT_EQ(findings("timestep 1e-5\ninclude ${here}/couple.in\n"), "");
}

TEST_F(ScriptCheck, FollowsIncludesThatAVariableNames) {
  text_.write("couple.in", "fix m all couple/mbd every 5 mesh pad1 pad\n");
  EXPECT_EQ(findings("variable file index couple.in\ninclude ${here}/${file}\n"), "");
}

// ${here} is one word whatever the path of the script: `run` refuses paths that LIGGGHTS would split.
TEST_F(ScriptCheck, FollowsIncludesInAFolderWhosePathLiggghtsWouldSplit) {
  for (const std::string folder : {"two words", "it's", "no #1"}) {
    text_.write(folder + "/couple.in", "fix m all couple/mbd every ${every} mesh pad1 pad\n");
    for (const std::string lines :
         {"include ${here}/couple.in\n", "variable file index ${here}/couple.in\ninclude ${file}\n",
          "if \"1 > 0\" then \"variable file index ${here}/couple.in\"\ninclude ${file}\n",
          "if \"1 > 0\" then \"include ${here}/couple.in\"\n"}) {
      EXPECT_EQ(findings_of_whole("fix pad1 all mesh/surface file pad.stl type 1\n" + lines + "run 1000\n",
                                  "variables = { every = 5 }\n", folder + "/in.grains"),
                "")
          << folder << ": " << lines;
      EXPECT_THAT(warnings_, testing::IsEmpty()) << folder << ": " << lines;
    }
  }
}

TEST_F(ScriptCheck, FindsAFileOfAVariableWhosePathHasABlank) {
  const std::string bed = text_.write("two words/bed.grains", "");
  EXPECT_EQ(findings("read_restart ${bed}\nfix m all couple/mbd every 5 mesh pad1 pad\n",
                     "variables = { bed = \"" + bed + "\" }\n"),
            "");
}

TEST_F(ScriptCheck, FindsTheCouplingInBothBranchesOfAnIf) {
  EXPECT_EQ(findings("variable n index 3\n"
                     "if \"${n} > 2\" then \"fix m all couple/mbd every 5 mesh pad1 pad\" else &\n"
                     "  \"fix m all couple/mbd every 1 mesh pad1 pad\"\n"),
            "");
}

TEST_F(ScriptCheck, LeavesAFileThatOnlyLiggghtsCanNameToLiggghts) {
  EXPECT_EQ(findings("variable file getenv COUPLING\ninclude ${here}/${file}\n"), "");
}

// A scene on a base may hold variables for the script of the base.
TEST_F(ScriptCheck, AVariableThatResemblesNoneIsWarnedOf) {
  EXPECT_EQ(findings("variable every index 5\nfix m all couple/mbd every ${every} mesh pad1 pad\n",
                     "variables = { restitution = 0.4 }\n"),
            "");
}

TEST_F(ScriptCheck, AVariableThatTheBedNeverReadsIsMisspelt) {
  text_.write("in.bed", "variable depth index 0.3\n");
  EXPECT_THAT(findings("fix m all couple/mbd every 5 mesh pad1 pad\n",
                       "bed = { script = \"in.bed\", variables = { dept = 0.2 } }\n"),
              HasSubstr("particles.bed.variables.dept"));
}

TEST_F(ScriptCheck, ABedOfAnotherGravityWidthOrStiffnessIsWarnedOf) {
  const std::string material = "fix young all property/global youngsModulus peratomtype 5e6\n";
  text_.write("in.bed",
              "variable width index 1.2\nvariable dt index 1e-5\nfix g all gravity 9.81 vector 0 0 -1\n" + material);
  const auto warnings = [&](const std::string& script, const std::string& variables) {
    findings("variable width index 1.2\nfix m all couple/mbd every 5 mesh pad1 pad\n" + script, "");
    const Scene scene = text_.read(R"(end_time = 1
gravity = [0, 0, -1.63]
[[bodies]]
name = "pad"
mass = 1
shape = { kind = "disc", radius = 0.2, thickness = 0.01 }
[[boundaries]]
body = "pad"
surface = {}
[ground]
kind = "particles"
[particles]
script = "in.grains"
bed = { script = "in.bed", variables = { )" +
                                   variables + " } }\n");
    std::string all;
    for (const std::string& warning : scene.warnings) all += warning + "\n";
    return all;
  };
  const std::string moon = "fix g all gravity 1.63 vector 0 0 -1\n";
  EXPECT_THAT(warnings(moon, ""), HasSubstr("9.81"));
  EXPECT_NE(warnings("", "width = 2.0"), "");
  EXPECT_THAT(warnings("fix y all property/global youngsModulus peratomtype 35e6\n", ""), HasSubstr("5000000"));
  EXPECT_EQ(warnings("variable dt index 1e-4\n" + material, "dt = 2e-5, width = 1.2"), "");
}

TEST_F(ScriptCheck, GravityThatIsNotTheScenesIsAFinding) {
  const std::string couple = "fix m all couple/mbd every 5 mesh pad1 pad\n";
  EXPECT_NE(findings("fix g all gravity 9.81 vector 0 0 1\n" + couple), "");
  EXPECT_EQ(findings("fix g all gravity 9.81 vector 0 0 -2\n" + couple), "");
  EXPECT_EQ(
      findings("fix g all gravity 1.63 vector 0 0 -1\nfix m all couple/mbd every 5 gravity script mesh pad1 pad\n"),
      "");
}

TEST_F(ScriptCheck, AScriptMaySettleItsBedWithALargerTimeStep) {
  EXPECT_EQ(findings("timestep 5e-4\nrun 100\ntimestep 1e-4\nfix m all couple/mbd every 5 mesh pad1 pad\nrun 100\n"),
            "");
  EXPECT_THAT(findings("timestep 1e-4\nrun 100\ntimestep 5e-4\nfix m all couple/mbd every 5 mesh pad1 pad\nrun 100\n"),
              HasSubstr("0.0005"));
}

TEST_F(ScriptCheck, GrainsWithoutWeightAreWarnedOf) {
  const auto warnings = [&](const std::string& script) {
    EXPECT_EQ(findings("fix i all nve/sphere\n" + script + "fix m all couple/mbd every 5 mesh pad1 pad\n"), "");
    std::string all;
    for (const std::string& warning : warnings_) all += warning + "\n";
    return all;
  };
  EXPECT_THAT(warnings(""), HasSubstr("particles.script"));
  for (const char* line :
       {"fix g all gravity 9.81 vector 0 0 -1\n", "include ${rest}\n", "fix g all ${pull} 9.81\n",
        "if \"1 > 0\" then \"fix g all gravity 9.81 vector 0 0 -1\"\n", "variable n loop 2\nnext n\njump SELF l\n"})
    EXPECT_EQ(warnings(line), "") << line;
}

// mbd_solver/scene/particle_script.h: meshes taken over from a LIGGGHTS script.

constexpr const char* kTriangle =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 10 0 0\nvertex 20 0 0\nvertex 10 5 0\nendloop\nendfacet\nendsolid "
    "t\n";
constexpr double kSingle = 1e-6;  // STL is read in single precision

// The first corner of the mesh, (10, 0, 0) in the file, after the words of its line in the script.
Eigen::Vector3d first_corner(const std::string& words, const std::string& folder) {
  const SceneText text;
  text.write(folder + "t.stl", kTriangle);
  text.write(folder + "in.run", "variable size index 0.001\nfix m all mesh/surface/stress file ${here}/t.stl type 2 " +
                                    words + " stress on\nfix mbd all couple/mbd every 1 mesh m b\n");
  const Scene scene = text.read(
      "end_time = 1\n[[bodies]]\nname = \"b\"\nmass = 1\ninertia = [1, 1, 1]\nposition = [0, 0, 0]\n"
      "[[boundaries]]\nbody = \"b\"\nsurface = { from_script = \"m\" }\n[particles]\nscript = \"" +
      folder + "in.run\"\n");
  return boundary_surface(scene, scene.boundaries[0]).vertices[0];
}

void expect_at(const std::string& words, const Eigen::Vector3d& place, const std::string& folder = "") {
  EXPECT_LT((first_corner(words, folder) - place).norm(), kSingle * place.norm()) << words;
}

TEST(ScriptMesh, ScaleRotateAndMoveActInTheOrderOfTheScript) {
  expect_at("", {10, 0, 0});
  expect_at("scale ${size}", {0.01, 0, 0});
  expect_at("scale ${size} rotate axis 0 0 2 angle 90 move 1 0 0", {1, 0.01, 0});
  expect_at("move 0 0 1 scale 2 rotate axis 1 0 0 angle 90", {20, -2, 0});
  expect_at("rotate axis 0 0 1 angle 90 rotate axis 1 0 0 angle 90", {0, 0, 10});
}

TEST(ScriptMesh, IsFoundInAFolderWithABlank) { expect_at("scale ${size}", {0.01, 0, 0}, "two words/"); }

}  // namespace
}  // namespace footfall
