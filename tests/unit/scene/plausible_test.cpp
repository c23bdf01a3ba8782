// Warnings about numbers that are possible, but hardly meant; and what a check costs in scenes of many entries.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
