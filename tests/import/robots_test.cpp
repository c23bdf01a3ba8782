// Robots of a few links, each with one feature, become scenes; the scenes are read back and hold what the file says, in the
// inertial frame. Tolerance of placements and inertias: 1e-12 of their size, some rotations in double precision.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <optional>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/bed/bed_forecast.h"
#include "mbd_solver/bed/bed_report.h"
#include "mbd_solver/import/import_command.h"
#include "mbd_solver/import/robot.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/observe/start_check.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

constexpr double kExact = 1e-12;

Eigen::Matrix3d rz(double a) { return Eigen::AngleAxisd(a, Eigen::Vector3d::UnitZ()).toRotationMatrix(); }
Eigen::Matrix3d ry(double a) { return Eigen::AngleAxisd(a, Eigen::Vector3d::UnitY()).toRotationMatrix(); }
Eigen::Matrix3d rx(double a) { return Eigen::AngleAxisd(a, Eigen::Vector3d::UnitX()).toRotationMatrix(); }

class Robots : public ::testing::Test, public TemporaryFolder {
 protected:
  // The scene of a file with this text.
  Scene imported(const std::string& name, const std::string& content, ImportArguments a = {}) {
    a.file = write(name, content);
    a.out = file("scene" + std::to_string(++count_));
    a.quiet = true;
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(import_command(a), 0);
    ::testing::internal::GetCapturedStdout();
    ::testing::internal::GetCapturedStderr();
    scene_text_ = text("scene" + std::to_string(count_) + "/scene.toml");
    return read_scene(a.out);
  }

  // I about the mass centre in axes of D.
  static Eigen::Matrix3d inertia_in_D(const BodySpec& body) {
    const Eigen::Matrix3d R = body.orientation.toRotationMatrix();
    return R * body.inertia * R.transpose();
  }
  static Eigen::Matrix3d axes(const BodySpec& body) { return body.orientation.toRotationMatrix(); }

  std::string scene_text_;

 private:
  int count_ = 0;
};

const Eigen::Matrix3d kInertia =
    (Eigen::Matrix3d() << 0.03, 0.002, -0.003, 0.002, 0.04, 0.004, -0.003, 0.004, 0.05).finished();
const char* const kInertial =
    "<inertial><origin xyz='0.1 0.2 0.3' rpy='0.4 -0.5 0.6'/><mass value='2'/>"
    "<inertia ixx='0.03' ixy='0.002' ixz='-0.003' iyy='0.04' iyz='0.004' izz='0.05'/></inertial>";
const char* const kBall =
    "<inertial><mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial>";

std::string link(const std::string& name, const std::string& inside = kBall) {
  return "<link name='" + name + "'>" + inside + "</link>\n";
}
std::string joint(const std::string& type, const std::string& inside, const std::string& parent = "a",
                  const std::string& child = "b", const std::string& name = "j") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         inside + "</joint>\n";
}
std::string urdf(const std::string& inside) { return "<robot name='test'>\n" + inside + "</robot>\n"; }

TEST_F(Robots, UrdfTurnedInertialFrameAndProducts) {
  const Scene s = imported("r.urdf", urdf(link("a", kInertial) + link("b", kInertial) +
                                          joint("revolute",
                                                "<origin xyz='1 2 3' rpy='0.3 0.2 -0.7'/><axis xyz='0 3 4'/>"
                                                "<limit lower='-1' upper='2' effort='5' velocity='6'/>")));
  const Eigen::Matrix3d R_LI = rz(0.6) * ry(-0.5) * rx(0.4), R = rz(-0.7) * ry(0.2) * rx(0.3);
  const BodySpec &a = *s.body("a"), &b = *s.body("b");
  EXPECT_EQ(a.mass, 2.0);
  EXPECT_LT((inertia_in_D(a) - R_LI * kInertia * R_LI.transpose()).norm(), kExact);
  EXPECT_LT((axes(b) - R).norm(), kExact);
  EXPECT_LT((b.position - (Eigen::Vector3d(1, 2, 3) + R * Eigen::Vector3d(0.1, 0.2, 0.3))).norm(), kExact);
  EXPECT_LT((inertia_in_D(b) - R * R_LI * kInertia * (R * R_LI).transpose()).norm(), kExact);
  const JointSpec& j = *s.joint("j");
  EXPECT_EQ(j.type, JointType::kRevolute);
  EXPECT_LT((j.axis - R * Eigen::Vector3d(0, 0.6, 0.8)).norm(), kExact);
  EXPECT_LT((j.point_a - Eigen::Vector3d(1, 2, 3)).norm(), kExact);
  ASSERT_TRUE(j.angle && j.angle->stops);
  EXPECT_EQ(j.angle->stops->smallest_stroke.value(), -1.0);
  EXPECT_EQ(j.angle->stops->largest_stroke.value(), 2.0);
}

// A scene asks whether more than a turn in radians is meant (W1167): such limits are written in degrees.
TEST_F(Robots, LimitsBeyondATurnAreWrittenInDegrees) {
  const Scene s = imported("r.urdf", urdf(link("a") + link("b") +
                                          joint("revolute",
                                                "<axis xyz='0 0 1'/>"
                                                "<limit lower='-6.28318530718' upper='7' effort='5' velocity='6'/>")));
  const JointSpec& j = *s.joint("j");
  EXPECT_NEAR(j.angle->stops->smallest_stroke.value(), -6.28318530718, kExact);
  EXPECT_NEAR(j.angle->stops->largest_stroke.value(), 7.0, kExact);
  EXPECT_EQ(j.source.in_other_units.count("angle.stops.min"), 1u);
  EXPECT_EQ(j.source.in_other_units.count("angle.stops.max"), 1u);
}

// A base that is fixed stands on the ground where it is drawn, however its joints start: its place does not come from a clearance,
// which counts the body that is lowest above the grains.
TEST_F(Robots, AFixedBaseStandsOnTheGround) {
  const std::string ball = kBall + std::string("<collision><geometry><sphere radius='0.1'/></geometry></collision>");
  const std::string robot = urdf(link("a", ball) + link("b", ball) +
                                 joint("revolute",
                                       "<origin xyz='0.5 0 0.4'/><axis xyz='0 1 0'/>"
                                       "<limit lower='-1' upper='1' effort='5' velocity='6'/>"));
  ImportArguments a;
  a.options.ground = "plane";
  const Scene free = imported("r.urdf", robot, a);
  EXPECT_TRUE(free.initial.clearance.has_value());
  a.options.fix_base = true;
  const Scene fixed = imported("r.urdf", robot, a);
  EXPECT_FALSE(fixed.initial.clearance.has_value());
  EXPECT_NEAR(fixed.initial.position.z(), 0.1, 1e-3);  // plus a thousandth of its size
  EXPECT_GT(fixed.initial.position.z(), 0.1);
}

TEST_F(Robots, UrdfQuaternionIsTheSameTurnAsRpy) {
  const Eigen::Quaterniond q(rz(-0.7) * ry(0.2) * rx(0.3));
  const std::string words =
      std::to_string(q.x()) + " " + std::to_string(q.y()) + " " + std::to_string(q.z()) + " " + std::to_string(q.w());
  const Scene s =
      imported("r.urdf", urdf(link("a") + link("b") + joint("fixed", "<origin quat_xyzw='" + words + "'/>")));
  EXPECT_LT((axes(*s.body("b")) - q.toRotationMatrix()).norm(), 1e-5);  // six digits in the file
}

TEST_F(Robots, UrdfKindsOfJoints) {
  const std::string axis = "<axis xyz='0 0 1'/>";
  std::string robot = link("a");
  for (const char* name : {"b", "c", "d", "e", "f"}) robot += link(name);
  robot += joint("continuous", axis + "<dynamics damping='0.3' friction='0.2'/>", "a", "b", "j1");
  robot += joint("prismatic", axis + "<limit lower='0' upper='1' effort='5' velocity='6'/><dynamics damping='7'/>", "a",
                 "c", "j2");
  robot += joint("planar", axis, "a", "d", "j3");
  robot += joint("floating", "", "a", "e", "j4");
  robot += joint("fixed", "", "a", "f", "j5");
  const Scene s = imported("r.urdf", urdf(robot));
  EXPECT_EQ(s.joints.size(), 4u);
  EXPECT_EQ(s.joint("j1")->type, JointType::kRevolute);
  EXPECT_FALSE(s.joint("j1")->angle->stops);
  EXPECT_EQ(s.joint("j1")->angle->friction->coulomb, 0.2);
  EXPECT_EQ(s.joint("j1")->angle->friction->viscous, 0.3);
  EXPECT_EQ(s.joint("j2")->type, JointType::kPrismatic);
  EXPECT_EQ(s.joint("j2")->displacement->spring->damping, 7.0);
  EXPECT_EQ(s.joint("j3")->type, JointType::kPlanar);
  EXPECT_EQ(s.joint("j5")->type, JointType::kFixed);
  EXPECT_EQ(s.body("e")->mass, 1.0);
}

TEST_F(Robots, UrdfMimicIsAGearAndIsDrawnAtItsOffset) {
  const Scene s = imported(
      "r.urdf", urdf(link("a") + link("b") + link("c") + joint("continuous", "<axis xyz='0 0 1'/>", "a", "b", "lead") +
                     joint("continuous", "<axis xyz='0 0 1'/><mimic joint='lead' multiplier='-2' offset='0.5'/>", "a",
                           "c", "follow")));
  ASSERT_EQ(s.gears.size(), 1u);
  EXPECT_EQ(s.gears[0].joints, (std::vector<std::string>{"follow", "lead"}));
  EXPECT_EQ(s.gears[0].factors, (std::vector<double>{1.0, 2.0}));
  EXPECT_LT((axes(*s.body("c")) - rz(0.5)).norm(), kExact);
}

// c follows b, which follows a's joint: at zero of it, b is at 0.5 rad and c at 0.25 - 2 0.5 rad.
TEST_F(Robots, UrdfMimicOfAMimicIsDrawnWhereBothPutIt) {
  const auto follow = [](const std::string& leader, double multiplier, double offset) {
    return "<axis xyz='0 0 1'/><mimic joint='" + leader + "' multiplier='" + std::to_string(multiplier) + "' offset='" +
           std::to_string(offset) + "'/>";
  };
  const Scene s = imported("r.urdf", urdf(link("a") + link("b") + link("c") + link("d") +
                                          joint("continuous", "<axis xyz='0 0 1'/>", "a", "b", "lead") +
                                          joint("continuous", follow("lead", 3.0, 0.5), "a", "c", "first") +
                                          joint("continuous", follow("first", -2.0, 0.25), "a", "d", "second")));
  ASSERT_EQ(s.gears.size(), 2u);
  EXPECT_LT((axes(*s.body("c")) - rz(0.5)).norm(), kExact);
  EXPECT_LT((axes(*s.body("d")) - rz(-0.75)).norm(), kExact);
  EXPECT_FALSE(test::names(scene_text_, {"Not in this scene"}));
}

TEST_F(Robots, MasslessLinksJoinTheirNeighbours) {
  const Scene s =
      imported("r.urdf", urdf("<link name='world'/><link name='foot'/><link name='tool'/>" + link("a") + link("b") +
                              joint("fixed", "", "world", "foot", "j1") +
                              joint("fixed", "<origin xyz='0 0 1'/>", "foot", "a", "j2") +
                              joint("continuous", "", "a", "b", "j3") + joint("fixed", "", "b", "tool", "j4")));
  EXPECT_EQ(s.bodies.size(), 2u);
  ASSERT_EQ(s.joints.size(), 2u);
  EXPECT_EQ(s.joints[0].bodies[0], "ground");
  EXPECT_EQ(s.body("a")->position.z(), 1.0);
}

TEST_F(Robots, MergedFixedLinksKeepMassCentreAndInertia) {
  ImportArguments a;
  a.options.merge_fixed = true;
  const Scene s = imported("r.urdf", urdf(link("a") + link("b") + joint("fixed", "<origin xyz='2 0 0'/>")), a);
  ASSERT_EQ(s.bodies.size(), 1u);
  EXPECT_EQ(s.bodies[0].mass, 2.0);
  EXPECT_LT((s.bodies[0].position - Eigen::Vector3d(1, 0, 0)).norm(), kExact);
  // 0.01 each, and 1 kg at 1 m on either side.
  EXPECT_LT((inertia_in_D(s.bodies[0]) - Eigen::Vector3d(0.02, 2.02, 2.02).asDiagonal().toDenseMatrix()).norm(),
            kExact);
}

TEST_F(Robots, CollisionsBecomeShapesAndMeshes) {
  const std::string ball = "<collision><origin xyz='0 0 1'/><geometry><sphere radius='0.2'/></geometry></collision>";
  const std::string box =
      "<collision><origin rpy='0 0 0.5'/><geometry><box size='0.1 0.2 0.3'/></geometry></collision>";
  const std::string rod =
      "<collision><origin rpy='0 1.5707963267948966 0'/><geometry><capsule radius='0.1' "
      "length='0.4'/></geometry></collision>";
  const Scene s = imported("r.urdf", urdf(link("a", kBall + ball) + link("b", kBall + box) + link("c", kBall + rod) +
                                          link("d", kBall + ball + box) + joint("fixed", "", "a", "b", "j1") +
                                          joint("fixed", "", "b", "c", "j2") + joint("fixed", "", "c", "d", "j3")));
  EXPECT_EQ(s.boundaries.size(), 4u);
  EXPECT_EQ(s.body("a")->shape->kind, ShapeKind::kSphere);
  EXPECT_EQ(s.body("a")->shape->centre.z(), 1.0);
  EXPECT_FALSE(s.body("b")->shape);  // a box turned against its body
  EXPECT_TRUE(std::filesystem::exists(s.boundary_of("b")->surface->file));
  EXPECT_EQ(s.body("c")->shape->kind, ShapeKind::kCapsule);
  EXPECT_LT((s.body("c")->shape->to - Eigen::Vector3d(0.2, 0, 0)).norm(), kExact);
  EXPECT_TRUE(std::filesystem::exists(s.boundary_of("d")->surface->file));
  EXPECT_EQ(s.body("a")->mass, 1.0);  // of the file, not of the shape
}

TEST_F(Robots, WhatASceneCannotSayIsListedWithItsLine) {
  const std::string content = urdf(link("a") + link("b") + joint("continuous", "<safety_controller k_velocity='1'/>") +
                                   "<transmission name='t1'>\n</transmission>\n<gazebo/>\n<strange unit='x'/>\n");
  imported("r.urdf", content);
  EXPECT_TRUE(test::names(scene_text_, {"r.urdf:4: <safety_controller>", "r.urdf:5: <transmission \"t1\">",
                                        "r.urdf:7: <gazebo>", "r.urdf:8: <strange>"}));
  ImportArguments strict;
  strict.file = file("r.urdf");
  strict.out = file("strict");
  strict.strict = true;
  EXPECT_TRUE(test::names(test::error_of([&] { import_command(strict); }), {"robot-strict", "r.urdf:5"}));
  EXPECT_FALSE(std::filesystem::exists(strict.out));
}

std::string mjcf(const std::string& world, const std::string& rest = "") {
  return "<mujoco model='test'>\n<compiler angle='radian'/>\n<worldbody>\n" + world + "</worldbody>\n" + rest +
         "</mujoco>\n";
}
const char* const kMass = "<inertial pos='0 0 0' mass='1' diaginertia='0.01 0.01 0.01'/>";

TEST_F(Robots, MjcfOrientations) {
  // The same turn by a quaternion (w first), axis and angle, Euler angles about turning and about fixed axes, and two axes.
  const Eigen::Matrix3d R = rx(0.3) * ry(0.2) * rz(-0.7);
  const Eigen::Quaterniond q(R);
  const Eigen::AngleAxisd turn(R);
  char text[200];
  const auto body = [&](const std::string& name, const std::string& orientation) {
    return "<body name='" + name + "' pos='0 0 1' " + orientation + ">" + kMass + "<freejoint/></body>\n";
  };
  std::snprintf(text, sizeof text, "quat='%.17g %.17g %.17g %.17g'", q.w(), q.x(), q.y(), q.z());
  std::string world = body("a", text);
  std::snprintf(text, sizeof text, "axisangle='%.17g %.17g %.17g %.17g'", turn.axis().x(), turn.axis().y(),
                turn.axis().z(), turn.angle());
  world += body("b", text);
  world += body("c", "euler='0.3 0.2 -0.7'");
  std::snprintf(text, sizeof text, "xyaxes='%.17g %.17g %.17g %.17g %.17g %.17g'", R(0, 0), R(1, 0), R(2, 0), R(0, 1),
                R(1, 1), R(2, 1));
  world += body("d", text);
  const Scene s = imported("r.xml", mjcf(world));
  for (const char* name : {"a", "b", "c", "d"}) EXPECT_LT((axes(*s.body(name)) - R).norm(), kExact) << name;
  std::string fixed_axes = mjcf(body("e", "euler='0.3 0.2 -0.7'"));
  fixed_axes.replace(fixed_axes.find("angle='radian'"), 14, "angle='radian' eulerseq='XYZ'");
  EXPECT_LT((axes(*imported("e.xml", fixed_axes).body("e")) - rz(-0.7) * ry(0.2) * rx(0.3)).norm(), kExact);
  std::string degrees = mjcf(body("f", "euler='30 0 0'"));
  degrees.replace(degrees.find("angle='radian'"), 14, "angle='degree'");
  EXPECT_LT((axes(*imported("f.xml", degrees).body("f")) - rx(kPi / 6.0)).norm(), kExact);
}

TEST_F(Robots, MjcfTurnedInertialFrameAndFullInertia) {
  const Scene s = imported("r.xml", mjcf("<body name='a'><inertial pos='0.1 0.2 0.3' mass='2' fullinertia='0.03 0.04 "
                                         "0.05 0.002 -0.003 0.004'/><freejoint/></body>"
                                         "<body name='b' euler='0.1 0.2 0.3'><inertial pos='0 0 0' mass='2' quat='0.5 "
                                         "0.5 0.5 0.5' diaginertia='0.03 0.04 0.05'/><freejoint/></body>"));
  // MuJoCo finds the principal axes of a full inertia by rotations that end below 1e-6.
  EXPECT_LT((inertia_in_D(*s.body("a")) - kInertia).norm(), 1e-6 * kInertia.norm());
  // The frame (0.5, 0.5, 0.5, 0.5) has its x along y, y along z, z along x.
  const Eigen::Matrix3d R = rx(0.1) * ry(0.2) * rz(0.3);
  EXPECT_LT((inertia_in_D(*s.body("b")) - R * Eigen::Vector3d(0.05, 0.03, 0.04).asDiagonal() * R.transpose()).norm(),
            kExact);
}

TEST_F(Robots, MjcfInertiaOfGeomsAndDefaults) {
  const Scene s =
      imported("r.xml",
               "<mujoco><default><geom density='500'/><default class='heavy'><geom "
               "density='2000'/></default></default><worldbody>"
               "<body name='a'><freejoint/><geom type='box' size='0.1 0.2 0.3'/></body>"
               "<body name='b'><freejoint/><geom class='heavy' type='sphere' size='0.1'/></body></worldbody></mujoco>");
  EXPECT_NEAR(s.body("a")->mass, 500.0 * 0.2 * 0.4 * 0.6, 1e-12 * 24.0);
  EXPECT_NEAR(s.body("b")->mass, 2000.0 * 4.0 / 3.0 * kPi * 1e-3, 1e-12 * 8.4);
  EXPECT_EQ(s.body("a")->shape->kind, ShapeKind::kBox);
}

TEST_F(Robots, MjcfJointsWithLawsRotorsAndMotors) {
  const Scene s =
      imported("r.xml", mjcf("<body name='a'>" + std::string(kMass) +
                                 "<joint name='h' type='hinge' axis='0 1 0' range='-1 2' limited='true' damping='0.3' "
                                 "armature='0.02' stiffness='4' springref='0.5' ref='0.1'/>"
                                 "<body name='b' pos='0 0 1'>" +
                                 kMass +
                                 "<joint name='s' type='slide' axis='0 0 1' frictionloss='3' armature='0.5'/>"
                                 "<body name='c' pos='0 0 1'>" +
                                 kMass + "<joint type='ball' name='q'/></body></body></body>",
                             "<actuator><position name='p' joint='h' kp='100' gear='2' ctrllimited='true' "
                             "ctrlrange='-3 3' forcelimited='true' forcerange='-20 20'/></actuator>"
                             "<keyframe><key qpos='0.7 0.2 1 0 0 0' ctrl='0.6'/></keyframe>"));
  const JointSpec& h = *s.joint("h");
  EXPECT_NEAR(h.angle->stops->smallest_stroke.value(), -1.7, kExact);  // counted from the keyframe, for the ball joint
  EXPECT_NEAR(h.angle->spring->free_stroke, -0.2, kExact);
  EXPECT_EQ(h.angle->spring->damping, 0.3);
  EXPECT_EQ(s.joint("s")->displacement->friction->coulomb, 3.0);
  EXPECT_EQ(s.joint("q")->type, JointType::kSpherical);
  ASSERT_EQ(s.drives.size(), 2u);
  const DriveSpec& p = s.drives[0];
  EXPECT_EQ(p.motor.kind, MotorKind::kPosition);
  EXPECT_EQ(p.motor.kp, 400.0);              // kp gear^2
  EXPECT_EQ(*p.motor.largest_torque, 40.0);  // times gear
  EXPECT_EQ(p.rotor_inertia, 0.02);
  EXPECT_NEAR(p.command->polynomial[0], 0.6 / 2.0 - 0.7, kExact);  // ctrl is gear q
  EXPECT_EQ(s.drives[1].rotor_inertia, 0.5);
  EXPECT_TRUE(s.initial.joints.empty());
  // Without ball joint: drawn at qpos0, that is at ref.
  const Scene t =
      imported("t.xml", mjcf("<body name='a'>" + std::string(kMass) + "<joint name='h' range='-1 2' ref='0.1'/></body>",
                             "<keyframe><key qpos='0.7'/></keyframe>"));
  EXPECT_NEAR(t.joint("h")->angle->stops->smallest_stroke.value(), -1.1, kExact);
  ASSERT_EQ(t.initial.joints.size(), 1u);
  EXPECT_NEAR(*t.initial.joints[0].angle, 0.6, kExact);
}

TEST_F(Robots, MjcfSeveralJointsOfABody) {
  const Scene s = imported(
      "r.xml", mjcf("<body name='flat'>" + std::string(kMass) +
                    "<joint name='x' type='slide' axis='1 0 0'/><joint name='z' type='slide' axis='0 0 1'/><joint "
                    "name='y' type='hinge' axis='0 1 0'/></body>"
                    "<body name='screw'>" +
                    kMass +
                    "<joint name='s' type='slide' axis='0 0 1'/><joint name='t' type='hinge' axis='0 0 1'/></body>"
                    "<body name='hip'>" +
                    kMass +
                    "<joint name='h1' type='hinge' axis='1 0 0'/><joint name='h2' type='hinge' axis='0 1 0' range='0 "
                    "1' limited='true'/></body>"));
  EXPECT_EQ(s.joint("y")->type, JointType::kPlanar);
  EXPECT_EQ(s.joint("t")->type, JointType::kCylindrical);
  EXPECT_EQ(s.joint("h1")->type, JointType::kRevolute);
  EXPECT_EQ(s.joint("h2")->type, JointType::kRevolute);
  EXPECT_EQ(s.joint("h1")->bodies[1], s.joint("h2")->bodies[0]);
  EXPECT_LT(s.body(s.joint("h1")->bodies[1])->mass, 1e-6);
}

TEST_F(Robots, MjcfLoopsCouplingsAndPairs) {
  const Scene s = imported(
      "r.xml", mjcf("<geom type='plane' size='5 5 1' friction='0.7 0 0'/><body name='a'>" + std::string(kMass) +
                        "<geom size='0.1'/><joint name='j1' axis='0 1 0'/></body>"
                        "<body name='b' pos='1 0 0'>" +
                        kMass +
                        "<geom size='0.1'/><joint name='j2' axis='0 1 0'/></body>"
                        "<body name='c' pos='2 0 0'>" +
                        kMass + "<geom size='0.1'/><joint name='j3' axis='0 1 0'/></body>",
                    "<contact><exclude body1='a' body2='c'/></contact><equality><connect body1='a' body2='b' "
                    "anchor='0.5 0 0'/><weld body1='b' body2='c'/>"
                    "<joint joint1='j1' joint2='j2' polycoef='0 2 0 0 0'/></equality>"));
  EXPECT_EQ(s.joints.size(), 5u);
  EXPECT_EQ(s.joints[3].type, JointType::kSpherical);
  EXPECT_LT((s.joints[3].point_a - Eigen::Vector3d(0.5, 0, 0)).norm(), kExact);
  EXPECT_EQ(s.joints[4].type, JointType::kFixed);
  ASSERT_EQ(s.gears.size(), 1u);
  EXPECT_EQ(s.gears[0].factors, (std::vector<double>{1.0, -2.0}));
  EXPECT_EQ(s.ground.plane->friction, 0.7);
  ASSERT_EQ(s.contacts.size(), 1u);
  EXPECT_TRUE(s.contacts[0].ignore);
}

// What a <frame> and a <replicate> hold is where a welded body in its place has it: MuJoCo places those. The frame has a class whose
// joints and geoms have placements of their own; a box between two points keeps its turn about their line; copy i is turned by i euler
// where the copies before lead, and has what refers to it once each.
TEST_F(Robots, MjcfFramesAndReplicatesPlaceWhatTheyHold) {
  const std::string head =
      "<mujoco><compiler angle='degree' eulerseq='zXy'/><default><geom density='500'/><joint axis='0 1 0'/>"
      "<default class='leg'><joint axis='1 2 0' pos='0 0 0.1'/><geom type='box' size='0.1 0.05 0.02' euler='10 20 "
      "30'/></default></default><worldbody><body name='trunk' pos='0 0 1' euler='5 6 7'><freejoint/>"
      "<geom type='box' size='.3 .2 .1'/>\n";
  const std::string held =
                        "<geom/><geom class='leg' type='capsule' fromto='0 0 0 .1 .2 .3' size='.05'/>"
                        "<geom type='ellipsoid' fromto='0 0 0 .1 .2 .3' size='.05'/>",
                    turned = " pos='.1 0 0' axisangle='1 2 3 50'", far = " pos='0.1 0.2 0.3' euler='20 -30 40'",
                    shin =
                        "<geom type='sphere' size='.1' pos='1 0 0'/><body name='shin' pos='.2 0 0' xyaxes='0 1 0 -1 0 "
                        "0'><joint name='knee'/><geom/></body>";
  const auto foot = [](const std::string& n) {
    return "<body name='foot" + n + "' pos='0 .3 0'><joint name='ankle" + n + "'/><geom type='sphere' size='.05'/>" +
           "<body name='toe" + n + "' pos='.1 0 0'><joint name='tip" + n +
           "' type='slide'/><geom size='.02'/></body></body>";
  };
  const auto ends = [](const std::vector<std::string>& copies) {
    std::string actuators, exclusions;
    for (const std::string& n : copies) {
      actuators += "<motor name='m" + n + "' joint='ankle" + n + "' gear='2'/>";
      exclusions += "<exclude body1='trunk' body2='toe" + n + "'/>";
    }
    return "</body></worldbody><actuator>" + actuators + "<motor name='k' joint='knee'/></actuator><contact>" +
           exclusions + "</contact></mujoco>";
  };
  ImportArguments merged;
  merged.options.merge_fixed = true;
  const Scene framed = imported("f.xml",
                                head + "<frame childclass='leg'" + far + ">" + held + "<frame" + turned + ">" + shin +
                                    "</frame></frame><replicate count='3' sep='_' offset='.5 0 .1' euler='30 0 0'>" +
                                    foot("") + "</replicate>" + ends({""}),
                                merged);
  std::string copies;
  for (int i = 0; i < 3; ++i) {
    const double a = kPi / 6.0;  // of the offset of the third copy
    char place[100];
    std::snprintf(place, sizeof place, "<body pos='%.17g %.17g %.17g' euler='%d 0 0'>",
                  i == 0   ? 0.0
                  : i == 1 ? 0.5
                           : 0.5 + 0.5 * std::cos(a),
                  i < 2 ? 0.0 : 0.5 * std::sin(a), 0.1 * i, 30 * i);
    copies += place + foot("_" + std::to_string(i)) + "</body>";
  }
  const Scene welded = imported("w.xml",
                                head + "<body childclass='leg'" + far + ">" + held + "<body" + turned + ">" + shin +
                                    "</body></body>" + copies + ends({"_0", "_1", "_2"}),
                                merged);
  ASSERT_EQ(framed.bodies.size(), 8u);
  ASSERT_EQ(welded.bodies.size(), 8u);
  for (const BodySpec& expected : welded.bodies) {
    const BodySpec* const body = framed.body(expected.name);
    ASSERT_NE(body, nullptr) << expected.name;
    EXPECT_NEAR(body->mass, expected.mass, kExact * expected.mass) << expected.name;
    EXPECT_LT((body->position - expected.position).norm(), kExact) << expected.name;
    // MuJoCo finds the principal axes of a body of several geoms to six digits.
    EXPECT_LT((inertia_in_D(*body) - inertia_in_D(expected)).norm(), 1e-6 * expected.inertia.norm()) << expected.name;
  }
  ASSERT_EQ(framed.joints.size(), welded.joints.size());
  for (const JointSpec& expected : welded.joints) {
    const JointSpec* const joint = framed.joint(expected.name);
    ASSERT_NE(joint, nullptr) << expected.name;
    EXPECT_EQ(joint->bodies, expected.bodies);
    EXPECT_LT((joint->point_a - expected.point_a).norm() + (joint->axis - expected.axis).norm(), kExact)
        << expected.name;
  }
  EXPECT_EQ(framed.drives.size(), 4u);
  EXPECT_EQ(framed.contacts.size(), welded.contacts.size());
}

// Joints of a body may stand in a frame: point and axis are placed. Copies keep the line of what they copy.
TEST_F(Robots, MjcfJointsStandInFramesAndCopiesKeepTheirLine) {
  const Scene s = imported(
      "r.xml", mjcf("<body name='a' pos='0 0 1'>" + std::string(kMass) +
                    "<frame pos='1 0 0' euler='0 0 0.5'><joint name='j' pos='0 1 0' axis='1 0 0'/></frame></body>\n"
                    "<replicate count='11' offset='1 0 0'>\n<body name='b'>" +
                    kMass + "<joint name='h'/></body></replicate>"));
  EXPECT_LT((s.joint("j")->point_a - Eigen::Vector3d(1.0 - std::sin(0.5), std::cos(0.5), 1.0)).norm(), kExact);
  EXPECT_LT((s.joint("j")->axis - Eigen::Vector3d(std::cos(0.5), std::sin(0.5), 0.0)).norm(), kExact);
  ASSERT_NE(s.body("b00"), nullptr);
  EXPECT_EQ(s.body("b10")->position.x(), 10.0);
  EXPECT_TRUE(test::names(scene_text_, {"r.xml:6 joint"}));
}

TEST_F(Robots, MjcfOfLaterVersionsIsReadWithoutWhatIsNew) {
  imported("r.xml",
           mjcf("<body name='a'>\n<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>\n<joint name='j' "
                "actuatorfrcrange='-1 1'/></body>",
                "<actuator><position joint='j' kp='10' kv='3'/></actuator>\n<sensor>\n<gyro site='x'/></sensor>"));
  EXPECT_TRUE(test::names(
      scene_text_, {"r.xml:6: <joint \"j\"> actuatorfrcrange", "r.xml:9: <gyro> of <sensor>", "kp = 10", "kd = 3"}));
}

TEST_F(Robots, GroundOfASoilIsBelowTheRobot) {
  ImportArguments a;
  a.options.ground = "grc-1-dense";
  a.options.hold = true;
  const Scene s = imported(
      "r.urdf",
      urdf(link("a", kBall + std::string("<collision><geometry><sphere radius='0.2'/></geometry></collision>")) +
           link("b") + joint("continuous", "<limit effort='5' velocity='1'/>")),
      a);
  EXPECT_EQ(s.ground.kind, GroundKind::kParticles);
  EXPECT_TRUE(s.initial.clearance);
  ASSERT_EQ(s.drives.size(), 1u);
  EXPECT_EQ(*s.drives[0].motor.largest_torque, 5.0);
}

// Files have collisions of no size for what touches nothing.
TEST_F(Robots, GeometryWithoutSizeIsLeftOut) {
  const Scene s = imported(
      "r.urdf",
      urdf(link("a", kBall + std::string("\n<collision><geometry><sphere radius='0'/></geometry></collision>"
                                         "<collision><geometry><sphere radius='0.1'/></geometry></collision>")) +
           link("b", kBall + std::string("<collision><geometry><box size='0 0 0'/></geometry></collision>")) +
           joint("fixed", "")));
  ASSERT_EQ(s.boundaries.size(), 1u);
  EXPECT_EQ(s.body("a")->shape->radius, 0.1);
  EXPECT_TRUE(test::names(scene_text_, {"r.urdf:3: a collision geometry of link \"a\": has a size of 0"}));
}

// A drive on a displacement has a largest force; an effort of 0 is no motor, which is said, and not one without limit.
TEST_F(Robots, HeldJointsHaveTheLimitsOfTheFile) {
  ImportArguments a;
  a.options.hold = true;
  const Scene s =
      imported("r.urdf",
               urdf(link("a") + link("b") + link("c") +
                    joint("prismatic", "<limit lower='0' upper='1' effort='50' velocity='6'/>", "a", "b", "slide") +
                    joint("revolute", "\n<limit lower='0' upper='1' effort='0' velocity='6'/>", "a", "c", "turn")),
               a);
  ASSERT_EQ(s.drives.size(), 1u);
  EXPECT_EQ(s.drives[0].name, "slide_hold");
  EXPECT_EQ(*s.drives[0].motor.largest_torque, 50.0);
  EXPECT_TRUE(test::names(scene_text_, {"max_force = 50", "r.urdf:7: <limit> of <joint \"turn\">: effort is 0",
                                        "gives this joint no motor"}));
  for (const std::string& warning : s.warnings) EXPECT_EQ(warning.find("W0171"), std::string::npos) << warning;
}

TEST_F(Robots, PartsOfOneKindAreOneLineOfTheList) {
  std::string parts = link("a");
  for (int k = 0; k < 12; ++k) parts += "<transmission name='t" + std::to_string(k) + "'/>\n";
  Robot robot = read_robot(write("r.urdf", urdf(parts + "<gazebo/>\n")), {});
  const std::vector<std::string> all = not_taken_lines(robot, true, true), some = not_taken_lines(robot, false, false);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(test::names(all[0], {"r.urdf:3: <transmission \"t0\"> of <robot \"test\">: a scene has no such element",
                                   "(and 11 more, in lines 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14)"}));
  EXPECT_TRUE(test::names(some[0], {file("r.urdf:3"), "(and 11 more, in lines 4, 5, 6, 7, 8, 9 ...)"}));
}

TEST_F(Robots, TheNextCommandsCanBeTyped) {
  ImportArguments a;
  a.file = write("r.urdf", urdf(link("a")));
  a.out = file("my robots/r");
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(import_command(a), 0);
  EXPECT_TRUE(test::names(::testing::internal::GetCapturedStdout(), {"check '" + a.out + "'", "run '" + a.out + "'"}));
}

TEST_F(Robots, OfAHostHaveASignalForEachMotor) {
  ImportArguments a;
  a.options.hold = a.options.host = true;
  const Scene s =
      imported("r.xml",
               mjcf("<body name='a'>" + std::string(kMass) + "<joint name='h'/><body name='b' pos='0 0 1'>" + kMass +
                        "<joint name='k'/></body></body>",
                    "<actuator><position name='p' joint='h' kp='100'/></actuator><keyframe><key "
                    "qpos='0 0' ctrl='0.6'/></keyframe>"),
               a);
  ASSERT_EQ(s.signals.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(s.signals[k].kind, SignalKind::kHost);
    EXPECT_EQ(s.drives[k].command->signal, s.signals[k].name);
  }
  EXPECT_TRUE(test::names(scene_text_, {"name = \"p\"\nkind = \"host\"\ninitial = 0.6\n"}));
  EXPECT_EQ(s.accepted.count("W0667"), 1u);  // `check` does not warn of each of them
}

// A broad body one metre above two feet: the bed suits the feet, as `check` proposes it.
TEST_F(Robots, TheBedIsAsLargeAsWhatTouchesIt) {
  ImportArguments a;
  a.options.ground = "grc-1-dense";
  const std::string foot = "<collision><geometry><sphere radius='0.1'/></geometry></collision>";
  const Scene s = imported(
      "r.urdf",
      urdf(link("a", kBall + std::string("<collision><geometry><box size='2 0.2 0.1'/></geometry></collision>")) +
           link("b", kBall + foot) + link("c", kBall + foot) +
           joint("fixed", "<origin xyz='0.2 0 -1'/>", "a", "b", "j1") +
           joint("fixed", "<origin xyz='-0.2 0 -1'/>", "a", "c", "j2")),
      a);
  std::optional<BedProposal> proposal;
  check_by_building(
      s, false, [](const std::string&) {},
      [&](const Scene& placed, const Mechanism& mechanism) {
        require_inside_box(placed, mechanism);
        proposal = proposed_bed(placed, mechanism);
      });
  ASSERT_TRUE(proposal);
  const BoxSpec& box = *s.particles->box;
  EXPECT_NEAR(box.size[0], proposal->size[0], 0.01 * box.size[0]);  // three digits
  EXPECT_NEAR(box.size[1], proposal->size[1], 0.01 * box.size[1]);
  EXPECT_NEAR(box.depth, proposal->depth, 0.01 * box.depth);
  EXPECT_LT(box.size[0], 1.1);  // 0.6 m of the feet, and one width of them on either side
}

// --- Keyframes: what MuJoCo has there.

std::string leg(const std::string& base, const std::string& key) {
  return mjcf("<geom type='plane' size='5 5 1'/><body name='base' pos='0 0 1'>" + base +
                  "<geom type='box' size='0.2 0.1 0.05' mass='5'/>"
                  "<body name='hip' pos='0.2 0.1 0'><joint name='hip' axis='1 0 0'/><geom size='0.04' pos='0 0.08 0' "
                  "mass='0.7'/><body name='thigh' pos='0 0.08 0'><joint name='thigh' axis='0 1 0'/><geom "
                  "type='capsule' fromto='0 0 0 0 0 -0.2' size='0.02' mass='1'/><body name='shank' pos='0 0 -0.2'>"
                  "<joint name='knee' axis='0 1 0'/><geom type='capsule' fromto='0 0 0 0 0 -0.2' size='0.015' "
                  "mass='0.3'/></body></body></body></body>\n",
              "<keyframe><key qpos='" + key + "'/></keyframe>");
}

// A coordinate that is not given would be free: those at zero are given, too.
TEST_F(Robots, JointsAtZeroOfAKeyframeStartThere) {
  const Scene s = imported("r.xml", leg("<freejoint/>", "0 0 1 1 0 0 0  0 0.9 -1.8"));
  std::map<std::string, double> start;
  for (const InitialJointSpec& joint : s.initial.joints) start[joint.name] = joint.angle.value_or(kPi);
  // Their bodies have the plain names.
  EXPECT_EQ(start, (std::map<std::string, double>{{"hip_2", 0.0}, {"thigh_2", 0.9}, {"knee", -1.8}}));
  EXPECT_TRUE(imported("z.xml", leg("<freejoint/>", "0 0 1 1 0 0 0  0 0 0")).initial.joints.empty());
}

// Beside what the world holds a free base would move with its joints: all is drawn where the keyframe has it. So it is above a
// ground, whose place follows from the drawing.
TEST_F(Robots, RobotsThatWouldMoveAreDrawnAtTheirKeyframe) {
  std::string moved = leg("<freejoint/>", "0 0 1 1 0 0 0  0.1 0.9 -1.8 0.5");
  moved.insert(moved.find("</worldbody>"),
               "<body name='door' pos='3 0 1'><joint name='door'/><geom size='0.1' mass='2'/></body>");
  const Scene s = imported("r.xml", moved);
  EXPECT_TRUE(s.initial.joints.empty());
  const Eigen::Matrix3d R = rx(0.1) * ry(0.9);
  EXPECT_LT((axes(*s.body("shank")) - R * ry(-1.8)).norm(), kExact);
  EXPECT_LT((axes(*s.body("door")) - rz(0.5)).norm(), kExact);
  EXPECT_EQ(s.body("base")->position, Eigen::Vector3d(0, 0, 1));
  EXPECT_TRUE(test::names(scene_text_, {"Coordinates are zero as drawn (the first keyframe)"}));
  const Scene turned = imported("t.xml", leg("", "0 4 0"));  // by more than half a turn
  EXPECT_TRUE(turned.initial.joints.empty());
  EXPECT_LT((axes(*turned.body("thigh")) - ry(4.0)).norm(), kExact);
  ImportArguments a;
  a.options.ground = "plane";
  const Scene on_ground = imported("g.xml", leg("<freejoint/>", "0 0 1 1 0 0 0  0 0.9 -1.8"), a);
  EXPECT_TRUE(on_ground.initial.joints.empty());
  EXPECT_TRUE(on_ground.initial.clearance);
  EXPECT_LT((axes(*on_ground.body("shank")) - ry(-0.9)).norm(), kExact);
}

// v_B = v + w x (p_B - p) of the frame, whose linear velocity is along the world and angular along the body; the hip turns by 2
// rad/s about x of the base.
TEST_F(Robots, VelocitiesOfAKeyframeAreThoseOfBodies) {
  std::string robot = leg("<freejoint/><geom pos='0.3 0 0' size='0.01' mass='5'/>", "0 0 1 0.6 0 0 0.8  0 0 0");
  robot.replace(robot.find("'/></keyframe>"), 1, "' qvel='1 2 3 0.1 0.2 0.3 2 0 0'");
  const Scene s = imported("r.xml", robot);
  std::map<std::string, const BodyVelocitySpec*> moving;
  for (const BodyVelocitySpec& one : s.initial.bodies) moving[one.body] = &one;
  ASSERT_EQ(moving.size(), 4u);
  const Eigen::Matrix3d R = Eigen::Quaterniond(0.6, 0, 0, 0.8).toRotationMatrix();
  const Eigen::Vector3d v(1, 2, 3), w = R * Eigen::Vector3d(0.1, 0.2, 0.3), w_hip = w + R * Eigen::Vector3d(2, 0, 0);
  const Eigen::Vector3d hip = R * Eigen::Vector3d(0.2, 0.1, 0);
  EXPECT_LT((*moving["base"]->velocity - (v + w.cross(R * Eigen::Vector3d(0.15, 0, 0)))).norm(), kExact);
  EXPECT_LT((*moving["base"]->angular_velocity - w).norm(), kExact);
  EXPECT_LT((*moving["hip"]->angular_velocity - w_hip).norm(), kExact);
  EXPECT_LT((*moving["hip"]->velocity - (v + w.cross(hip) + w_hip.cross(R * Eigen::Vector3d(0, 0.08, 0)))).norm(),
            kExact);
  ImportArguments a;
  a.options.fix_base = true;
  for (const BodyVelocitySpec& one : imported("f.xml", robot, a).initial.bodies)
    if (one.body == "base") {
      EXPECT_EQ(one.velocity->norm(), 0.0);
    }
}

// Between the joints of one body: about x at the origin, then along z as it then is, then about y next to the origin.
TEST_F(Robots, VelocitiesBetweenTheJointsOfABodyFitTheJoints) {
  const Scene s = imported("r.xml", mjcf("<body name='a'>" + std::string(kMass) +
                                             "<joint name='p' axis='1 0 0'/><joint name='z' type='slide' axis='0 0 "
                                             "1'/><joint name='q' axis='0 1 0' pos='0.1 0 0'/></body>",
                                         "<keyframe><key qpos='0.5 2 0.3' qvel='3 4 5'/></keyframe>"));
  std::map<std::string, const BodyVelocitySpec*> moving;
  for (const BodyVelocitySpec& one : s.initial.bodies) moving[one.body] = &one;
  ASSERT_EQ(moving.size(), 3u);
  const Eigen::Vector3d z = rx(0.5) * Eigen::Vector3d::UnitZ(), w(3, 0, 0), p = s.body("a")->position;
  EXPECT_LT((*moving["a_after_p"]->angular_velocity - w).norm(), kExact);
  EXPECT_LT((*moving["a_after_p"]->velocity - w.cross(p)).norm(), kExact);
  EXPECT_LT((*moving["a_after_z"]->angular_velocity - w).norm(), kExact);
  EXPECT_LT((*moving["a_after_z"]->velocity - w.cross(p) - 4.0 * z).norm(), kExact);
  EXPECT_LT((*moving["a"]->angular_velocity - w - rx(0.5) * Eigen::Vector3d(0, 5, 0)).norm(), kExact);
}

// What a controller of MuJoCo does not change remains: gear 3 times the control, which its range limits.
TEST_F(Robots, TheControlOfATorqueMotorIsATorque) {
  std::string robot = leg("<freejoint/>", "0 0 1 1 0 0 0  0 0.9 -1.8");
  robot.replace(robot.find("'/></keyframe>"), 1, "' ctrl='0.5 9'");
  robot.insert(robot.find("<keyframe>"),
               "<actuator><motor name='h' joint='hip' gear='3'/><motor name='k' joint='knee' gear='3' ctrlrange='-2 "
               "2' ctrllimited='true'/></actuator>");
  const Scene s = imported("r.xml", robot);
  ASSERT_EQ(s.drives.size(), 2u);
  EXPECT_EQ(s.drives[0].command->polynomial, std::vector<double>{1.5});
  EXPECT_EQ(s.drives[1].command->polynomial, std::vector<double>{6.0});
  EXPECT_EQ(*s.drives[1].motor.largest_torque, 6.0);
  EXPECT_TRUE(test::names(scene_text_, {"3 times the control, which remains as in the keyframe"}));
}

// A loop that the keyframe closes to its digits is drawn there: on the way of single coordinates it would be open.
TEST_F(Robots, LoopsAreDrawnAtTheirKeyframe) {
  const std::string rod = std::string(kMass) + "<joint name='";
  const std::string robot =
      mjcf("<body name='a'>" + rod + "j1' axis='0 1 0'/><body name='b' pos='0 0 1'>" + rod +
               "j2' axis='0 1 0'/></body></body><body name='c' pos='1 0 0'>" + rod + "j3' axis='0 1 0'/></body>",
           "<equality><connect body1='b' body2='c' anchor='1 0 0'/></equality><keyframe><key qpos='0.3 -0.3 0.3'/>"
           "</keyframe>");
  const Scene s = imported("r.xml", robot);
  EXPECT_TRUE(s.initial.joints.empty());
  EXPECT_EQ(s.joints.size(), 4u);
  EXPECT_LT((axes(*s.body("a")) - ry(0.3)).norm(), kExact);
  std::string open = robot;
  open.replace(open.find("0.3 -0.3 0.3"), 12, "0.3 -0.2 0.3");
  const Scene t = imported("o.xml", open);
  EXPECT_TRUE(t.initial.joints.empty());
  EXPECT_EQ(t.joints.size(), 4u);
  EXPECT_TRUE(axes(*t.body("a")).isIdentity());
  EXPECT_TRUE(test::names(scene_text_, {"loops or couplings do not hold there"}));
}

// The first row in the file has the largest y; heights count from the lowest, over their range.
TEST_F(Robots, AHeightFieldIsTheGround) {
  std::string robot = mjcf(
      "<geom type='hfield' hfield='hills' pos='1 2 0.5' friction='0.6 0 0'/><body name='a' pos='0 "
      "0 5'><freejoint/><geom size='0.1'/></body>");
  robot.insert(robot.find("<worldbody>"),
               "<asset><hfield name='hills' nrow='2' ncol='3' size='2 1 0.4 0.1' elevation='0 2 4  1 1 1'/></asset>\n");
  const Scene s = imported("r.xml", robot);
  ASSERT_TRUE(s.ground.terrain && s.ground.terrain->map);
  EXPECT_EQ(s.ground.plane->friction, 0.6);
  Terrain terrain = *terrain_of(*s.ground.terrain);
  const double low = 0.5, one = 0.4 / 4.0;  // z of the lowest, and of one of the file
  EXPECT_NEAR(terrain.at(-1.0, 3.0).h, low, 1e-9);
  EXPECT_NEAR(terrain.at(1.0, 3.0).h, low + 2.0 * one, 1e-9);
  EXPECT_NEAR(terrain.at(3.0, 3.0).h, low + 4.0 * one, 1e-9);
  EXPECT_NEAR(terrain.at(3.0, 1.0).h, low + one, 1e-9);
  robot.replace(robot.find("elevation"), 24, "file='none.png'");
  EXPECT_FALSE(imported("n.xml", robot).ground.terrain);
  EXPECT_TRUE(test::names(scene_text_, {"n.xml:3: <hfield \"hills\">: there is no file \"none.png\""}));
}

// --- Of many links.

RobotLink random_link() {
  RobotLink link;
  link.mass = 1.0 + std::abs(Eigen::Vector3d::Random()[0]);
  link.centre.setRandom();
  link.inertia = kInertia;
  link.X_DL = {3.0 * Eigen::Vector3d::Random(), rz(link.centre[0]) * rx(link.centre[1])};
  return link;
}

// Tolerance: the sums are about the origin, some sizes away.
TEST(MovedInertias, AreTheSumsOverAllThatAJointCarries) {
  constexpr int kLinks = 40;
  std::srand(1);
  Robot robot;
  std::vector<int> above(kLinks, -1);
  for (int k = 0; k < kLinks; ++k) {
    robot.links.push_back(random_link());
    RobotJoint joint;
    above[k] = joint.parent = k == 0 ? -1 : std::rand() % k;
    joint.child = k;
    joint.point.setRandom();
    joint.axis = Eigen::Vector3d::Random().normalized();
    robot.joints.push_back(joint);
  }
  RobotJoint loop;
  loop.loop = true;
  loop.parent = 1;
  loop.child = kLinks - 1;
  robot.joints.push_back(loop);
  const MovedInertias moved(robot);
  for (int j = 0; j < kLinks; ++j) {
    const RobotJoint& joint = robot.joints[j];
    double mass = 0.0, inertia = 0.0;
    for (int k = 0; k < kLinks; ++k) {
      int at = k;
      while (at >= 0 && at != j) at = above[at];
      if (at != j) continue;
      const RobotLink& link = robot.links[k];
      const Eigen::Vector3d a = link.X_DL.R.transpose() * joint.axis;
      mass += link.mass;
      inertia +=
          a.dot(link.inertia * a) + link.mass * (link.X_DL * link.centre - joint.point).cross(joint.axis).squaredNorm();
    }
    EXPECT_NEAR(moved.beyond(joint, true), mass, kExact * mass);
    EXPECT_NEAR(moved.beyond(joint, false), inertia, 1e-11 * inertia);
  }
}

TEST(MovedInertias, InACircleAreThoseOfAllItsLinks) {
  Robot robot;
  for (int k = 0; k < 3; ++k) {
    robot.links.push_back(random_link());
    RobotJoint joint;
    joint.parent = k;
    joint.child = (k + 1) % 3;
    robot.joints.push_back(joint);
  }
  const double all = robot.links[0].mass + robot.links[1].mass + robot.links[2].mass;
  for (const RobotJoint& joint : robot.joints) EXPECT_NEAR(MovedInertias(robot).beyond(joint, true), all, kExact * all);
}

// A chain four times as long takes four times as long, sixteen times where each link looks at all others. The least of three.
TEST_F(Robots, OfManyLinksTakeTimeInProportion) {
  for (const char* type : {"continuous", "fixed"}) {
    const auto seconds = [&](int links) {
      std::string inside = link("l0");
      for (int k = 1; k < links; ++k)
        inside += link("l" + std::to_string(k)) +
                  joint(type, "", "l" + std::to_string(k - 1), "l" + std::to_string(k), "j" + std::to_string(k));
      const std::string path = write("chain.urdf", urdf(inside));
      ImportOptions options;
      options.merge_fixed = options.hold = true;
      double least = 1e9;
      for (int repeat = 0; repeat < 3; ++repeat) {
        const std::clock_t start = std::clock();
        Robot robot = read_robot(path, options);
        tidy_robot(robot, options);
        EXPECT_EQ(robot.links.size(), type[0] == 'f' ? 1u : static_cast<std::size_t>(links));
        write_robot_scene(robot, options);
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      }
      return least;
    };
    const double shorter = seconds(1500), longer = seconds(6000);
    EXPECT_LT(longer, 9.0 * shorter) << type;
  }
}

// A leaf without mass is held, the link that carries it alone then, too: all become one.
TEST_F(Robots, LeavesWithoutMassJoinOneAfterTheOther) {
  std::string inside = link("a");
  for (int k = 0; k < 5; ++k)
    inside += link("m" + std::to_string(k), "") + joint("continuous", "", k == 0 ? "a" : "m" + std::to_string(k - 1),
                                                        "m" + std::to_string(k), "j" + std::to_string(k));
  const Scene s = imported("leaves.urdf", urdf(inside));
  ASSERT_EQ(s.bodies.size(), 1u);
  EXPECT_EQ(s.bodies[0].mass, 1.0);
  EXPECT_TRUE(s.joints.empty());
}

}  // namespace
}  // namespace footfall
