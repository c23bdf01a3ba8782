// Bad files end with file, line and a code, and nothing is written.
#include <gtest/gtest.h>

#include <filesystem>

#include "mbd_solver/import/import_command.h"
#include "mbd_solver/import/robot.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class BadRobots : public ::testing::Test, public TemporaryFolder {
 protected:
  // The message about a file of this name and text.
  std::string message(const std::string& name, const std::string& content, const ImportOptions& options = {}) {
    ImportArguments a;
    a.file = write(name, content);
    a.out = file("out");
    a.options = options;
    const std::string text = test::error_of([&] { import_command(a); });
    EXPECT_FALSE(std::filesystem::exists(a.out));
    return text;
  }
};

const char* const kMassOfOne =
    "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";

TEST_F(BadRobots, NoRobot) {
  EXPECT_TRUE(test::names(message("r.urdf", "<house/>\n"), {"r.urdf:1", "E0700"}));
  EXPECT_TRUE(test::names(message("r.urdf", ""), {"r.urdf:1", "E0701"}));
  EXPECT_TRUE(test::names(message("r.urdf", "<robot name='a'>\n<link name='b'>\n</robot>"), {"r.urdf:3", "E0701"}));
  EXPECT_TRUE(test::names(message("r.urdf", std::string("<robot>\n\0</robot>", 18)), {"r.urdf:2", "E0701"}));
  EXPECT_TRUE(test::names(message("r.xacro", "<robot xmlns:xacro='x'>\n<xacro:macro name='m'/></robot>"),
                          {"r.xacro:2", "E0702"}));
  std::string deep = "<robot>";
  for (int k = 0; k < 100000; ++k) deep += "<a>";
  for (int k = 0; k < 100000; ++k) deep += "</a>";
  EXPECT_TRUE(test::names(message("r.urdf", deep + "</robot>"), {"r.urdf", "200 levels", "E0437"}));
  std::string many = "<robot>";
  for (int k = 0; k < 2000000; ++k) many += "<a/>";
  EXPECT_TRUE(test::names(message("r.urdf", many + "</robot>"), {"r.urdf", "2000000 elements", "E0437"}));
}

// The message says what helps.
TEST_F(BadRobots, SdfInABuildWithoutItsLibrary) {
#ifdef FOOTFALL_SDFORMAT
  GTEST_SKIP() << "built with the library sdformat";
#endif
  EXPECT_TRUE(test::names(message("r.sdf", "<sdf version='1.9'><model name='m'/></sdf>\n"),
                          {"r.sdf:1", "libsdformat-dev", "URDF", "E0713 robot-without-sdf"}));
}

TEST_F(BadRobots, Urdf) {
  const std::string a = std::string("<link name='a'>") + kMassOfOne + "</link>\n",
                    b = std::string("<link name='b'>") + kMassOfOne + "</link>\n";
  const auto robot = [](const std::string& inside) { return "<robot name='r'>\n" + inside + "</robot>\n"; };
  const std::string ab = "<parent link='a'/><child link='b'/>";
  EXPECT_TRUE(test::names(message("r.urdf", robot(a + a)), {"r.urdf:3", "E0703"}));
  EXPECT_TRUE(test::names(message("r.urdf", robot("")), {"r.urdf:1", "E0711"}));
  EXPECT_TRUE(test::names(message("r.urdf", "<robot>\n" + a + "</robot>\n"), {"r.urdf:1", "no name", "E0703"}));
  EXPECT_TRUE(test::names(message("r.urdf", robot(a + b)), {"E0705"}));
  EXPECT_TRUE(test::names(
      message("r.urdf", robot(a + "<joint name='j' type='fixed'><parent link='a'/><child link='x'/></joint>")),
      {"r.urdf:3", "E0703"}));
  EXPECT_TRUE(test::names(message("r.urdf", robot(a + b + "<joint name='j' type='hinge'>" + ab + "</joint>")),
                          {"r.urdf:4", "E0711"}));
  EXPECT_TRUE(test::names(message("r.urdf", robot(a + b + "<joint name='j' type='revolute'>" + ab + "</joint>")),
                          {"r.urdf:4", "E0711"}));
  EXPECT_TRUE(test::names(
      message("r.urdf", robot(a + b + "<joint name='j' type='continuous'>" + ab + "<axis xyz='0 0'/></joint>")),
      {"r.urdf:4", "E0704"}));
  EXPECT_TRUE(test::names(
      message("r.urdf", robot(a + b + "<joint name='j' type='continuous'>" + ab + "<axis xyz='0 0 nan'/></joint>")),
      {"r.urdf:4", "E0704"}));
  EXPECT_TRUE(test::names(
      message("r.urdf", robot(a + b + "<joint name='j' type='continuous'>" + ab + "<axis xyz='0 0 0'/></joint>")),
      {"r.urdf:4", "E0704"}));
  EXPECT_TRUE(test::names(message("r.urdf", robot(a + b + "<joint name='j' type='fixed'>" + ab +
                                                  "</joint>\n<joint name='k' type='fixed'>" + ab + "</joint>")),
                          {"r.urdf:5", "E0705"}));
  EXPECT_TRUE(test::names(
      message("r.urdf", robot(a + b + "<joint name='j' type='fixed'>" + ab +
                              "</joint>\n<joint name='k' type='fixed'><parent link='b'/><child link='a'/></joint>")),
      {"E0705"}));
  EXPECT_TRUE(test::names(
      message(
          "r.urdf",
          robot("<link name='a'>\n<inertial><mass value='-1'/><inertia ixx='1' iyy='1' izz='1'/></inertial></link>")),
      {"r.urdf:3", "E0706"}));
  EXPECT_TRUE(test::names(
      message(
          "r.urdf",
          robot("<link name='a'><inertial><mass value='1'/>\n<inertia ixx='-1' iyy='1' izz='1'/></inertial></link>")),
      {"r.urdf:2", "E0706"}));
  EXPECT_TRUE(test::names(
      message("r.urdf",
              robot("<link name='a'>\n<collision><geometry><box size='1 1 -1'/></geometry></collision></link>")),
      {"r.urdf:3", "E0704"}));
  EXPECT_TRUE(test::names(
      message("r.urdf", robot(a + b + "<joint name='j' type='continuous'>" + ab + "<mimic joint='x'/></joint>")),
      {"r.urdf:4", "E0703"}));
  const std::string c = std::string("<link name='c'>") + kMassOfOne + "</link>\n";
  EXPECT_TRUE(test::names(
      message("r.urdf", robot(a + b + c + "<joint name='j' type='continuous'>" + ab + "<mimic joint='k'/></joint>\n" +
                              "<joint name='k' type='continuous'><parent link='a'/><child link='c'/><mimic "
                              "joint='j'/></joint>")),
      {"r.urdf:", "E0705"}));
}

TEST_F(BadRobots, Mjcf) {
  EXPECT_TRUE(
      test::names(message("r.xml", "<mujoco>\n<worldbody>\n<body>\n<joint/></body></worldbody></mujoco>"), {"E0707"}));
  EXPECT_TRUE(test::names(
      message("r.xml", "<mujoco>\n<worldbody>\n<body pos='0 0'>\n<geom size='1'/></body></worldbody></mujoco>"),
      {"r.xml:3", "E0707"}));
  EXPECT_TRUE(
      test::names(message("r.xml", "<mujoco>\n<worldbody>\n<thing/></worldbody></mujoco>"), {"r.xml:3", "E0707"}));
  EXPECT_TRUE(test::names(message("r.xml", "<mujoco>\n<include file='none.xml'/></mujoco>"), {"r.xml:2", "E0703"}));
  EXPECT_TRUE(test::names(message("r.xml", "<mujoco>\n<include file='r.xml'/></mujoco>"), {"r.xml:2", "E0705"}));
  EXPECT_TRUE(
      test::names(message("r.xml", "<mujoco><worldbody>\n<attach model='m' body='b' prefix='p'/></worldbody></mujoco>"),
                  {"r.xml:2", "mj_saveLastXML", "E0707"}));
  const auto inside = [&](const std::string& part) {
    return message("r.xml", "<mujoco><worldbody><body><freejoint/>\n" + part + "</body></worldbody></mujoco>");
  };
  for (const char* count : {"", "count='0'", "count='2.5'", "count='-1'", "count='1e9'", "count='x'"})
    EXPECT_TRUE(
        test::names(inside("<replicate " + std::string(count) + "><geom size='1'/></replicate>"), {"r.xml:2", "E0704"}))
        << count;
  const std::string thousand = "<replicate count='1000' sep='_'>";
  EXPECT_TRUE(
      test::names(inside(thousand + thousand + "<geom size='1'/></replicate></replicate>"), {"r.xml:2", "E0711"}));
  for (const char* placed : {"euler='1 2'", "quat='0 0 0 0'", "zaxis='0 0 0'", "xyaxes='1 0 0 2 0 0'", "pos='nan 0 0'"})
    EXPECT_TRUE(
        test::names(inside("<frame " + std::string(placed) + "><geom size='1'/></frame>"), {"r.xml:2", "E0704"}))
        << placed;
  EXPECT_TRUE(
      test::names(message("r.xml", "<mujoco><worldbody><geom size='1'/></worldbody></mujoco>"), {"r.xml:1", "E0712"}));
  EXPECT_TRUE(test::names(message("r.xml",
                                  "<mujoco><worldbody><body name='a'><geom size='1'/></body><body name='a'><geom "
                                  "size='1'/></body></worldbody></mujoco>"),
                          {"r.xml:1", "E0707"}));
}

// 2^18 files, in depth less than a file that includes itself. Before, 1 GB.
TEST_F(BadRobots, MjcfFilesThatIncludeEachOtherTwice) {
  for (int k = 1; k <= 18; ++k) {
    const std::string include = "<include file='m" + std::to_string(k + 1) + ".xml'/>";
    write("m" + std::to_string(k) + ".xml", "<mujoco>" + include + include + "</mujoco>");
  }
  write("m19.xml", "<mujoco/>");
  EXPECT_TRUE(test::names(message("r.xml", "<mujoco><include file='m1.xml'/></mujoco>"),
                          {"r.xml", "1000 included files", "E0437"}));
}

// Each file is small enough, all of them are not.
TEST_F(BadRobots, MjcfFilesWithTooManyPartsInAll) {
  std::string many = "<mujoco>", includes = "<mujoco>";
  for (int k = 0; k < 150000; ++k) many += "<a b=''/>";
  for (int k = 0; k < 7; ++k) includes += "<include file='many.xml'/>";
  write("many.xml", many + "</mujoco>");
  EXPECT_TRUE(test::names(message("r.xml", includes + "</mujoco>"), {"r.xml", "2000000 elements", "E0437"}));
}

// A node of COLLADA that has two instances of the next one, 45 levels: 2^45 triangles in 4 kB. Geometries likewise.
TEST_F(BadRobots, ColladaMeshesWithTooManyInstances) {
  const auto robot_with = [&](const std::string& nodes, const std::string& numbers) {
    const std::string dae =
        "<COLLADA><library_geometries><geometry id='g'><mesh><source id='p'><float_array>" + numbers +
        "</float_array></source><vertices id='v'><input semantic='POSITION' source='#p'/></vertices><triangles><input "
        "semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>"
        "<library_nodes>" +
        nodes +
        "</library_nodes><library_visual_scenes><visual_scene id='s'><node><instance_node url='#n0'/></node>"
        "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>";
    RobotGeometry g;
    g.kind = GeometryKind::kMesh;
    g.file = write("mesh.dae", dae);
    return g;
  };
  const std::string triangle = "0 0 0 1 0 0 0 1 0", last = "<instance_geometry url='#g'/></node>";
  std::string nodes;
  for (int k = 0; k < 45; ++k) {
    const std::string next = "<instance_node url='#n" + std::to_string(k + 1) + "'/>";
    nodes += "<node id='n" + std::to_string(k) + "'>" + next + next + "</node>";
  }
  EXPECT_TRUE(
      test::names(test::error_of([&] { geometry_mesh(robot_with(nodes + "<node id='n45'>" + last, triangle)); }),
                  {"mesh.dae", "100000 instances", "E0437"}));
  std::string numbers = triangle, instances = "<node id='n0'>";
  for (int k = 0; k < 100000; ++k) numbers += " 0";
  for (int k = 0; k < 250; ++k) instances += "<instance_geometry url='#g'/>";
  EXPECT_TRUE(test::names(test::error_of([&] { geometry_mesh(robot_with(instances + last, numbers)); }),
                          {"mesh.dae", "20000000 numbers", "E0437"}));
  EXPECT_EQ(geometry_mesh(robot_with("<node id='n0'>" + last, triangle)).triangles.size(), 1u);
}

TEST_F(BadRobots, Options) {
  const std::string robot = std::string("<robot name='r'><link name='a'>") + kMassOfOne + "</link></robot>";
  ImportOptions options;
  options.ground = "mud";
  EXPECT_TRUE(test::names(message("r.urdf", robot, options), {"mud", "E0710"}));
  options.ground = "plane";
  EXPECT_TRUE(test::names(message("r.urdf", robot, options), {"E0710"}));
  std::filesystem::create_directory(file("there"));
  ImportArguments a;
  a.file = file("r.urdf");
  a.out = file("there");
  EXPECT_TRUE(test::names(test::error_of([&] { import_command(a); }), {"E0709"}));
  a.file = file("none.urdf");
  a.out = file("out");
  EXPECT_TRUE(test::names(test::error_of([&] { import_command(a); }), {"none.urdf"}));
}

}  // namespace
}  // namespace footfall
