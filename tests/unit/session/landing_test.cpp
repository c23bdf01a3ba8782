// What is told of a landing, against closed forms of a box on four feet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/observe/landing.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/observe/start_values.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/summary.h"
#include "tests/support/refused.h"
#include "tests/unit/session/recorded.h"
#include "tests/unit/session/small_machine.h"

namespace footfall {
namespace landing {  // its constants have names of other tests

using test::Bench;

constexpr double kMass = 1200.0, kHeight = 1.5, kAlong = 1.5, kAcross = 2.0;  // of the mass centre, and of the feet [m]
constexpr double kGravity = 1.62, kRadius2 = 1.0;                             // k^2: inertia over mass [m2]
const double kReach = std::hypot(kHeight, kAlong);  // of the mass centre from an edge along y [m]
const double kRoundOff = 1e-9;                      // of energies of 1e3 J

// A box whose feet are points, and a rock that does not belong to it.
const std::string kBox = R"(end_time = 1
gravity = [0, 0, -1.62]
[[bodies]]
name = "box"
mass = 1200
inertia = [1200, 1200, 1200]
position = [0, 0, 1.5]
[[bodies]]
name = "rock"
mass = 5000
inertia = [100, 100, 100]
position = [20, 0, 1]
[[boundaries]]
body = "box"
[boundaries.beams]
points = [[-0.1, 0, 1.5], [0.1, 0, 1.5]]
radius = 0.05
[ground]
kind = "plane"
[ground.plane]
young_MPa = 35
restitution = 0.4
impact_speed = 1.0
[landing]
base = "box"
pads = ["foot_1", "foot_2", "foot_3", "foot_4", "middle"]
points = [{ name = "foot_1", body = "box", point = [1.5, 2, 0] }, { name = "foot_2", body = "box", point = [-1.5, 2, 0] },
          { name = "foot_3", body = "box", point = [1.5, -2, 0] }, { name = "foot_4", body = "box", point = [-1.5, -2, 0] },
          { name = "middle", body = "box", point = [0.15, 0.2, 0] }, { name = "nozzle", body = "box", point = [0, 0, 0.4] }]
)";

LandingValues values_of(Bench& bench) {
  LandingWatch watch(bench.subject());
  watch.update(bench.take());
  return watch.now();
}

TEST(Landing, ALevelBoxIsAsFarFromTippingAsItsNearestEdge) {
  Bench bench(kBox);
  const LandingValues level = values_of(bench);
  EXPECT_NEAR(level.stability_distance, kAlong, 1e-12);
  EXPECT_NEAR(level.tip_energy_margin, kMass * kGravity * (kReach - kHeight), kRoundOff);
  EXPECT_NEAR(level.tilt, 0.0, 1e-12);
  EXPECT_NEAR(level.clearance[5], 0.4, 1e-12);
}

// Turned by t about y: the edge that goes down is nearer, b cos t - h sin t, and the mass centre h cos t + b sin t above it.
TEST(Landing, ATiltedBoxIsNearerToTippingOverItsLowerEdge) {
  for (const double degrees : {10.0, 30.0, 44.0, 50.0}) {
    Bench bench(kBox, {"initial.pitch_deg=" + std::to_string(degrees)});
    const double t = degrees * kPi / 180.0;
    LandingWatch watch(bench.subject());
    watch.update(bench.take());
    EXPECT_NEAR(watch.now().stability_distance, kAlong * std::cos(t) - kHeight * std::sin(t), 1e-12);
    const double lift = kReach - kHeight * std::cos(t) - kAlong * std::sin(t);  // to the top, or from there
    EXPECT_NEAR(watch.now().tip_energy_margin, std::copysign(kMass * kGravity * lift, 45.0 - degrees), kRoundOff);
    EXPECT_NEAR(watch.now().tilt, t, 1e-12);
    EXPECT_EQ(watch.tipped(), degrees > 45.0);  // b / h = 1
  }
}

// A slope of s made by gravity is one made by turning everything.
TEST(Landing, GravityTellsWhatIsVertical) {
  const double s = 20.0 * kPi / 180.0;
  Bench bench(kBox, {"gravity=[" + std::to_string(kGravity * std::sin(s)) + ",0," +
                     std::to_string(-kGravity * std::cos(s)) + "]"});
  const LandingValues values = values_of(bench);
  const double printed = 1e-5;  // digits of the gravity above
  EXPECT_NEAR(values.stability_distance, kAlong * std::cos(s) - kHeight * std::sin(s), printed);
  EXPECT_NEAR(values.tilt, s, printed);
  EXPECT_NEAR(values.clearance[5], 0.4, 1e-12);  // from the plane, which is level
}

TEST(Landing, ABoxOnItsBackHasTipped) {
  Bench bench(kBox, {"initial.roll_deg=180"});
  LandingWatch watch(bench.subject());
  watch.update(bench.take());
  EXPECT_NEAR(watch.now().stability_distance, -kAcross, 1e-12);
  EXPECT_TRUE(watch.tipped());
  EXPECT_NEAR(watch.now().tilt, kPi, 1e-9);
}

// v = sqrt(2 g (r - h) (k^2 + r^2)) / h: a body that trips over its feet at this speed stops on the top.
TEST(Landing, TheEnergyMarginIsUsedUpAtTheSpeedOfTripping) {
  const double v = std::sqrt(2.0 * kGravity * (kReach - kHeight) * (kRadius2 + kReach * kReach)) / kHeight;
  EXPECT_NEAR(v, 2.218, 5e-4);
  Bench bench(kBox, {"initial.velocity=[" + std::to_string(v) + ",0,0]"});
  EXPECT_NEAR(values_of(bench).tip_energy_margin, 0.0, 1e-5 * kMass);  // six digits of v
  Bench half(kBox, {"initial.velocity=[" + std::to_string(-0.5 * v) + ",0,0]"});
  const double lift = kMass * kGravity * (kReach - kHeight);
  EXPECT_NEAR(values_of(half).tip_energy_margin, 0.75 * lift, 1e-5 * kMass);  // backwards alike
}

// About its edge a box has the inertia m (k^2 + r^2); a turn inwards costs nothing.
TEST(Landing, OnlyATurnOutwardsTakesFromTheEnergyMargin) {
  const double lift = kMass * kGravity * (kReach - kHeight), w = 0.2;  // [rad/s]
  for (const double sign : {1.0, -1.0}) {
    Bench bench(kBox);
    const double x = sign * kAlong;  // of the edge about which it turns outwards
    bench.state.v(4) = sign * w;
    bench.state.v(0) = sign * w * kHeight;
    bench.state.v(2) = w * std::abs(x);  // v = w x (c - p)
    EXPECT_NEAR(values_of(bench).tip_energy_margin, lift - 0.5 * kMass * (kRadius2 + kReach * kReach) * w * w, 1e-8);
    bench.state.v *= -1.0;
    EXPECT_GT(values_of(bench).tip_energy_margin, lift - 0.5 * kMass * (kRadius2 + kReach * kReach) * w * w + 1.0);
  }
}

// Feet as bodies: balls below the box, a probe on a strut in its middle.
std::string box_on_balls() {
  std::string text = R"(end_time = 3
gravity = [0, 0, -1.62]
[[bodies]]
name = "box"
mass = 1200
inertia = [1200, 1200, 1200]
position = [0, 0, 1.5]
[[bodies]]
name = "probe"
mass = 1
inertia = [1, 1, 1]
position = [0, 0, 1]
[[joints]]
name = "slide"
kind = "prismatic"
bodies = ["box", "probe"]
point = [0, 0, 1.5]
axis = "z"
[[struts]]
name = "leg"
bodies = ["box", "probe"]
points = [[0, 0, 1.5], [0, 0, 1]]
spring = { stiffness = 1e4, damping = 100 }
stops = { max = 0.1, stiffness = 1e6 }
[ground]
kind = "plane"
[ground.plane]
stiffness = 1e9
restitution = 0.5
impact_speed = 0.1
friction = 0.1
[landing]
points = [{ name = "nozzle", body = "box", point = [0, 0, 0.4] }]
[initial]
clearance = 0
)";
  for (int k = 1; k <= 4; ++k) {
    const std::string name = "ball_" + std::to_string(k), x = k % 2 ? "1.5" : "-1.5", y = k > 2 ? "2" : "-2";
    const std::string at = "[" + x + ", " + y + ", 0.1]";
    text += "[[bodies]]\nname = \"" + name +
            "\"\nmass = 0.5\nshape = { kind = \"sphere\", radius = 0.1, centre = " + at +
            " }\n[[boundaries]]\nbody = \"" + name + "\"\n[boundaries.surface]\nelement_size = 0.1\n" +
            "[[joints]]\nname = \"weld_" + std::to_string(k) + "\"\nkind = \"fixed\"\nbodies = [\"box\", \"" + name +
            "\"]\npoint = " + at + "\n";
  }
  return text;
}

class BoxOnBalls : public ::testing::Test {
 protected:
  void press(const std::string& body, double force) {
    bench.inputs.loads.resize(bench.scene.bodies.size());
    bench.inputs.loads[static_cast<std::size_t>(bench.scene.body_index(body))].F_W = {0.0, 0.0, force};
  }
  void move(const Eigen::Vector3d& way) {
    for (const int q : bench.equations.layout().body_q) bench.state.q.segment<3>(q) += way;
  }
  void at(double time) {
    bench.state.time = time;
    watch.update(bench.take());
  }

  Bench bench{box_on_balls(), {"initial.clearance=1"}};
  LandingWatch watch{bench.subject()};
};

TEST_F(BoxOnBalls, PadsAreTheBodiesWithABoundary) {
  EXPECT_EQ(watch.base(), "box");
  EXPECT_EQ(watch.pads(), (std::vector<std::string>{"ball_1", "ball_2", "ball_3", "ball_4"}));
  at(0.0);
  EXPECT_NEAR(watch.now().stability_distance, kAlong, 1e-12);
  EXPECT_NEAR(watch.now().clearance[0], 1.4, 1e-12);
  EXPECT_TRUE(watch.first_contacts().empty());
}

TEST_F(BoxOnBalls, FirstContactsAreToldInTheirOrder) {
  at(0.0);
  press("ball_3", 10.0);
  at(0.5);
  press("ball_1", 10.0);
  press("ball_3", 0.0);
  at(0.75);
  press("ball_3", 10.0);
  at(1.0);
  const std::vector<LandingWatch::First> contacts = watch.first_contacts();
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0].name, "ball_3");
  EXPECT_EQ(contacts[0].time, 0.5);
  EXPECT_EQ(contacts[1].name, "ball_1");
  EXPECT_EQ(contacts[1].time, 0.75);
  EXPECT_EQ(watch.now().pads_touching, 2);
}

// From where each pad first touched, along the ground; extremes of stability count from there on.
TEST_F(BoxOnBalls, SlidesFromItsFirstContact) {
  bench.state.v(4) = 3.0;  // a tumble in flight, which ends before it touches
  at(0.0);
  const double flying = watch.least_margin().value;
  bench.state.v(4) = 0.0;
  press("ball_3", 10.0);
  at(0.1);
  EXPECT_GT(watch.least_margin().value, flying);
  EXPECT_EQ(watch.least_margin().time, 0.1);
  EXPECT_EQ(watch.now().slid, 0.0);
  move({0.3, -0.4, 0.2});
  at(0.2);
  EXPECT_NEAR(watch.now().slid, 0.5, 1e-12);
}

TEST_F(BoxOnBalls, KeepsTheLeastMarginAndItsTime) {
  press("ball_3", 10.0);
  at(0.1);
  const double resting = watch.now().tip_energy_margin;
  bench.state.v(4) = 0.5;  // the energy of this turn is missing from the margin
  at(0.2);
  const double turning = watch.now().tip_energy_margin;
  bench.state.v(4) = 0.0;
  at(0.3);
  EXPECT_LT(turning, resting);
  EXPECT_EQ(watch.now().tip_energy_margin, resting);
  EXPECT_EQ(watch.least_margin().value, turning);
  EXPECT_EQ(watch.least_margin().time, 0.2);
}

TEST_F(BoxOnBalls, TellsOfStrutsAtTheirStops) {
  const int probe = bench.equations.layout().body_q[1];
  bench.state.q(probe + 2) += 0.09;
  at(0.1);
  EXPECT_EQ(watch.now().struts_at_stops, 0);
  bench.state.q(probe + 2) += 0.02;
  at(0.2);
  EXPECT_EQ(watch.now().struts_at_stops, 1);
  bench.state.q(probe + 2) -= 0.02;
  at(0.3);
  EXPECT_EQ(watch.now().struts_at_stops, 0);
  ASSERT_EQ(watch.struts_at_stops().size(), 1u);
  EXPECT_EQ(watch.struts_at_stops()[0].time, 0.2);
}

// Gas holds a strut on the stop of its extended end: only a stop that it comes to counts.
TEST(Landing, AStrutThatRestsOnItsStopAtTheStartIsNotAtItsStop) {
  std::string text = box_on_balls();
  text.replace(text.find("stops = { max"), 13, "stops = { min = 0, max");
  Bench bench(text, {"initial.clearance=1"});
  LandingWatch watch(bench.subject());
  const int probe = bench.equations.layout().body_q[1];
  watch.update(bench.take());
  EXPECT_EQ(watch.now().struts_at_stops, 0);
  bench.state.q(probe + 2) += 0.11;
  watch.update(bench.take());
  EXPECT_EQ(watch.now().struts_at_stops, 1);
  bench.state.q(probe + 2) -= 0.12;
  watch.update(bench.take());
  EXPECT_EQ(watch.now().struts_at_stops, 0);
}

// A box that slides to rest: v^2 / (2 mu g). It sinks into its contacts by less than 1 mm, which moves its feet by 1e-3 of the
// way.
TEST(Landing, ARunTellsHowFarItSlid) {
  const SceneText folder;
  const Scene scene = folder.read(box_on_balls(), {"initial.velocity=[0.3,0,0]", "output.vtk=false"});
  const std::string results = test::run_into_folder(scene);
  const nlohmann::ordered_json summary = read_summary(results + "/summary.json");
  const double way = 0.3 * 0.3 / (2.0 * 0.1 * kGravity);
  EXPECT_NEAR(summary["slid_distance_m"].get<double>(), way, 0.02 * way);
  EXPECT_EQ(summary["tipped"], 0);
  EXPECT_EQ(summary["pads_touched"], 4);
  EXPECT_EQ(summary["landing"]["first_contacts"].size(), 4u);
  EXPECT_NEAR(summary["clearance_nozzle_m"].get<double>(), 0.4, 2e-3);
  EXPECT_LT(summary["final_tilt_rad"].get<double>(), 1e-3);
  const History history = read_history(results + "/history.csv");
  EXPECT_NEAR(history.column("landing.slid").back(), way, 0.02 * way);
}

// Without [landing] nothing is computed.
TEST(Landing, IsToldWhereASceneAsksForIt) {
  Bench bench(test::kSmallMachine);
  for (const std::string& name : Observation(bench.subject()).names()) EXPECT_NE(name.rfind("landing.", 0), 0u) << name;
}

TEST(Landing, ExpressionsReadIt) {
  Bench bench(kBox, {"initial.pitch_deg=10"});
  Readings readings({"landing.tilt", "landing.clearance.nozzle"}, bench.subject());
  const Sample& sample = bench.take();
  readings.update(sample);
  EXPECT_NEAR(readings.value(0, sample, bench.inputs.values), 10.0 * kPi / 180.0, 1e-12);
  EXPECT_GT(readings.value(1, sample, bench.inputs.values), 0.4);  // the nozzle turns upwards about the mass centre
}

TEST(Landing, MistakesAreTold) {
  const SceneText text;
  const std::string begin = kBox.substr(0, kBox.find("base = \"box\""));
  EXPECT_TRUE(test::names(text.findings(begin + "base = \"bux\"\n"), {"landing.base", "bux", "E0123"}));
  EXPECT_TRUE(test::names(text.findings(begin + "pads = [\"rock\", \"box\", \"box\"]\n"), {"rock", "E0123", "E0144"}));
  EXPECT_TRUE(test::names(text.findings(kBox, {"ground.kind=\"none\""}), {"landing", "E0142"}));
  EXPECT_TRUE(test::names(text.findings(kBox, {"gravity=[0,0,0]"}), {"landing", "E0142"}));
  for (const std::string pads : {"[\"box\"]", "[\"foot_1\", \"foot_2\"]", "[\"foot_1\", \"foot_4\", \"middle\"]"}) {
    const Scene scene = text.read(kBox, {"landing.pads=" + pads});
    Mechanism mechanism = build_mechanism(scene);
    const std::string told = test::refusal([&] { require_values_at_start(scene, true, mechanism); });
    EXPECT_TRUE(test::names(told, {"landing.pads", "E0671"})) << pads;
  }
}

// ---- runs that end with their landing ----

nlohmann::ordered_json summary_of(const std::string& scene, const std::vector<std::string>& settings) {
  const SceneText folder;
  return read_summary(test::run_into_folder(folder.read(scene, settings)) + "/summary.json");
}

const std::vector<std::string> kFigures = {"peak_acceleration_g", "max_contact_force_N",  "max_descent_m",
                                           "max_sinkage_m",       "stability_distance_m", "tip_energy_margin_J",
                                           "max_tilt_rad",        "pads_touched",         "slid_distance_m"};

std::vector<std::string> with(std::vector<std::string> settings, const std::vector<std::string>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

// What comes after rest changes no figure by more than settling does, 1e-5 of it.
TEST(LandingEnd, ARunThatEndsAtRestHasTheFiguresOfTheWholeOne) {
  const std::vector<std::string> settings = {"initial.velocity=[0.3,0,-0.2]", "end_time=8", "output.vtk=false",
                                             "initial.clearance=0.05"};
  const SceneText folder, other;
  const std::string whole_run = test::run_into_folder(folder.read(box_on_balls(), settings));
  const std::string run =
      test::run_into_folder(other.read(box_on_balls(), with(settings, {"landing.end_at_rest=true"})));
  const auto whole = read_summary(whole_run + "/summary.json"), early = read_summary(run + "/summary.json");
  EXPECT_EQ(early["status"], "done");
  EXPECT_EQ(early["landing"]["ended"], "rest");
  EXPECT_NE(early["reason"].get<std::string>().find("at rest"), std::string::npos);
  EXPECT_LT(early["end_time_s"].get<double>(), 6.0);
  EXPECT_FALSE(whole["landing"].contains("ended"));
  for (const std::string& key : kFigures) {
    const double exact = whole[key].get<double>();
    EXPECT_NEAR(early[key].get<double>(), exact, 1e-5 * std::abs(exact) + 1e-7) << key;
  }
  const History all = read_history(whole_run + "/history.csv"), some = read_history(run + "/history.csv");
  const std::vector<double> times = some.column("time"), height = some.column("box.z");
  EXPECT_DOUBLE_EQ(times.back(), early["end_time_s"].get<double>());
  for (std::size_t row = 0; row < times.size(); ++row) ASSERT_EQ(height[row], all.column("box.z")[row]) << row;
}

TEST(LandingEnd, ARunThatDoesNotComeToRestGoesToItsEndTime) {
  const auto summary = summary_of(
      box_on_balls(), {"end_time=0.2", "output.vtk=false", "landing.end_at_rest=true", "landing.end_when_tipped=true"});
  EXPECT_EQ(summary["landing"]["ended"], "end_time");
  EXPECT_FALSE(summary.contains("reason"));
}

// A box that rolls over two of its balls at more than the speed of tripping; at the top of a slower one, where it stops on two
// balls, it is neither at rest nor tipped.
TEST(LandingEnd, ARunEndsWhenTheLanderHasTipped) {
  const std::vector<std::string> settings = {"ground.plane.friction=5", "output.vtk=false", "landing.end_at_rest=true",
                                             "landing.end_when_tipped=true", "end_time=10"};
  const auto tipped = summary_of(box_on_balls(), with(settings, {"initial.velocity=[3,0,0]"}));
  EXPECT_EQ(tipped["landing"]["ended"], "tipped");
  EXPECT_EQ(tipped["tipped"], 1);
  EXPECT_LT(tipped["end_time_s"].get<double>(), 6.0);
  const auto slower = summary_of(box_on_balls(), with(settings, {"initial.velocity=[1.5,0,0]"}));
  EXPECT_EQ(slower["tipped"], 0);
  EXPECT_NE(slower["landing"]["ended"], "tipped");
  EXPECT_LT(slower["final_tilt_rad"].get<double>(), 0.01);
}

// The end of a window after the one in which it is found; both programs stop there.
TEST(LandingEnd, ARunWithGrainsEndsAfterWholeWindows) {
  const std::string landing = R"(
[landing]
pads = ["a", "b", "c"]
points = [{ name = "a", body = "ball", point = [1, 1, 0] }, { name = "b", body = "ball", point = [1, -1, 0] },
          { name = "c", body = "ball", point = [2, 0, 0] }]
end_when_tipped = true
rest_time = 0.003
)";
  const test::GrainScene on({}, test::kThrownBall + test::kOnGrains + landing);
  test::LoopbackGrains grains(test::start_of_ball(), test::pushes({0.0, 0.0, 0.0}));
  const auto summary = read_summary(test::run_into_folder(on.scene, &grains.transport()) + "/summary.json");
  EXPECT_EQ(grains.join(), "");
  EXPECT_EQ(summary["landing"]["ended"], "tipped");
  EXPECT_NEAR(summary["end_time_s"].get<double>(), 0.003 + 2 * test::kSubsteps * test::kDt,
              1.5 * test::kSubsteps * test::kDt);
  EXPECT_TRUE(grains.motions().back().last_window);
  EXPECT_NEAR(grains.motions().back().time + grains.motions().back().n * test::kDt, summary["end_time_s"].get<double>(),
              1e-12);
}

TEST(LandingEnd, KeysWithoutEffectAreTold) {
  const SceneText text;
  EXPECT_TRUE(test::names(text.findings(kBox, {"landing.rest_speed=0.1"}), {"landing.rest_speed", "end_at_rest"}));
  EXPECT_TRUE(test::names(text.findings(kBox, {"landing.rest_time=0.1"}), {"landing.rest_time", "end_at_rest"}));
  EXPECT_TRUE(test::names(text.findings(kBox, {"landing.rest_time=0", "landing.end_at_rest=true"}), {"rest_time"}));
}

// ---- bodies without boundary on the ground ----

// The box has a shape now, and only the balls a boundary.
std::string solid_box_on_balls() {
  std::string text = box_on_balls();
  const std::string before = "inertia = [1200, 1200, 1200]\nposition = [0, 0, 1.5]\n";
  text.replace(text.find(before), before.size(),
               before + "shape = { kind = \"box\", size = [2, 2, 2], centre = [0, 0, 1.5] }\n");
  return text;
}
const std::string kOnlyBalls = "ground.plane.bodies=[\"ball_1\",\"ball_2\",\"ball_3\",\"ball_4\"]";

TEST(Unheld, ALanderThatTipsOverLiesOnTheGround) {
  const std::vector<std::string> settings = {"ground.plane.friction=5", "output.vtk=false", "end_time=12",
                                             "initial.velocity=[3,0,0]"};
  const SceneText folder, other;
  const std::string held = test::run_into_folder(folder.read(solid_box_on_balls(), settings));
  const std::string falls = test::run_into_folder(other.read(solid_box_on_balls(), with(settings, {kOnlyBalls})));
  const auto lowest = [](const std::string& run) {
    const std::vector<double> heights = read_history(run + "/history.csv").column("box.z");
    return *std::min_element(heights.begin(), heights.end());
  };
  EXPECT_GT(lowest(held), 0.7);  // half its edge, less 5 % of its size and what the contact yields
  EXPECT_LT(lowest(falls), 0.0);
  EXPECT_EQ(read_summary(held + "/summary.json")["tipped"], 1);
  EXPECT_TRUE(test::names(read_summary(held + "/summary.json")["warnings"].dump(), {"W0676", "coarse"}));
}

// They go into the soil with their pads, in landings that stand.
TEST(Unheld, LegsTouchWithTheirPads) {
  const Scene scene = read_scene(FOOTFALL_SOURCE_DIR "/inputs/public_lander", {"ground.kind=soil"});
  const Mechanism mechanism = build_mechanism(scene);
  ASSERT_EQ(mechanism.hulls.size(), 1U);
  EXPECT_EQ(mechanism.model.body(mechanism.hulls[0].body).name(), "body");
}

TEST(Unheld, ALanderThatStandsHasTheSameHistoryToTheLastDigit) {
  const std::vector<std::string> settings = {"output.vtk=false", "end_time=2", "initial.velocity=[0.5,0.1,-0.5]"};
  const std::string soil = "ground.kind=\"soil\"", law = "ground.soil=\"dry-sand\"";
  for (const bool on_soil : {false, true}) {
    const std::vector<std::string> all = on_soil ? with(settings, {soil, law}) : settings;
    const std::string only = on_soil ? "ground.law.bodies=[\"ball_1\",\"ball_2\",\"ball_3\",\"ball_4\"]" : kOnlyBalls;
    const SceneText folder, other;
    const std::string held = test::run_into_folder(folder.read(solid_box_on_balls(), all));
    const std::string alone = test::run_into_folder(other.read(solid_box_on_balls(), with(all, {only})));
    const History a = read_history(held + "/history.csv"), b = read_history(alone + "/history.csv");
    for (const char* column : {"time", "box.z", "box.x", "ball_1.contact.fz", "energy.total"})
      EXPECT_EQ(a.column(column), b.column(column)) << column << (on_soil ? " on soil" : " on the plane");
  }
}

}  // namespace landing
}  // namespace footfall
