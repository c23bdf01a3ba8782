// Models of SDF with one feature each, as robots_test.cpp. Poses are x y z roll pitch yaw: R = Rz(yaw) Ry(pitch) Rx(roll).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/import/import_command.h"
#include "mbd_solver/scene/scene_reader.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

constexpr double kExact = 1e-12;

Eigen::Matrix3d rpy(double r, double p, double y) {
  return (Eigen::AngleAxisd(y, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(p, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(r, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

class Sdf : public ::testing::Test, public TemporaryFolder {
 protected:
#ifndef FOOTFALL_SDFORMAT
  void SetUp() override { GTEST_SKIP() << "built without the library sdformat"; }
#endif
  Scene imported(const std::string& inside, const std::string& version = "1.9") {
    ImportArguments a;
    a.file = write("m.sdf", "<sdf version='" + version + "'>\n<model name='m'>\n" + inside + "</model>\n</sdf>\n");
    a.out = file("scene" + std::to_string(++count_));
    a.quiet = true;
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(import_command(a), 0);
    ::testing::internal::GetCapturedStdout();
    scene_text_ = text("scene" + std::to_string(count_) + "/scene.toml");
    return read_scene(a.out);
  }
  std::string refused(const std::string& content) {
    ImportArguments a;
    a.file = write("bad.sdf", content);
    a.out = file("bad");
    const std::string message = test::error_of([&] { import_command(a); });
    EXPECT_FALSE(std::filesystem::exists(a.out));
    return message;
  }
  static Eigen::Matrix3d axes(const BodySpec& body) { return body.orientation.toRotationMatrix(); }
  std::string scene_text_;
  int placed_ = 0;

 private:
  int count_ = 0;
};

const char* const kBall =
    "<inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>";
std::string link(const std::string& name, const std::string& pose = "0 0 0 0 0 0", const std::string& inside = kBall) {
  return "<link name='" + name + "'><pose>" + pose + "</pose>" + inside + "</link>\n";
}
std::string joint(const std::string& type, const std::string& inside, const std::string& name = "j",
                  const std::string& parent = "a", const std::string& child = "b") {
  return "<joint name='" + name + "' type='" + type + "'><parent>" + parent + "</parent><child>" + child + "</child>" +
         inside + "</joint>\n";
}

TEST_F(Sdf, TurnedInertialFrameAndProducts) {
  const Scene s = imported(
      "<pose>0 0 1 0 0 0.5</pose>" +
      link("a", "1 2 3 0.3 0.2 -0.7",
           "<inertial><pose>0.1 0.2 0.3 0.4 -0.5 0.6</pose><mass>2</mass><inertia><ixx>0.03</ixx><iyy>0.04</iyy>"
           "<izz>0.05</izz><ixy>0.002</ixy><ixz>-0.003</ixz><iyz>0.004</iyz></inertia></inertial>"));
  Eigen::Matrix3d I;
  I << 0.03, 0.002, -0.003, 0.002, 0.04, 0.004, -0.003, 0.004, 0.05;
  const Eigen::Matrix3d R_M = rpy(0, 0, 0.5), R = R_M * rpy(0.3, 0.2, -0.7), R_I = R * rpy(0.4, -0.5, 0.6);
  const BodySpec& a = *s.body("a");
  EXPECT_LT((axes(a) - R).norm(), kExact);
  EXPECT_LT(
      (a.position - (Eigen::Vector3d(0, 0, 1) + R_M * Eigen::Vector3d(1, 2, 3) + R * Eigen::Vector3d(0.1, 0.2, 0.3)))
          .norm(),
      kExact);
  EXPECT_LT((axes(a) * a.inertia * axes(a).transpose() - R_I * I * R_I.transpose()).norm(), kExact);
}

TEST_F(Sdf, PosesInDegreesAsQuaternionsAndInFrames) {
  const Scene s = imported(
      "<frame name='f'><pose>1 0 0 0 0 1.5707963267948966</pose></frame>"
      "<link name='a'><pose degrees='true'>0 0 0 10 20 30</pose>" +
      std::string(kBall) +
      "</link>"
      "<link name='b'><pose relative_to='f'>1 0 0 0 0 0</pose>" +
      kBall +
      "</link>"
      "<link name='c'><pose rotation_format='quat_xyzw'>0 0 0 0 0 0.6 0.8</pose>" +
      kBall + "</link>");
  EXPECT_LT((axes(*s.body("a")) - rpy(kPi / 18, kPi / 9, kPi / 6)).norm(), kExact);
  EXPECT_LT((s.body("b")->position - Eigen::Vector3d(1, 1, 0)).norm(), kExact);
  EXPECT_LT((axes(*s.body("c")) - Eigen::Quaterniond(0.8, 0, 0, 0.6).toRotationMatrix()).norm(), kExact);
}

TEST_F(Sdf, KindsOfJoints) {
  const std::string axis =
      "<axis><xyz>0 1 "
      "0</xyz><limit><lower>-1</lower><upper>2</upper><effort>7</effort></limit><dynamics><damping>0.3</damping>"
      "<friction>0.2</friction><spring_stiffness>4</spring_stiffness><spring_reference>0.5</spring_reference></"
      "dynamics></axis>";
  const std::string free = "<axis><xyz>0 1 0</xyz></axis>", free2 = "<axis2><xyz>1 0 0</xyz></axis2>";
  std::string model;
  for (const char* name : {"a", "b", "c", "d", "e", "f", "g", "h"}) model += link(name);
  model += joint("revolute", axis, "j1") + joint("prismatic", axis, "j2", "a", "c") +
           joint("ball", "", "j3", "a", "d") + joint("universal", free + free2, "j4", "a", "e") +
           joint("fixed", "", "j5", "world", "a") +
           joint("screw", free + "<thread_pitch>-50</thread_pitch>", "j6", "a", "f") +
           joint("revolute2", axis + free2, "j7", "a", "g") + joint("continuous", free, "j8", "a", "h");
  const Scene s = imported(model);
  const JointSpec& j1 = *s.joint("j1");
  EXPECT_EQ(j1.angle->stops->smallest_stroke.value(), -1.0);
  EXPECT_EQ(j1.angle->friction->viscous, 0.3);
  EXPECT_EQ(j1.angle->spring->free_stroke, 0.5);
  EXPECT_EQ(s.joint("j2")->type, JointType::kPrismatic);
  EXPECT_EQ(s.joint("j3")->type, JointType::kSpherical);
  EXPECT_EQ(s.joint("j4")->type, JointType::kUniversal);
  EXPECT_EQ(s.joint("j5")->bodies[0], "ground");
  EXPECT_EQ(s.joint("j6")->type, JointType::kCylindrical);
  ASSERT_EQ(s.gears.size(), 1u);
  EXPECT_EQ(s.gears[0].factors, (std::vector<double>{1.0, -50.0}));  // turns by 50 rad per m
  EXPECT_EQ(s.joint("j7")->bodies[1], s.joint("j7_axis2")->bodies[0]);
  EXPECT_FALSE(s.joint("j8")->angle);
}

TEST_F(Sdf, LoopsAreClosedByTheirJoint) {
  const std::string axis = "<axis><xyz>0 1 0</xyz></axis>";
  const Scene s =
      imported(link("a") + link("b", "1 0 0 0 0 0") + link("c", "1 0 1 0 0 0") + joint("revolute", axis, "j1") +
               joint("revolute", axis, "j2", "b", "c") + joint("ball", "<pose>0 0 0.5 0 0 0</pose>", "j3", "a", "c"));
  ASSERT_EQ(s.joints.size(), 3u);
  EXPECT_LT((s.joint("j3")->point_a - Eigen::Vector3d(1, 0, 1.5)).norm(), kExact);
}

TEST_F(Sdf, OldVersionsHaveAxesInTheFrameOfTheModel) {
  const std::string axis = "<axis><xyz>0 1 0</xyz></axis>";
  const std::string model = link("a") + link("b", "0 0 0 0 0 0.5");
  // 1.4: always the model's frame. 1.5: the joint's, unless use_parent_model_frame.
  EXPECT_LT((imported(model + joint("revolute", axis), "1.4").joint("j")->axis - Eigen::Vector3d(0, 1, 0)).norm(),
            kExact);
  EXPECT_LT(
      (imported(model + joint("revolute", axis), "1.5").joint("j")->axis - rpy(0, 0, 0.5) * Eigen::Vector3d(0, 1, 0))
          .norm(),
      kExact);
}

TEST_F(Sdf, GearboxIsAGearOfTwoJoints) {
  const std::string axis = "<axis><xyz>0 1 0</xyz></axis>";
  const Scene s = imported(
      link("a") + link("b") + link("c") + joint("revolute", axis, "j1") + joint("revolute", axis, "j2", "a", "c") +
      joint("gearbox",
            axis + "<axis2><xyz>0 1 "
                   "0</xyz></axis2><gearbox_ratio>3</gearbox_ratio><gearbox_reference_body>a</gearbox_reference_body>",
            "j3", "b", "c"));
  ASSERT_EQ(s.gears.size(), 1u);
  EXPECT_EQ(s.gears[0].joints, (std::vector<std::string>{"j1", "j2"}));
  EXPECT_EQ(s.gears[0].factors, (std::vector<double>{3.0, 1.0}));  // the child turns by -3 times the parent
}

TEST_F(Sdf, WhatASceneCannotSayIsListedWithItsLine) {
  imported(link("a", "0 0 0 0 0 0", std::string(kBall) + "\n<sensor name='s' type='imu'/>") +
           "<plugin name='p' filename='x'/>\n");
  EXPECT_TRUE(test::names(scene_text_, {"m.sdf:4: <sensor \"s\">", "m.sdf:5: <plugin \"p\">"}));
}

TEST_F(Sdf, BadFiles) {
  EXPECT_TRUE(test::names(refused("<sdf version='1.9'>\n</sdf>"), {"bad.sdf:1", "E0711"}));
  EXPECT_TRUE(test::names(refused("<sdf version='7.9'><model name='m'/></sdf>"), {"bad.sdf:1", "E0707"}));
  EXPECT_TRUE(
      test::names(refused("<sdf version='1.9'><model name='m'>\n<link/></model></sdf>"), {"bad.sdf:2", "E0707"}));
  EXPECT_TRUE(test::names(refused("<sdf version='1.9'><model name='m'><link name='a'/>\n<joint name='j' "
                                  "type='fixed'><parent>a</parent><child>x</child></joint></model></sdf>"),
                          {"bad.sdf:2", "E0707"}));
  EXPECT_TRUE(test::names(
      refused("<sdf version='1.9'><model name='m'>\n<link name='a'>\n<pose>0 0 x 0 0 0</pose></link></model></sdf>"),
      {"bad.sdf:3", "E0707"}));
}

// Old exports write -1 for a friction without limit, which sdformat refuses.
TEST_F(Sdf, FrictionBelowZeroIsListed) {
  imported(
      link("a", "0 0 0 0 0 0",
           std::string(kBall) +
               "<collision name='c'><geometry><sphere><radius>0.1</radius></sphere></geometry><surface><friction><ode>"
               "\n<mu>-1.0</mu>\n<mu2>-1</mu2></ode></friction></surface></collision>"));
  EXPECT_TRUE(test::names(scene_text_, {"m.sdf:4: <mu> below zero"}));
}

// Models within models may have links of one name: each keeps its own line, friction and place.
TEST_F(Sdf, NestedModelsKeepTheirOwnLinks) {
  const auto slippery = [](const std::string& mu) {
    return std::string(kBall) +
           "<collision "
           "name='c'><geometry><sphere><radius>0.1</radius></sphere></geometry><surface><friction><ode><mu>" +
           mu + "</mu></ode></friction></surface></collision>";
  };
  ImportArguments a;
  a.file = write("m.sdf",
                 "<!-- first a comment -->\n<?xml version='1.0'?>\n<sdf version='1.8'><world name='w'>\n"
                 "<frame name='deck'><pose>1 2 3 0 0 0.5</pose></frame>\n"
                 "<model name='m' placement_frame='base'><pose relative_to='deck'>0.3 0 0 0 0 0</pose>\n" +
                     link("base", "0.5 0 0.2 0 0.1 0", slippery("0.3")) +
                     "<model name='arm'><pose relative_to='base'>0 0 1 0 0 0</pose>\n" +
                     link("base", "0 0 0.1 0 0 0", slippery("0.9")) + "</model>\n" +
                     joint("revolute", "<axis><xyz expressed_in='base'>0 1 0</xyz></axis>", "j", "base", "arm::base") +
                     "</model></world></sdf>\n");
  a.out = file("nested");
  a.quiet = true;
  a.options.ground = "plane";
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(import_command(a), 0);
  ::testing::internal::GetCapturedStdout();
  const std::string said = text("nested/scene.toml");
  EXPECT_TRUE(test::names(said, {"m.sdf:6 link \"base\"", "m.sdf:8 link \"arm::base\"", "friction = 0.9"})) << said;
  const Scene s = read_scene(a.out);
  // The frame "base" of m is 0.3 m along x of the deck, and its axes are parallel to the deck's.
  const Eigen::Vector3d base(1.0 + 0.3 * std::cos(0.5), 2.0 + 0.3 * std::sin(0.5), 3.0);
  EXPECT_LT((s.body("base")->position - base).norm(), kExact);
  EXPECT_LT((axes(*s.body("base")) - rpy(0, 0, 0.5)).norm(), kExact);
  EXPECT_LT((s.body("arm__base")->position - base - Eigen::Vector3d(0, 0, 1.1)).norm(), kExact);
  EXPECT_LT((s.joint("j")->axis - Eigen::Vector3d(-std::sin(0.5), std::cos(0.5), 0)).norm(), kExact);
}

// A model in a folder of models includes another one of them, not itself; colours that sdformat would refuse are not judged.
TEST_F(Sdf, IncludesTheModelThatItNames) {
  const std::string config = "<model><name>x</name><sdf>model.sdf</sdf></model>";
  for (const char* name : {"cart", "ball"}) {
    std::filesystem::create_directories(file(std::string("models/") + name));
    write(std::string("models/") + name + "/model.config", config);
  }
  write("models/ball/model.sdf",
        "<sdf version='1.5'><model name='ball'>" + link("b", "0 0 0 0 0 0", kBall) + "</model></sdf>");
  ImportArguments a;
  a.file = write("models/cart/model.sdf",
                 "<sdf version='1.5'><model name='cart'>\n" +
                     link("a", "0 0 0 0 0 0",
                          std::string(kBall) +
                              "<visual name='v'><geometry><sphere><radius>1</radius></sphere></geometry><material>"
                              "<script><name>Red</name></script></material></visual>") +
                     "<include><uri>model://ball</uri><pose>0 0 2 0 0 0</pose></include>\n"
                     "<include><uri>model://none</uri></include>\n" +
                     joint("revolute", "<axis><xyz>0 0 1</xyz></axis>", "j", "a", "ball::b") + "</model></sdf>\n");
  a.out = file("included");
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(import_command(a), 0);
  ::testing::internal::GetCapturedStdout();
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_TRUE(test::names(said, {"model.sdf:4: <include> of \"model://none\""})) << said;
  EXPECT_EQ(said.find("Error Code"), std::string::npos) << said;
  const Scene s = read_scene(a.out);
  ASSERT_EQ(s.bodies.size(), 2u);
  EXPECT_EQ(s.joints.size(), 1u);
  EXPECT_EQ(s.bodies[0].position.z() + s.bodies[1].position.z(), 2.0);
}

// 2^12 models, each of which has two of the next one. Before, sdformat read them all.
TEST_F(Sdf, ModelsThatIncludeEachOtherTwiceAreRefused) {
  const std::string config =
      "<?xml version='1.0'?><model><name>m</name><sdf version='1.9'>model.sdf</sdf><description/></model>\n";
  const auto including = [](const std::string& name) {
    const auto include = [&](const char* as) {
      return "<include><uri>model://" + name + "</uri><name>" + as + "</name></include>";
    };
    return "<sdf version='1.9'><model name='m'>" + link("a") + include("x") + include("y") + "</model></sdf>";
  };
  for (int k = 0; k < 12; ++k) {
    const std::string folder = "m" + std::to_string(k) + "/";
    write(folder + "model.config", config);
    write(folder + "model.sdf", k == 11 ? "<sdf version='1.9'><model name='m'>" + link("a") + "</model></sdf>"
                                        : including("m" + std::to_string(k + 1)));
  }
  EXPECT_TRUE(test::names(refused(including("m0")), {"bad.sdf", "1000 included files", "E0437"}));
}

TEST_F(Sdf, WithoutAMovingPartOrAnAxisIsRefused) {
  const auto model = [](const std::string& inside) {
    return "<sdf version='1.9'>\n<model name='m'>\n" + inside + "</model></sdf>\n";
  };
  EXPECT_TRUE(test::names(refused(model("<static>true</static>" + link("a"))), {"bad.sdf:1", "E0712"}));
  for (const char* type : {"universal", "revolute2", "screw", "gearbox", "prismatic"})
    EXPECT_TRUE(test::names(refused(model(link("a") + link("b") + joint(type, ""))), {"bad.sdf:5"})) << type;
}

// The pose of a model places its placement frame: here of a link, a frame that is turned, and a link of a nested model.
TEST_F(Sdf, TheModelStandsOnItsPlacementFrame) {
  const auto placed = [&](const std::string& frame, const std::string& inside) {
    ImportArguments a;
    a.file = write("p.sdf", "<sdf version='1.8'><model name='m' placement_frame='" + frame +
                                "'><pose>0 0 5 0 0 0.3</pose>" + inside + "</model></sdf>");
    a.out = file("placed" + std::to_string(++placed_));
    a.quiet = true;
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(import_command(a), 0);
    ::testing::internal::GetCapturedStdout();
    return read_scene(a.out);
  };
  const std::string ab = link("a") + link("b", "0 0 1 0 0 0.3") + joint("fixed", "");
  const Scene s = placed("b", ab);
  EXPECT_LT((s.body("b")->position - Eigen::Vector3d(0, 0, 5)).norm(), kExact);
  EXPECT_LT((s.body("a")->position - Eigen::Vector3d(0, 0, 4)).norm(), kExact);
  EXPECT_LT((axes(*s.body("b")) - rpy(0, 0, 0.3)).norm(), kExact);
  EXPECT_LT((axes(*s.body("a")) - rpy(0, 0, 0)).norm(), kExact);
  const Scene t = placed("f", ab + "<frame name='f' attached_to='b'><pose>1 0 0 0 0 0</pose></frame>");
  EXPECT_LT((t.body("b")->position - Eigen::Vector3d(-std::cos(0.3), -std::sin(0.3), 5)).norm(), kExact);
  const Scene u =
      placed("inner::c", link("a") + "<model name='inner'><pose>0 1 0 0 0 0</pose>" + link("c", "0 0 2 0 0 0") +
                             "</model>" + joint("fixed", "", "j", "a", "inner::c"));
  EXPECT_LT((u.body("inner__c")->position - Eigen::Vector3d(0, 0, 5)).norm(), kExact);
}

// SDF 1.11: mass, centre and inertia follow from the collisions and their densities [kg/m3].
TEST_F(Sdf, InertiaOfCollisions) {
  const Scene s = imported(
      "<link name='a'><inertial auto='true'><density>500</density></inertial>"
      "<collision name='c'><pose>0 0 1 0 0 0</pose><geometry><box><size>1 2 3</size></box></geometry></collision>"
      "<collision name='d'><density>6000</density><geometry><ellipsoid><radii>0.1 0.2 0.3</radii></ellipsoid>"
      "</geometry></collision></link>",
      "1.11");
  const double box = 500.0 * 6.0, ball = 6000.0 * 4.0 / 3.0 * kPi * 0.1 * 0.2 * 0.3, mass = box + ball, z = box / mass;
  const BodySpec& a = *s.body("a");
  EXPECT_NEAR(a.mass, mass, kExact * mass);
  EXPECT_LT((a.position - Eigen::Vector3d(0, 0, z)).norm(), kExact);
  const double apart = box * (1.0 - z) * (1.0 - z) + ball * z * z;
  EXPECT_NEAR(a.inertia(0, 0), box * (4.0 + 9.0) / 12.0 + ball * (0.04 + 0.09) / 5.0 + apart, 1e-9 * box);
  EXPECT_NEAR(a.inertia(2, 2), box * (1.0 + 4.0) / 12.0 + ball * (0.01 + 0.04) / 5.0, 1e-9 * box);
}

// sdformat takes 10 ms for a link; a reader of two thousand is not one that a damaged file holds up.
TEST_F(Sdf, TwoThousandLinksAreRead) {
  constexpr int kLinks = 2000;
  std::string chain = link("b0");
  for (int i = 1; i < kLinks; ++i) {
    const std::string name = std::to_string(i), before = std::to_string(i - 1);
    chain += link("b" + name, std::to_string(0.1 * i) + " 0 0 0 0 0") + "<joint name='j" + name +
             "' type='revolute'><parent>b" + before + "</parent><child>b" + name +
             "</child><axis><xyz>0 1 0</xyz></axis></joint>\n";
  }
  ImportArguments a;
  a.file = write("chain.sdf", "<sdf version='1.9'><model name='m'>" + chain + "</model></sdf>");
  a.out = file("chain");
  a.quiet = true;
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(import_command(a), 0);
  ::testing::internal::GetCapturedStdout();
  EXPECT_TRUE(std::filesystem::exists(a.out));
}

}  // namespace
}  // namespace footfall
