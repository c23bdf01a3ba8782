// Findings of a scene and of its LIGGGHTS scripts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupler/base/pi.h"
#include "mbd_solver/scene/boundary_surface.h"
#include "mbd_solver/scene/check_script.h"
#include "mbd_solver/scene/scene_check.h"
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

class ScriptCheck : public ::testing::Test {
 protected:
  // A scene on grains whose script is `script`, between the mesh that it couples and the run.
  std::string findings(const std::string& script, const std::string& particles = "") const {
    return findings_of_whole("fix pad1 all mesh/surface file pad.stl type 1\n" + script + "run 1000\n", particles);
  }
  std::string findings_of_whole(const std::string& script, const std::string& particles = "") const {
    text_.write("in.grains", script);
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
script = "in.grains"
)" + particles;
    try {
      warnings_ = text_.read(scene).warnings;
    } catch (const InputError& error) {
      return error.what();
    }
    return "no findings";
  }
  SceneText text_;
  mutable std::vector<std::string> warnings_;  // of the last scene without findings
};

TEST_F(ScriptCheck, AcceptsAScriptThatCouples) {
  EXPECT_EQ(findings("variable dt index 1e-4\ntimestep ${dt}\nfix m all couple/mbd every 5 &\n mesh pad1 pad\n"),
            "no findings");
}

TEST_F(ScriptCheck, FollowsIncludes) {
  text_.write("couple.in", "fix m all couple/mbd every 5 mesh pad1 pad\n");
  EXPECT_EQ(findings("timestep 1e-5\ninclude ${here}/couple.in\n"), "no findings");
}

TEST_F(ScriptCheck, FollowsIncludesThatAVariableNames) {
  text_.write("couple.in", "fix m all couple/mbd every 5 mesh pad1 pad\n");
  EXPECT_EQ(findings("variable file index couple.in\ninclude ${here}/${file}\n"), "no findings");
}

TEST_F(ScriptCheck, FindsTheCouplingInBothBranchesOfAnIf) {
  EXPECT_EQ(findings("variable n index 3\n"
                     "if \"${n} > 2\" then \"fix m all couple/mbd every 5 mesh pad1 pad\" else &\n"
                     "  \"fix m all couple/mbd every 1 mesh pad1 pad\"\n"),
            "no findings");
}

TEST_F(ScriptCheck, LeavesAFileThatOnlyLiggghtsCanNameToLiggghts) {
  EXPECT_EQ(findings("variable file getenv COUPLING\ninclude ${here}/${file}\n"), "no findings");
}

TEST_F(ScriptCheck, AScriptThatIncludesItselfIsAFinding) {
  text_.write("again.in", "include ${here}/in.grains\n");
  EXPECT_THAT(findings("timestep 1e-5\ninclude ${here}/again.in\nfix m all couple/mbd every 5 mesh pad1 pad\n"),
              HasSubstr("again.in:1 includes a file that includes this line again"));
}

TEST_F(ScriptCheck, AVariableThatNamesItselfIsAFinding) {
  EXPECT_THAT(findings("variable a index ${a}\nfix m all couple/mbd every ${a} mesh pad1 pad\n",
                       "variables = { a = \"x${a}\" }\n"),
              HasSubstr("particles.variables.a: the variable names itself: a -> a; give it a value"));
}

TEST_F(ScriptCheck, AVariableThatTheScriptNeverReadsIsMisspelt) {
  EXPECT_THAT(findings("variable every index 5\nfix m all couple/mbd every ${every} mesh pad1 pad\n",
                       "variables = { evry = 2 }\n"),
              HasSubstr("particles.variables.evry: the script neither declares nor reads such a variable. Known "
                        "variables: every. Did you mean \"every\"?"));
  for (const char* reads : {"print \"$k\"", "variable b equal 2*v_k", "variable k index 1", "print '${k}'"})
    EXPECT_EQ(
        findings(std::string(reads) + "\nfix m all couple/mbd every 5 mesh pad1 pad\n", "variables = { k = 2 }\n"),
        "no findings")
        << reads;
}

// A scene on a base may hold variables for the script of the base.
TEST_F(ScriptCheck, AVariableThatResemblesNoneIsWarnedOf) {
  EXPECT_EQ(findings("variable every index 5\nfix m all couple/mbd every ${every} mesh pad1 pad\n",
                     "variables = { restitution = 0.4 }\n"),
            "no findings");
}

TEST_F(ScriptCheck, AVariableThatTheBedNeverReadsIsMisspelt) {
  text_.write("in.bed", "variable depth index 0.3\n");
  EXPECT_THAT(findings("fix m all couple/mbd every 5 mesh pad1 pad\n",
                       "bed = { script = \"in.bed\", variables = { dept = 0.2 } }\n"),
              HasSubstr("particles.bed.variables.dept: the script neither declares nor reads such a variable. Known "
                        "variables: depth. Did you mean \"depth\"?"));
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
  EXPECT_THAT(warnings(moon, ""), HasSubstr("the bed is made with gravity = 9.81 vector 0 0 -1, the run has 1.63"));
  EXPECT_THAT(warnings("", "width = 2.0"), HasSubstr("the bed is made with variable width = 2, the run has 1.2"));
  EXPECT_THAT(warnings("fix y all property/global youngsModulus peratomtype 35e6\n", ""),
              HasSubstr("the bed is made with youngsModulus = peratomtype 5000000, the run has peratomtype 35000000"));
  EXPECT_EQ(warnings("variable dt index 1e-4\n" + material, "dt = 2e-5, width = 1.2"), "");
}

TEST_F(ScriptCheck, GravityThatIsNotTheScenesIsAFinding) {
  const std::string couple = "fix m all couple/mbd every 5 mesh pad1 pad\n";
  EXPECT_THAT(findings("fix g all gravity 9.81 vector 0 0 1\n" + couple),
              HasSubstr("the grains have the gravity [0, 0, 9.81] m/s2"));
  EXPECT_EQ(findings("fix g all gravity 9.81 vector 0 0 -2\n" + couple), "no findings");
  EXPECT_EQ(
      findings("fix g all gravity 1.63 vector 0 0 -1\nfix m all couple/mbd every 5 gravity script mesh pad1 pad\n"),
      "no findings");
}

TEST_F(ScriptCheck, AScriptMaySettleItsBedWithALargerTimeStep) {
  EXPECT_EQ(findings("timestep 5e-4\nrun 100\ntimestep 1e-4\nfix m all couple/mbd every 5 mesh pad1 pad\nrun 100\n"),
            "no findings");
  EXPECT_THAT(findings("timestep 1e-4\nrun 100\ntimestep 5e-4\nfix m all couple/mbd every 5 mesh pad1 pad\nrun 100\n"),
              HasSubstr("the script's time step is 0.0005 s"));
}

TEST_F(ScriptCheck, AScriptThatNeverCouplesIsAFinding) {
  EXPECT_THAT(findings("timestep 1e-5\n# fix m all couple/mbd every 5\n"),
              HasSubstr("particles.script: has no line \"fix ID all couple/mbd ...\""));
}

TEST_F(ScriptCheck, ATooLargeTimeStepNeedsAnExplicitWord) {
  const std::string script = "variable dt index 1e-4\ntimestep ${dt}\nfix m all couple/mbd every 5 mesh pad1 pad\n";
  EXPECT_THAT(findings(script, "variables = { dt = 2e-4 }\n"), HasSubstr("the script's time step is 0.0002 s"));
  EXPECT_EQ(findings(script, "variables = { dt = 2e-4 }\nmax_time_step = 2e-4\n"), "no findings");
}

TEST_F(ScriptCheck, ABodyWithoutBoundaryIsGuessed) {
  EXPECT_THAT(findings("fix g all couple/mbd/geometry body pat\nfix m all couple/mbd every 5 mesh pad1 pad\n"),
              HasSubstr("asks for the body \"pat\", which has no boundary in this scene. Known boundaries: pad. Did "
                        "you mean \"pad\"?"));
}

const char* const kMesh = "fix pad1 all mesh/surface file pad.stl type 1\n";

TEST_F(ScriptCheck, AMeshThatNoLineMakesIsAFinding) {
  const std::string couple = "fix m all couple/mbd every 5 mesh digger pad\nrun 1\n";
  EXPECT_THAT(
      findings_of_whole(kMesh + couple),
      HasSubstr("in.grains:2 couples the mesh \"digger\", but no fix mesh/surface of this id stands before this "
                "line. Known meshes: pad1."));
  // Where the text does not say it, LIGGGHTS has the word.
  for (const char* line :
       {"variable n loop 2\nlabel l\nnext n\njump SELF l\n", "include ${file}\n",
        "fix ${id} all mesh/surface file pad.stl type 1\n", "fix a all ${style} file pad.stl type 1\n",
        "if \"1 > 0\" then \"fix digger all mesh/surface file pad.stl type 1\"\n"})
    EXPECT_EQ(findings_of_whole(line + couple), "no findings") << line;
}

TEST_F(ScriptCheck, AMeshOfABodyThatTheSceneLacksIsAFinding) {
  EXPECT_THAT(
      findings("fix m all couple/mbd every 5 mesh pad1 foot\n"),
      HasSubstr("in.grains:2 asks for the body \"foot\", which has no boundary in this scene. Known boundaries: "
                "pad."));
  EXPECT_EQ(findings("fix m all couple/mbd every 5 mesh pad1 ${body}\n"), "no findings");
  EXPECT_EQ(findings("jump SELF mine\nfix m all couple/mbd every 5 mesh pad1 foot\nlabel mine\n"
                     "fix m all couple/mbd every 5 mesh pad1 pad\n"),
            "no findings");
  EXPECT_EQ(findings("fix mesh all mesh/surface file pad.stl type 1\nfix m all couple/mbd every 5 mesh mesh pad\n"),
            "no findings");
}

TEST_F(ScriptCheck, AWrongWordOfTheCouplingIsAFinding) {
  EXPECT_THAT(findings("fix m all couple/mbd evry 5 mesh pad1 pad\n"),
              HasSubstr("in.grains:2: fix m couple/mbd: at \"evry\" (did you mean \"every\"?) expected: fix ID all"));
  EXPECT_THAT(findings("fix m all couple/mbd every 5 patience soon mesh pad1 pad\n"),
              HasSubstr("in.grains:2: fix m couple/mbd: `patience` needs a positive number of seconds, not \"soon\""));
  EXPECT_EQ(findings("fix m all couple/mbd ${windows} mesh pad1 pad\n"), "no findings");
}

TEST_F(ScriptCheck, ACouplingThatNoRunFollowsIsAFinding) {
  const std::string couple = "fix m all couple/mbd every 5 mesh pad1 pad\n";
  EXPECT_THAT(findings_of_whole(kMesh + std::string("run 100\n") + couple),
              HasSubstr("in.grains:3 couples, but no run stands behind this line"));
  for (const char* line :
       {"run 1\n", "if \"1 > 0\" then \"run 1\"\n", "include ${rest}\n", "${go} 100\n", "jump ${rest}\n"})
    EXPECT_EQ(findings_of_whole(kMesh + couple + line), "no findings") << line;
}

TEST_F(ScriptCheck, StepsThatAreResetUnderTheCouplingAreAFinding) {
  const std::string couple = "fix m all couple/mbd every 5 mesh pad1 pad\nrun 1\n", reset = "reset_timestep 0\n";
  EXPECT_THAT(findings(couple + reset), HasSubstr("in.grains:4 resets the steps that the coupling ("));
  for (const std::string& script :
       {reset + couple, couple + "unfix m\n" + reset, couple + "clear\n" + reset,
        couple + "if \"1 > 0\" then \"reset_timestep 0\"\n", couple + "label l\n" + reset + "jump SELF l\n"})
    EXPECT_EQ(findings(script), "no findings") << script;
}

TEST_F(ScriptCheck, GrainsWithoutWeightAreWarnedOf) {
  const auto warnings = [&](const std::string& script) {
    EXPECT_EQ(findings("fix i all nve/sphere\n" + script + "fix m all couple/mbd every 5 mesh pad1 pad\n"),
              "no findings");
    std::string all;
    for (const std::string& warning : warnings_) all += warning + "\n";
    return all;
  };
  EXPECT_THAT(warnings(""),
              HasSubstr("particles.script: has no fix gravity, and the scene the gravity [0, 0, -9.81] m/s2: "
                        "the grains have no weight"));
  for (const char* line :
       {"fix g all gravity 9.81 vector 0 0 -1\n", "include ${rest}\n", "fix g all ${pull} 9.81\n",
        "if \"1 > 0\" then \"fix g all gravity 9.81 vector 0 0 -1\"\n", "variable n loop 2\nnext n\njump SELF l\n"})
    EXPECT_EQ(warnings(line), "") << line;
}

TEST_F(ScriptCheck, AMeshInMillimetresIsTold) {
  const auto stl = [&](const char* name, const char* low, const char* high) {
    const std::string l = std::string(low) + " ", h = std::string(high) + " ";
    text_.write(name, "solid s\nfacet normal 0 0 1\nouter loop\nvertex " + l + l + l + "\nvertex " + h + l + l +
                          "\nvertex " + h + h + h + "\nendloop\nendfacet\nendsolid s\n");
  };
  stl("far.stl", "100", "200");
  stl("around.stl", "-100", "100");
  const std::string box = "boundary f f f\nregion r block -0.3 0.3 -0.3 0.3 0 0.3 units box\ncreate_box 2 r\n",
                    couple = "fix m all couple/mbd every 5 mesh pad1 pad\n",
                    far = "fix s all mesh/surface file far.stl type 2\n";
  EXPECT_THAT(
      findings(box + far + couple),
      HasSubstr("in.grains:5: mesh s measures 100 x 100 x 100 m, the simulation box 0.6 x 0.6 x 0.3 m; if it is "
                "drawn in millimetres, add  scale 0.001"));
  // A part may be left in the box.
  EXPECT_EQ(findings(box + "fix s all mesh/surface file around.stl type 2\n" + couple), "no findings");
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_THAT(warnings_[0], HasSubstr("mesh s measures 200 x 200 x 200 m"));
  for (const char* line : {"fix s all mesh/surface file far.stl type 2 scale 0.001\n",
                           "fix s all mesh/surface file far.stl type 2 scale ${mm}\n",
                           "if \"1 > 0\" then \"fix s all mesh/surface file far.stl type 2\"\n"}) {
    EXPECT_EQ(findings(box + line + couple), "no findings") << line;
    EXPECT_TRUE(warnings_.empty()) << line;
  }
  EXPECT_EQ(findings("region r block 0 ${l} 0 1 0 1\ncreate_box 2 r\n" + far + couple), "no findings");
  EXPECT_TRUE(warnings_.empty());
}

// mbd_solver/scene/script_mesh.h: meshes taken over from a LIGGGHTS script.

constexpr const char* kTriangle =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 10 0 0\nvertex 20 0 0\nvertex 10 5 0\nendloop\nendfacet\nendsolid "
    "t\n";
constexpr double kSingle = 1e-6;  // STL is read in single precision

// The first corner of the mesh, (10, 0, 0) in the file, after the words of its line in the script.
Eigen::Vector3d first_corner(const std::string& words) {
  const SceneText text;
  text.write("t.stl", kTriangle);
  text.write("in.run", "variable size index 0.001\nfix m all mesh/surface/stress file ${here}/t.stl type 2 " + words +
                           " stress on\nfix mbd all couple/mbd every 1 mesh m b\n");
  const Scene scene = text.read(
      "end_time = 1\n[[bodies]]\nname = \"b\"\nmass = 1\ninertia = [1, 1, 1]\nposition = [0, 0, 0]\n"
      "[[boundaries]]\nbody = \"b\"\nsurface = { from_script = \"m\" }\n[particles]\nscript = \"in.run\"\n");
  return boundary_surface(scene, scene.boundaries[0]).vertices[0];
}

void expect_at(const std::string& words, const Eigen::Vector3d& place) {
  EXPECT_LT((first_corner(words) - place).norm(), kSingle * place.norm()) << words;
}

TEST(ScriptMesh, ScaleRotateAndMoveActInTheOrderOfTheScript) {
  expect_at("", {10, 0, 0});
  expect_at("scale ${size}", {0.01, 0, 0});
  expect_at("scale ${size} rotate axis 0 0 2 angle 90 move 1 0 0", {1, 0.01, 0});
  expect_at("move 0 0 1 scale 2 rotate axis 1 0 0 angle 90", {20, -2, 0});
  expect_at("rotate axis 0 0 1 angle 90 rotate axis 1 0 0 angle 90", {0, 0, 10});
}

}  // namespace
}  // namespace footfall
