// Where runs begin: at static equilibrium, or at given coordinates of joints.

#include "mbd_solver/session/settle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/simulation.h"
#include "tests/support/refused.h"
#include "tests/support/scene_texts.h"
#include "tests/unit/scene/scene_text.h"
#include "tests/unit/session/never.h"

namespace footfall {
namespace {

// Places of all bodies at the start and at the end of a run.
struct Ends {
  std::vector<Eigen::Vector3d> first, last;
  double speed = 0.0;  // the largest
};
Ends ends_of(const Scene& scene) {
  Simulation simulation(scene, scene.end_time, nullptr);
  Ends ends;
  simulation.run(
      [&](const Sample& sample) {
        ends.last.clear();
        for (int i = 0; i < simulation.mechanism().model.body_count(); ++i) {
          ends.last.push_back(sample.kinematics.of(i).r);
          ends.speed = std::max(ends.speed, sample.kinematics.of(i).dr.norm());
        }
        if (ends.first.empty()) ends.first = ends.last;
      },
      test::kNever);
  return ends;
}

std::string at(double x, double z) { return test::lines("[", x, ", 0, ", z, "]"); }
std::string body(const std::string& name, double mass, double x, double z) { return test::body(name, mass, at(x, z)); }
std::string hinge(const std::string& name, const std::string& a, const std::string& b, double x, double z) {
  return test::joint(name, "revolute", a, b, at(x, z), "y");
}
std::string rail(const std::string& name, const std::string& a, const std::string& b, double z, double stiffness) {
  return test::joint(name, "prismatic", a, b, at(0.0, z), "z",
                     test::lines("[joints.displacement]\nspring = { stiffness = ", stiffness, " }\n"));
}

const std::string kHead = "end_time = 0.5\ngravity = [0, 0, -9.81]\n[initial]\nsettle = true\n";

// A flexible beam on the three springs of a planar joint, across the weight and turned by a torque: however it bends, each
// spring bears what acts along it.
TEST(Settle, FindsWhereThePlanarJointOfABeamBearsIt) {
  const Scene scene = SceneText().read(R"(end_time = 0.01
gravity = [3, -2, -9]
[initial]
settle = true
[materials.al]
density = 2700
young = 7e10
[[bodies]]
name = "beam"
material = "al"
shape = { kind = "rod", from = [-0.3, 0, 0], to = [0.3, 0, 0], diameter = 0.01 }
flexible = { modes = 4, elements = 6 }
[[joints]]
name = "table"
kind = "planar"
bodies = ["ground", "beam"]
point = [0, 0, 0]
axis = "z"
axis2 = [1, 1, 0.3]
[joints.angle]
spring = { stiffness = 2, damping = 0.02 }
[joints.displacement_x]
spring = { stiffness = 40, damping = 2 }
[joints.displacement_y]
spring = { stiffness = 60, damping = 2 }
[[forces]]
name = "twist"
body = "beam"
point = [0, 0, 0]
direction = [0, 0, 1]
torque = { polynomial = [0.7] }
)");
  Simulation simulation(scene, scene.end_time, nullptr);
  Eigen::Vector3d q;
  simulation.run(
      [&](const Sample& sample) {
        const Joint& table = simulation.mechanism().model.joint(0);
        for (int i = 0; i < 3; ++i)
          q[i] = JointCoordinate(simulation.mechanism().coordinates[static_cast<std::size_t>(i)].coordinate,
                                 sample.kinematics.pair(table.m1.body, table.m2.body), table.m1, table.m2)
                     .value();
      },
      test::kNever);
  const double mass = 2700.0 * 0.6 * 0.25 * kPi * 1e-4, diagonal = std::sqrt(0.5);
  EXPECT_NEAR(q[0], 0.7 / 2.0, 1e-5);
  EXPECT_NEAR(q[1], mass * (3.0 - 2.0) * diagonal / 40.0, 1e-6);
  EXPECT_NEAR(q[2], mass * (-3.0 - 2.0) * diagonal / 60.0, 1e-6);
}

// Two weights on two springs: each spring bears what hangs on it.
TEST(Settle, FindsWhereSpringsBearTheirWeights) {
  const Scene scene =
      SceneText().read(kHead + body("upper", 2.0, 0, 1) + body("lower", 3.0, 0, 0) +
                       rail("first", "ground", "upper", 1, 500) + rail("second", "upper", "lower", 0, 40));
  const Ends ends = ends_of(scene);
  const double upper = -9.81 * 5.0 / 500.0, lower = upper - 9.81 * 3.0 / 40.0;
  const double tolerance = 1e-6;  // 1e-7 g over the lowest omega^2, some 10
  EXPECT_NEAR(ends.first[0].z(), 1.0 + upper, tolerance);
  EXPECT_NEAR(ends.first[1].z(), lower, tolerance);
  EXPECT_NEAR(ends.last[1].z(), lower, 2.0 * tolerance);
  EXPECT_LT(ends.speed, 1e-5);
}

// A pendulum held out sideways swings far, and hangs.
TEST(Settle, LetsAPendulumHang) {
  const Scene scene = SceneText().read(kHead + body("bob", 2.0, 1, 0) + hinge("pivot", "ground", "bob", 0, 0));
  const Ends ends = ends_of(scene);
  EXPECT_NEAR(ends.first[0].x(), 0.0, 1e-6);
  EXPECT_NEAR(ends.first[0].z(), -1.0, 1e-9);
  EXPECT_LT(ends.speed, 1e-5);
}

// A motor that turns its rotor for ever is found by the turns, not by 1000 s of motion: 300 turns of a rotor of 1 kg m2 under 100 N m
// take 6 s and some ten thousand steps.
TEST(Settle, FindsARotorThatTurnsForEver) {
  const Scene scene = SceneText().read(kHead + body("rotor", 2.0, 0, 0) + hinge("pivot", "ground", "rotor", 0, 0) +
                                       "[[drives]]\nname = \"motor\"\nkind = \"torque\"\njoint = \"pivot\"\n"
                                       "command = { polynomial = [100] }\n");
  const std::string said = test::refusal([&] { ends_of(scene); });
  EXPECT_TRUE(test::names(said, {"E0665", "body \"rotor\" has turned 3", "times"})) << said;
}

// Joints hold everything: it rests where it is drawn, also without gravity, and although a force pulls at a light body.
TEST(Settle, LeavesAMechanismThatJointsHold) {
  const auto fixed = [](const std::string& a, const std::string& b, double x) {
    return "[[joints]]\nname = \"" + a + "_" + b + "\"\nkind = \"fixed\"\nbodies = [\"" + a + "\", \"" + b +
           "\"]\npoint = [" + std::to_string(x) + ", 0, 0]\n";
  };
  const Scene scene =
      SceneText().read("end_time = 0.01\ngravity = [0, 0, 0]\n[initial]\nsettle = true\n" + body("rod", 5.0, 1, 0) +
                       body("tip", 0.001, 1.5, 0) + fixed("ground", "rod", 0.0) + fixed("rod", "tip", 1.5) +
                       "[[forces]]\nname = \"pull\"\nbody = \"tip\"\nframe = \"inertial\"\ndirection "
                       "= \"z\"\nforce = { polynomial = [-10] }\n");
  const Ends ends = ends_of(scene);
  EXPECT_NEAR(ends.first[1].x(), 1.5, 1e-9);
  EXPECT_NEAR(ends.first[1].z(), 0.0, 1e-9);
}

// A force of the start holds; that it changes later is no matter.
TEST(Settle, TakesFunctionsOfTimeAsTheyStart) {
  const Scene scene = SceneText().read(kHead + body("mass", 2.0, 0, 0) + rail("rail", "ground", "mass", 0, 300) +
                                       "[[forces]]\nname = \"push\"\nbody = \"mass\"\nframe = \"inertial\"\ndirection "
                                       "= \"z\"\nforce = { polynomial = [50, 3000] }\n");
  const Ends ends = ends_of(scene);
  EXPECT_NEAR(ends.first[0].z(), (50.0 - 2.0 * 9.81) / 300.0, 1e-7);
  EXPECT_GT(ends.last[0].z(), 1.0);
}

// On a rigid plane: Hertz bears the weight.
TEST(Settle, StandsOnThePlane) {
  const Scene scene = SceneText().read(kHead + R"([[bodies]]
name = "ball"
mass = 2.0
shape = { kind = "sphere", centre = [0, 0, 0.12], radius = 0.1 }
[[boundaries]]
body = "ball"
surface = {}
[ground]
kind = "plane"
[ground.plane]
stiffness = 1e5
restitution = 0.5
impact_speed = 1.0
)");
  const Ends ends = ends_of(scene);
  EXPECT_NEAR(ends.first[0].z(), 0.1 - std::pow(2.0 * 9.81 / 1e5, 2.0 / 3.0), 1e-7);
  EXPECT_LT(ends.speed, 1e-5);
}

// A four-bar linkage: crank AB of length 1 up from A = (0, 0), coupler BC, rocker CD to D = (4, 0); the crank is given
// another angle, and the loop closes.
TEST(InitialJoints, MoveAClosedLoop) {
  const std::string loop = "end_time = 0.01\ngravity = [0, 0, 0]\n" + body("crank", 1.0, 0, 1) +
                           body("coupler", 1.0, 4, 2) + body("rocker", 1.0, 4, 1) +
                           hinge("a", "ground", "crank", 0, 0) + hinge("b", "crank", "coupler", 0, 1) +
                           hinge("c", "coupler", "rocker", 4, 2) + hinge("d", "rocker", "ground", 4, 0);
  for (const double angle : {0.0, 0.7, -1.2}) {
    const Scene scene = SceneText().read(loop + "[initial.joints.a]\nangle = " + std::to_string(angle) + "\n");
    const Ends ends = ends_of(scene);
    // About y: from z towards x. C is where the circles about B and D meet, on the branch of the drawing.
    const Eigen::Vector2d B(std::sin(angle), std::cos(angle)), D(4.0, 0.0), BD = D - B;
    const double coupler = std::sqrt(17.0), rocker = 2.0, d = BD.norm();
    const double along = (coupler * coupler - rocker * rocker + d * d) / (2.0 * d);
    const double across = std::sqrt(coupler * coupler - along * along);
    const Eigen::Vector2d e = BD / d, C = B + along * e + across * Eigen::Vector2d(-e.y(), e.x());
    const double tolerance = 1e-9;                     // of the closing
    EXPECT_NEAR(ends.first[0].x(), B.x(), tolerance);  // the crank's mass is at B, the coupler's at C
    EXPECT_NEAR(ends.first[0].z(), B.y(), tolerance);
    EXPECT_NEAR(ends.first[1].x(), C.x(), tolerance);
    EXPECT_NEAR(ends.first[1].z(), C.y(), tolerance);
    EXPECT_NEAR((ends.first[2].x() - D.x()) * 2.0, C.x() - D.x(), tolerance);  // half way from D to C
    EXPECT_LT(ends.speed, tolerance);
  }
}

// All coordinates of a joint that has several.
TEST(InitialJoints, MoveEveryCoordinateOfAJoint) {
  const Scene scene = SceneText().read("end_time = 0.001\ngravity = [0, 0, 0]\n" + body("puck", 1.0, 0, 0) +
                                       body("drill", 1.0, 1, 0) + R"([[joints]]
name = "table"
kind = "planar"
bodies = ["ground", "puck"]
point = [0, 0, 0]
axis = "z"
axis2 = [1, 1, 0]
[[joints]]
name = "guide"
kind = "cylindrical"
bodies = ["ground", "drill"]
point = [1, 0, 0]
axis = "z"
[initial.joints.table]
angle = 0.5
displacement_x = 0.02
displacement_y = -0.01
[initial.joints.guide]
angle = -0.7
displacement = 0.03
)");
  Simulation simulation(scene, scene.end_time, nullptr);
  const Ends ends = ends_of(scene);
  const double diagonal = std::sqrt(0.5), tolerance = 1e-9;  // of the closing [m]
  EXPECT_LT((ends.first[0] - diagonal * Eigen::Vector3d(0.02 + 0.01, 0.02 - 0.01, 0.0)).norm(), tolerance);
  EXPECT_LT((ends.first[1] - Eigen::Vector3d(1.0, 0.0, 0.03)).norm(), tolerance);
  simulation.run(
      [&](const Sample& sample) {
        const Eigen::Matrix3d A = sample.kinematics.of(0).A, B = sample.kinematics.of(1).A;
        EXPECT_NEAR(std::atan2(A(1, 0), A(0, 0)), 0.5, tolerance);
        EXPECT_NEAR(std::atan2(B(1, 0), B(0, 0)), -0.7, tolerance);
      },
      test::kNever);
}

// Bodies of aluminium: a crank up from A = (0, 0), a thin coupler that bends, a rocker up from D = (0.4, 0).
std::string flexible_loop(double coupler_end, const std::string& rest) {
  const auto rod = [](const std::string& name, double x1, double z1, double x2, double z2, double diameter) {
    const auto point = [](double x, double z) { return "[" + std::to_string(x) + ", 0, " + std::to_string(z) + "]"; };
    return "[[bodies]]\nname = \"" + name + "\"\nmaterial = \"al\"\nshape = { kind = \"rod\", from = " + point(x1, z1) +
           ", to = " + point(x2, z2) + ", diameter = " + std::to_string(diameter) + " }\n";
  };
  return "end_time = 0.001\ngravity = [0, 0, 0]\n[materials.al]\ndensity = 2700\nyoung = 7e10\n" +
         rod("crank", 0, 0, 0, 0.1, 0.02) + rod("coupler", 0, 0.1, coupler_end, 0.3, 0.008) +
         "flexible = { modes = 4, elements = 6 }\n" + rod("rocker", 0.4, 0, 0.4, 0.3, 0.02) +
         hinge("a", "ground", "crank", 0, 0) + hinge("b", "crank", "coupler", 0, 0.1) +
         "[[joints]]\nname = \"c\"\nkind = \"spherical\"\nbodies = [\"coupler\", \"rocker\"]\npoint_a = [" +
         std::to_string(coupler_end) + ", 0, 0.3]\npoint_b = [0.4, 0, 0.3]\n" + hinge("d", "ground", "rocker", 0.4, 0) +
         rest;
}
// Largest modal amplitude at the start, and the place of the rocker's middle.
struct Bent {
  double amplitude = 0.0;
  Eigen::Vector3d rocker;
};
Bent bent_at_start(const Scene& scene) {
  Simulation simulation(scene, scene.end_time, nullptr);
  Bent bent;
  bool first = true;
  simulation.run(
      [&](const Sample& sample) {
        if (first) bent = {sample.kinematics.of(1).a.lpNorm<Eigen::Infinity>(), sample.kinematics.of(2).r};
        first = false;
      },
      test::kNever);
  return bent;
}

// A loop goes to its start by turning its bodies, not by bending them: the rocker is where the rigid linkage has it.
TEST(InitialJoints, TurnBodiesRatherThanBendThem) {
  const double angle = 0.8;
  const Bent bent = bent_at_start(
      SceneText().read(flexible_loop(0.4, "[initial.joints.a]\nangle = " + std::to_string(angle) + "\n")));
  const Eigen::Vector2d B(0.1 * std::sin(angle), 0.1 * std::cos(angle)), D(0.4, 0.0), BD = D - B;
  const double coupler = std::hypot(0.4, 0.2), rocker = 0.3, d = BD.norm();
  const double along = (coupler * coupler - rocker * rocker + d * d) / (2.0 * d);
  const double across = std::sqrt(coupler * coupler - along * along);
  const Eigen::Vector2d e = BD / d, C = B + along * e + across * Eigen::Vector2d(-e.y(), e.x());
  const double tolerance = 1e-9;  // of the closing [m]
  EXPECT_NEAR(2.0 * (bent.rocker.x() - D.x()), C.x() - D.x(), tolerance);
  EXPECT_NEAR(2.0 * bent.rocker.z(), C.y(), tolerance);
  EXPECT_LT(bent.amplitude, tolerance);
}

// So does a drawing that does not quite close.
TEST(LargestGap, IsClosedByTurningBodiesRatherThanByBendingThem) {
  const Bent bent = bent_at_start(SceneText().read(flexible_loop(0.403, "[initial]\nlargest_gap = 0.005\n")));
  EXPECT_LT(bent.amplitude, 1e-9);
  EXPECT_GT(std::abs(bent.rocker.x() - 0.4), 1e-4);
}

// Where the joints leave no other way, a body bends: a clamped beam whose end is led 1 mm aside.
TEST(InitialJoints, BendABodyThatIsHeld) {
  const Scene scene = SceneText().read(R"(end_time = 0.001
gravity = [0, 0, 0]
[materials.al]
density = 2700
young = 7e10
[[bodies]]
name = "tip"
mass = 0.1
inertia = [1e-4, 1e-4, 1e-4]
position = [0.3, 0, 0]
[[bodies]]
name = "beam"
material = "al"
shape = { kind = "rod", from = [0, 0, 0], to = [0.3, 0, 0], diameter = 0.01 }
flexible = { modes = 4, elements = 6 }
[[bodies]]
name = "spare"
mass = 0.1
inertia = [1e-4, 1e-4, 1e-4]
position = [9, 0, 0]
[[joints]]
name = "clamp"
kind = "fixed"
bodies = ["ground", "beam"]
point = [0, 0, 0]
[[joints]]
name = "end"
kind = "spherical"
bodies = ["beam", "tip"]
point = [0.3, 0, 0]
[[joints]]
name = "rail"
kind = "prismatic"
bodies = ["ground", "tip"]
point = [0.3, 0, 0]
axis = "z"
[initial.joints.rail]
displacement = 0.001
)");
  EXPECT_GT(bent_at_start(scene).amplitude, 1e-5);
  EXPECT_NEAR(ends_of(scene).first[0].z(), 0.001, 1e-9);
}

}  // namespace
}  // namespace footfall
