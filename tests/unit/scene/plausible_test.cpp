// Warnings about numbers that are possible, but hardly meant; and what a check costs in scenes of many entries.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/scene_check.h"
#include "tests/support/heap_requests.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> warnings(const std::string& scene, const std::vector<std::string>& settings = {}) {
  return SceneText().read(scene, settings).warnings;
}

auto says(const MessageCode& code, const std::string& key) { return AllOf(HasSubstr(code.number), HasSubstr(key)); }

// The pendulum of 1 m as a ball of 2 kg: 0.52 litres, 3820 kg/m3.
const std::string kBall = R"(end_time = 1.0
[materials.steel]
density = 7800
young_GPa = 210
poisson = 0.3
[[bodies]]
name = "bob"
mass = 2.0
material = "steel"
shape = { kind = "sphere", radius = 0.05, centre = [1, 0, 0] }
[[joints]]
name = "hinge"
kind = "revolute"
bodies = ["ground", "bob"]
point = [0, 0, 0]
axis = "y"
)";

TEST(Plausible, OrdinaryNumbersAreNotWarnedOf) {
  EXPECT_THAT(warnings(kPendulum), IsEmpty());
  EXPECT_THAT(warnings(kBall), IsEmpty());
}

TEST(Plausible, MassThatNoSolidOfThisSizeHas) {
  EXPECT_THAT(warnings(kBall, {"bodies.bob.mass=200"}), ElementsAre(says(code::kImplausibleMass, "bodies.bob.mass")));
  EXPECT_THAT(warnings(kBall, {"bodies.bob.mass=2e-4"}), ElementsAre(says(code::kImplausibleMass, "bodies.bob.mass")));
  EXPECT_THAT(warnings(kBall, {"materials.steel.density=7.8e6"}),
              ElementsAre(says(code::kImplausibleMass, "materials.steel.density")));
  // A point of 2 kg in a mechanism of 1 m may be a body of some metres, but not one of a kilometre.
  EXPECT_THAT(warnings(kPendulum, {"bodies.bob.mass=2e6"}), IsEmpty());
  EXPECT_THAT(warnings(kPendulum, {"bodies.bob.mass=2e9"}),
              ElementsAre(says(code::kImplausibleMass, "bodies.bob.mass")));
}

// Half a degree in 61 samples is 15 km, but half a metre for a pendulum of 1 m.
TEST(Plausible, MapInDegrees) {
  const SceneText files;
  const auto scene = [&](const std::string& step, const std::string& odd = "1 ") {
    std::ostringstream map;
    map << "ncols 61\nnrows 61\nxllcorner 33.1\nyllcorner -2.4\ncellsize " << step << '\n';
    for (int row = 0; row < 61; ++row, map << '\n')
      for (int column = 0; column < 61; ++column) map << (column % 2 ? odd : "1 ");
    return kBall +
           "[ground]\nkind = \"plane\"\nplane = { stiffness = 1e7 }\nterrain = { position = [0, 0, -9], map = { file = "
           "\"" +
           files.write("degrees.asc", map.str()) + "\" } }\n[[boundaries]]\nbody = \"bob\"\nsurface = {}\n";
  };
  EXPECT_THAT(warnings(scene("0.00833")), ElementsAre(says(code::kImplausibleNumber, "terrain.map.file")));
  EXPECT_THAT(warnings(scene("0.1")), IsEmpty());
  // Six degrees are larger than the pendulum, but the ground rises by 3 m on each metre; or by 0.2 m.
  EXPECT_THAT(warnings(scene("0.1", "1.3 ")), ElementsAre(says(code::kImplausibleNumber, "terrain.map.file")));
  EXPECT_THAT(warnings(scene("0.1", "1.02 ")), IsEmpty());
}

TEST(HeightMap, FaultsNameTheLineOfTheirKey) {
  const auto fault = [](const std::string& text) {
    const SceneText scene;
    scene.write("fault.asc", text);
    return scene.findings(
        kBall +
        "[ground]\nkind = \"plane\"\nplane = { stiffness = 1e7 }\nterrain = { map = { file = \"fault.asc\" "
        "} }\n[[boundaries]]\nbody = \"bob\"\nsurface = {}\n");
  };
  const auto header = [](const std::string& columns, const std::string& rows, const std::string& cell) {
    return "ncols " + columns + "\nnrows " + rows + "\nxllcorner 0\nyllcorner 0\n" + cell +
           "\nNODATA_value -9999\n1 2\n3 4\n";
  };
  EXPECT_THAT(fault(header("1", "2", "cellsize 1")), HasSubstr("fault.asc:1: "));
  EXPECT_THAT(fault(header("2", "1", "cellsize 1")), HasSubstr("fault.asc:2: "));
  EXPECT_THAT(fault(header("2", "2.5", "cellsize 1")), HasSubstr("fault.asc:2: "));
  EXPECT_THAT(fault(header("50000", "20000", "cellsize 1")), HasSubstr("fault.asc:1: "));
  EXPECT_THAT(fault(header("2", "2", "cellsize 0")), HasSubstr("fault.asc:5: "));
  EXPECT_THAT(fault(header("2", "2", "dx 1\ndy -1")), HasSubstr("fault.asc:6: "));
  EXPECT_THAT(fault(header("2", "2", "cellsize 1") + "x"), HasSubstr("fault.asc:9: "));
  EXPECT_EQ(fault(header("2", "2", "cellsize 1")), "");
  for (const char* const packed : {"\xff\xfe"
                                   "n",
                                   "\x1f\x8b"
                                   "xyz"})
    EXPECT_THAT(fault(packed), HasSubstr(code::kTerrainMap.number));
}

TEST(Plausible, InertiaInOtherUnits) {
  EXPECT_THAT(warnings(kBall, {"bodies.bob.inertia=[2e3, 2e3, 2e3]"}),  // kg mm2
              ElementsAre(says(code::kImplausibleInertia, "bodies.bob.inertia")));
  EXPECT_THAT(warnings(kPendulum, {"bodies.bob.inertia=[1e5, 1e5, 2e5]"}),
              ElementsAre(says(code::kImplausibleInertia, "bodies.bob.inertia")));
}

TEST(Plausible, GravityInMillimetres) {
  EXPECT_THAT(warnings(kPendulum, {"gravity=[0, 0, -9810]"}), ElementsAre(says(code::kImplausibleGravity, "gravity")));
  EXPECT_THAT(warnings(kPendulum, {"gravity=[0, 0, -981]"}), IsEmpty());  // a centrifuge
}

TEST(Plausible, AnglesOfMoreThanATurnUnlessGivenInDegrees) {
  const std::string stops = kPendulum + "[joints.angle]\nstops = { max = 90, stiffness = 1e4 }\n";
  EXPECT_THAT(warnings(stops), ElementsAre(says(code::kAngleInDegrees, "joints.hinge.angle.stops.max")));
  EXPECT_THAT(warnings(kPendulum + "[joints.angle]\nstops = { max_deg = 720, stiffness = 1e4 }\n"), IsEmpty());
  EXPECT_THAT(warnings(kPendulum, {"initial.pitch=30"}), ElementsAre(says(code::kAngleInDegrees, "initial.pitch")));
  EXPECT_THAT(warnings(kPendulum, {"initial.pitch_deg=30"}), IsEmpty());
}

// Wherever a scene has an angle: orientations, phases, and positions that motors and prescribed rotations reach.
TEST(Plausible, AnglesOfEveryKind) {
  EXPECT_THAT(warnings(kBall, {"bodies.bob.orientation={rpy=[0, 0, 90]}"}),
              ElementsAre(says(code::kAngleInDegrees, "bodies.bob.orientation.rpy")));
  EXPECT_THAT(warnings(kBall, {"bodies.bob.orientation={axis=[0, 0, 1], angle=-90}"}),
              ElementsAre(says(code::kAngleInDegrees, "bodies.bob.orientation.angle")));
  EXPECT_THAT(warnings(kBall, {"bodies.bob.orientation={rpy_deg=[0, 0, 90]}"}), IsEmpty());
  const std::string motor =
      kBall + "[[drives]]\nname = \"motor\"\nkind = \"position\"\njoint = \"hinge\"\nkp = 10\ncommand = ";
  EXPECT_THAT(warnings(motor + "{ amplitude = 30, frequency = 1 }\n"),
              ElementsAre(says(code::kAngleInDegrees, "drives.motor.command")));
  EXPECT_THAT(warnings(motor + "{ table = [[0, 0], [1, 90]] }\n"),
              ElementsAre(says(code::kAngleInDegrees, "drives.motor.command")));
  EXPECT_THAT(warnings(motor + "{ table = [[0, 0], [1, 12.566370614]] }\n"), IsEmpty());  // two turns
  EXPECT_THAT(warnings(motor + "{ amplitude = 0.5, frequency = 1, phase = 90 }\n"),
              ElementsAre(says(code::kAngleInDegrees, "drives.motor.command.phase")));
}

TEST(Plausible, SpeedBeyondThatOfSound) {
  // steel: sqrt(210e9 / 7800) = 5189 m/s; without a material 1000 m/s
  EXPECT_THAT(warnings(kBall, {"initial.velocity=[5100, 0, 0]"}), IsEmpty());
  EXPECT_THAT(warnings(kBall, {"initial.velocity=[5300, 0, 0]"}),
              ElementsAre(says(code::kImplausibleSpeed, "initial.velocity")));
  EXPECT_THAT(warnings(kPendulum, {"initial.velocity=[0, 0, -1200]"}),
              ElementsAre(says(code::kImplausibleSpeed, "initial.velocity")));
  EXPECT_THAT(warnings(kPendulum, {"initial.angular_velocity=[0, 3000, 0]"}),
              ElementsAre(says(code::kImplausibleSpeed, "initial.angular_velocity")));
}

// 1000 rpm written as 1e5 rad/s; a prescribed table in millimetres: 2000 of them in 1 s.
TEST(Plausible, SpeedThatMotorsAndTablesCommand) {
  const std::string motor =
      kBall + "[[drives]]\nname = \"motor\"\nkind = \"speed\"\njoint = \"hinge\"\nkp = 10\ncommand = ";
  EXPECT_THAT(warnings(motor + "{ polynomial = [100] }\n"), IsEmpty());
  EXPECT_THAT(warnings(motor + "{ polynomial = [1e5] }\n"),
              ElementsAre(says(code::kImplausibleSpeed, "drives.motor.command")));
  const std::string led = R"(end_time = 1.0
[[bodies]]
name = "tray"
mass = 1
shape = { kind = "box", size = [0.2, 0.2, 0.02], centre = [0, 0, 0] }
[[joints]]
name = "path"
kind = "prescribed"
bodies = ["ground", "tray"]
point = [0, 0, 0]
motion = { x = { table = [[0, 0], [)";
  EXPECT_THAT(warnings(led + "0.5, 1], [1, 2]] } }\n"), IsEmpty());
  EXPECT_THAT(warnings(led + "0.5, 1000], [1, 2000]] } }\n"),
              ElementsAre(says(code::kImplausibleSpeed, "joints.path.motion.x")));
}

// Friction and damping in per cent or degrees, pressure in bar, a plate in millimetres, a point in millimetres, a period of
// seconds, and an inertia that no body of this mass has.
TEST(Plausible, NumbersFarOutsideOfWhatIsBuilt) {
  const std::string plane = kBall + "[[boundaries]]\nbody = \"bob\"\nsurface = {}\n[ground]\nkind = \"plane\"\n";
  EXPECT_THAT(warnings(plane + "plane = { young = 35e6 }\n"), IsEmpty());
  EXPECT_THAT(warnings(plane + "plane = { young = 35e6, friction = 35 }\n"),
              ElementsAre(says(code::kImplausibleNumber, "ground.plane.friction")));
  EXPECT_THAT(warnings(plane + "plane = { young = 0.035 }\n"),
              ElementsAre(says(code::kSoftSpring, "ground.plane.young")));
  EXPECT_THAT(warnings(plane + "plane = { young = 35e6 }\n", {"gravity=[9.81, 0, 0]"}),
              ElementsAre(says(code::kGravityUpwards, "gravity")));
  const std::string strut =
      kBall +
      "[[struts]]\nname = \"leg\"\nbodies = [\"ground\", \"bob\"]\npoints = [[0, 0, 1], [1, 0, 0]]\n"
      "gas = { piston_diameter = 0.03, pressure = 3e5, volume = 2e-4 }\nstops = { max = 0.2 }\n";
  EXPECT_THAT(warnings(strut), IsEmpty());
  EXPECT_THAT(warnings(strut, {"struts.leg.gas.pressure=3"}),
              ElementsAre(says(code::kImplausibleNumber, "struts.leg.gas.pressure")));
  EXPECT_THAT(warnings(strut, {"struts.leg.gas.piston_diameter=30", "struts.leg.gas.volume=200"}),
              ElementsAre(says(code::kImplausibleNumber, "struts.leg.gas.piston_diameter")));
  EXPECT_THAT(
      warnings(kBall + "[[bodies]]\nname = \"plate\"\nmaterial = \"steel\"\nshape = { kind = \"disc\", centre = [0, 0, "
                       "5], axis = \"z\", radius = 0.2, thickness = 4 }\n[[forces]]\nname = \"f\"\nbody = "
                       "\"plate\"\ndirection = [0, 0, 1]\nforce = { polynomial = [1] }\n"),
      ElementsAre(says(code::kImplausibleNumber, "bodies.plate.shape.thickness")));
  const std::string thrust =
      kBall + "[[forces]]\nname = \"f\"\nbody = \"bob\"\ndirection = [0, 0, 1]\nforce = { polynomial = [1] }\n";
  EXPECT_THAT(warnings(thrust + "point = [1, 0.05, 0]\n"), IsEmpty());
  EXPECT_THAT(warnings(thrust + "point = [1, 50, 0]\n"), ElementsAre(says(code::kImplausibleNumber, "forces.f.point")));
  const std::string sampled = kBall + "[[signals]]\nname = \"s\"\nkind = \"expression\"\ninput = \"time\"\nperiod = ";
  EXPECT_THAT(warnings(sampled + "0.5\n"), IsEmpty());
  EXPECT_THAT(warnings(sampled + "2\n"), ElementsAre(says(code::kImplausibleNumber, "signals.s.period")));
  EXPECT_THAT(
      warnings("end_time = 1\n[[bodies]]\nname = \"free\"\nmass = 10\ninertia = [2e6, 2e6, 2e6]\nposition = [0, 0, "
               "0]\n[[forces]]\nname = \"f\"\nbody = \"free\"\ndirection = [0, 0, 1]\nforce = { polynomial = [1] }\n"),
      ElementsAre(says(code::kImplausibleInertia, "bodies.free.inertia")));
}

const std::string kOnSand =
    kBall + "[ground]\nkind = \"soil\"\nsoil = \"dry-sand\"\n[[boundaries]]\nbody = \"bob\"\nsurface = {}\n";

// Each of them was taken without a word.
TEST(Plausible, NumbersInOtherUnitsAtTheGround) {
  EXPECT_THAT(warnings(kOnSand), IsEmpty());
  EXPECT_THAT(warnings(kOnSand, {"ground.law.density=1.6"}),
              ElementsAre(says(code::kImplausibleMass, "ground.law.density")));
  EXPECT_THAT(warnings(kOnSand, {"ground.law.density=1600"}), IsEmpty());
  EXPECT_THAT(warnings(kOnSand, {"initial.velocity=[0,0,-200]"}),
              ElementsAre(says(code::kImplausibleSpeed, "initial.velocity")));
  EXPECT_THAT(warnings(kOnSand, {"initial.velocity=[0,0,-40]"}), IsEmpty());
  EXPECT_THAT(warnings(kPendulum, {"initial.pitch=4"}), ElementsAre(says(code::kAngleInDegrees, "initial.pitch")));
  EXPECT_THAT(warnings(kPendulum, {"initial.pitch=3.1"}), IsEmpty());
  EXPECT_THAT(warnings(kPendulum, {"initial.pitch_deg=230"}), IsEmpty());
}

TEST(Plausible, RemainderOfTheMass) {
  EXPECT_THAT(warnings("total_mass = 2.0\n" + kBall, {"bodies.bob.mass=\"remainder\""}), IsEmpty());
  EXPECT_THAT(warnings("total_mass = 2000.0\n" + kBall, {"bodies.bob.mass=\"remainder\""}),
              ElementsAre(AllOf(says(code::kImplausibleMass, "bodies.bob.mass"), HasSubstr("total_mass"))));
}

TEST(Plausible, RequirementInMillimetres) {
  const std::string bounded = "[[requirements]]\nname = \"sinkage\"\nvalue = \"max_sinkage_m\"\nmost = ";
  EXPECT_THAT(warnings(kOnSand + bounded + "180\n"), ElementsAre(says(code::kImplausibleNumber, "most")));
  EXPECT_THAT(warnings(kOnSand + bounded + "0.18\n"), IsEmpty());
}

TEST(Plausible, HoneycombThatTheWeightCrushes) {
  const auto strut = [](const char* force) {
    return kPendulum +
           "[[struts]]\nname = \"s\"\nbodies = [\"ground\", \"bob\"]\npoints = [[0, 0, 1], [1, 0, "
           "0]]\nhoneycomb = { stages = [{ force = " +
           force + ", length = 0.1 }] }\n";
  };
  EXPECT_THAT(warnings(strut("0.1")), ElementsAre(says(code::kImplausibleNumber, "honeycomb.stages")));
  EXPECT_THAT(warnings(strut("100")), IsEmpty());
}

TEST(Plausible, PythonFunctionThatItsFileDoesNotDefine) {
  const SceneText files;
  const std::string file = files.write("thrust.py", "# def thrust(t): not yet\ndef push(time):\n    return 1.0\n");
  const auto signal = [&](const char* function) {
    return kPendulum + "[[signals]]\nname = \"f\"\nkind = \"python\"\nfile = \"" + file + "\"\nfunction = \"" +
           function + "\"\nperiod_ms = 10\n";
  };
  EXPECT_THAT(warnings(signal("push")), IsEmpty());
  EXPECT_THAT(warnings(signal("thrust")), ElementsAre(says(code::kNoFunction, "def thrust")));
}

// x = 0.1 sin(30 degrees) at the start, with the bodies drawn at 0.
TEST(Plausible, MotionsThatDoNotBeginAsDrawn) {
  const std::string led =
      "end_time = 1.0\n[[bodies]]\nname = \"tray\"\nmass = 1\ninertia = [0.1, 0.1, 0.1]\nposition = [0, 0, "
      "0]\n[[joints]]\nname = \"path\"\nkind = \"prescribed\"\nbodies = [\"ground\", \"tray\"]\npoint = [0, 0, "
      "0]\nmotion = { x = { amplitude = 0.1, frequency = 2, phase_deg = 30, polynomial = [";
  EXPECT_THAT(SceneText().findings(led + "0] } }\n"), says(code::kMotionStart, "joints.path.motion.x"));
  EXPECT_EQ(SceneText().findings(led + "-0.05] } }\n"), "");
}

// The byte order mark that spreadsheets put in front, and the end of line of theirs.
TEST(SceneTables, MayBeginWithAByteOrderMark) {
  const SceneText folder;
  folder.write("thrust.csv",
               "\xEF\xBB\xBF"
               "0.2;0\r\n0.3;100\r\n");
  const Scene scene = folder.read(kPendulum +
                                  "[[forces]]\nname = \"f\"\nbody = \"bob\"\ndirection = [0, 0, 1]\nforce = { table = "
                                  "\"thrust.csv\" }\n");
  EXPECT_THAT(scene.forces.front().force->table, ElementsAre(Eigen::Vector2d(0.2, 0.0), Eigen::Vector2d(0.3, 100.0)));
}

// As drawn; [initial.joints] may start it within.
TEST(Plausible, StopsThatTheDrawingIsBeyond) {
  const std::string stops = kPendulum + "[joints.angle]\nstops = { max = -0.3, stiffness = 1e4 }\n";
  EXPECT_THAT(warnings(stops), ElementsAre(says(code::kStartBeyondStop, "joints.hinge.angle.stops.max")));
  EXPECT_THAT(warnings(stops + "[initial.joints]\nhinge = -0.5\n"), IsEmpty());
}

// 2 kg on a slider of 20 N/m sink by 1 m, of 2000 N/m by 10 mm; on a cable of 50 N, straight over 1.4 m, by 0.5 m.
TEST(Plausible, SlidersAndCablesThatSinkByMoreThanTheMechanismIsLarge) {
  const std::string slider = R"(end_time = 1.0
[[bodies]]
name = "load"
mass = 2
shape = { kind = "box", size = [0.1, 0.1, 0.1], centre = [0, 0, 0.5] }
)";
  const std::string guide =
      "[[joints]]\nname = \"guide\"\nkind = \"prismatic\"\nbodies = [\"ground\", \"load\"]\npoint = [0, 0, 0.5]\naxis "
      "= "
      "\"z\"\n";
  const auto spring = [](const std::string& k) { return "displacement = { spring = { stiffness = " + k + " } }\n"; };
  EXPECT_THAT(warnings(slider + guide + spring("2000")), IsEmpty());
  EXPECT_THAT(warnings(slider + guide + spring("20")),
              ElementsAre(says(code::kSoftSpring, "joints.guide.displacement.spring.stiffness")));
  EXPECT_THAT(warnings(slider + guide + spring("20"), {"gravity=[9.81, 0, 0]"}), IsEmpty());
  const std::string strut =
      "[[struts]]\nname = \"leg\"\nbodies = [\"ground\", \"load\"]\npoints = [[0, 0, 0], [0, 0, 0.5]]\nspring = { "
      "stiffness = 20 "
      "}\n";
  EXPECT_THAT(warnings(slider + guide + strut), ElementsAre(says(code::kSoftSpring, "struts.leg.spring.stiffness")));
  EXPECT_THAT(warnings(slider + guide + strut, {"struts.leg.spring.preload=19.6"}), IsEmpty());
  const std::string cable =
      slider +
      "[[cables]]\nname = \"rope\"\npath = [{ body = \"ground\", point = [0, 0, 1] }, { body = \"load\", "
      "point = [0, 0, 0.55] }]\nEA = ";
  EXPECT_THAT(warnings(cable + "1e4\n"), IsEmpty());
  EXPECT_THAT(warnings(cable + "5\n"), ElementsAre(says(code::kSoftSpring, "cables.rope.EA")));
}

// A point mass on a spring at its own place has no size to compare with.
TEST(Plausible, PointsAreNotCompared) {
  const std::string point =
      "end_time = 1.0\n[[bodies]]\nname = \"m\"\nmass = 2\ninertia = [0.1, 0.1, 0.1]\nposition = [0, 0, 1]\n";
  EXPECT_THAT(
      warnings(point + "[[springs]]\nname = \"s\"\nkind = \"bushing\"\nbodies = [\"ground\", \"m\"]\npoint = [0, 0, "
                       "1]\nstiffness = 1000\n"),
      IsEmpty());
  EXPECT_THAT(
      warnings(point + "[[joints]]\nname = \"j\"\nkind = \"prismatic\"\nbodies = [\"ground\", \"m\"]\npoint = [0, 0, "
                       "1]\naxis = \"z\"\ndisplacement = { spring = { stiffness = 1000 } }\n"),
      IsEmpty());
}

// 300 kg on four springs of 20 N/mm sink by 37 mm; written as 20 N/m, by 37 m.
TEST(Plausible, SpringsThatSinkByMoreThanTheMechanismIsLarge) {
  std::string car = R"(end_time = 1.0
[[bodies]]
name = "chassis"
mass = 300
inertia = [100, 100, 100]
position = [0, 0, 0.5]
)";
  for (const std::string number : {"1", "2", "3", "4"})
    car += "[[struts]]\nname = \"spring_" + number + "\"\nbodies = [\"ground\", \"chassis\"]\npoints = [[" + number +
           ", 0, 0], [" + number + ", 0, 0.5]]\nspring = { stiffness = 20e3 }\n";
  EXPECT_THAT(warnings(car), IsEmpty());
  std::string soft = car;
  for (std::size_t at = soft.find("20e3"); at != std::string::npos; at = soft.find("20e3")) soft.replace(at, 4, "20");
  EXPECT_THAT(warnings(soft), ElementsAre(says(code::kSoftSpring, "spring.stiffness")));
  EXPECT_THAT(warnings(soft, {"gravity=[0, 0, 0]"}), IsEmpty());
  // A preload or a stop may carry it.
  EXPECT_THAT(warnings(soft, {"struts.spring_1.spring.preload=1000"}), IsEmpty());
}

TEST(Plausible, ABodyInsideAnotherThatNothingConnects) {
  const auto box = [](const std::string& name, double x, double edge) {
    const std::string e = std::to_string(edge);
    return "[[bodies]]\nname = \"" + name + "\"\nmass = 1\nshape = { kind = \"box\", size = [" + e + ", " + e + ", " +
           e + "], centre = [" + std::to_string(x) + ", 0, 0] }\n";
  };
  const std::string two = "end_time = 1\n" + box("crate", 0.0, 0.4) + box("stone", 0.1, 0.1);
  EXPECT_THAT(warnings(two), ElementsAre(says(code::kBodyInside, "\"stone\"")));
  EXPECT_THAT(warnings("end_time = 1\n" + box("crate", 0.0, 0.4) + box("stone", 0.2, 0.1)),
              IsEmpty());                                                                             // across a face
  EXPECT_THAT(warnings("end_time = 1\n" + box("one", 0.0, 0.4) + box("same", 0.0, 0.4)).size(), 1u);  // drawn twice
  EXPECT_THAT(
      warnings(two +
               "[[joints]]\nname = \"weld\"\nkind = \"fixed\"\nbodies = [\"crate\", \"stone\"]\npoint = [0, 0, 0]\n"),
      IsEmpty());
}

// n bodies in a row with a joint, a strut and a filter each.
std::string row_of_bodies(int n) {
  std::string text = "end_time = 1.0\n";
  for (int k = 0; k < n; ++k) {
    const std::string number = std::to_string(k), last = k == 0 ? "ground" : "body_of_the_row_" + std::to_string(k - 1);
    const std::string pair = "bodies = [\"" + last + "\", \"body_of_the_row_" + number + "\"]\n";
    text += "[[bodies]]\nname = \"body_of_the_row_" + number + "\"\nmass = 1\ninertia = [0.1, 0.1, 0.1]\nposition = [" +
            number + ".5, 0, 0]\n[[joints]]\nname = \"joint_of_the_row_" + number + "\"\nkind = \"revolute\"\n" + pair +
            "point = [" + number + ", 0, 0]\naxis = \"y\"\n[[struts]]\nname = \"strut_of_the_row_" + number + "\"\n" +
            pair + "points = [[" + number + ", 0, 1], [" + number + ".5, 0, 0]]\nspring = { stiffness = 1e4 }\n" +
            "[[signals]]\nname = \"signal_of_the_row_" + number + "\"\nkind = \"lowpass\"\nfrequency = 5\ninput = \"" +
            (k == 0 ? "time" : "signal.signal_of_the_row_" + std::to_string(k - 1)) + "\"\n";
  }
  return text;
}

TEST(SceneCheck, NeedsAsMuchMemoryPerEntryInLongScenesAsInShortOnes) {
  SKIP_WHERE_MEMORY_IS_NOT_COUNTED();
  const auto requests = [](int n) {
    const Scene scene = SceneText().read(row_of_bodies(n));
    Findings findings("scene.toml");
    const long before = test::heap_requests;
    check_scene(scene, findings);
    return static_cast<double>(test::heap_requests - before) / n;
  };
  EXPECT_LT(requests(200), 1.2 * requests(50));  // names copied for every entry: 4 times
}

// Grains of [particles.box] lighter than air or heavier than osmium, and an exchange at the end of the run alone.
TEST(Plausible, NumbersOfABoxAreOfGrainsAndWithinTheRun) {
  const std::string box = kBall + R"([[boundaries]]
body = "bob"
surface = {}
[ground]
kind = "particles"
[particles.box]
size = [3, 1]
depth = 0.5
radius = 0.05
)";
  EXPECT_THAT(warnings(box), IsEmpty());
  EXPECT_THAT(warnings(box, {"particles.box.material.density=1e-3", "particles.box.time_step=1e-7"}),
              ElementsAre(says(code::kImplausibleMass, "particles.box.material.density")));
  EXPECT_THAT(SceneText().findings(box, {"particles.box.exchange_steps=10000000"}),
              says(code::kOutOfRange, "particles.box.exchange_steps"));
}

}  // namespace
}  // namespace footfall
