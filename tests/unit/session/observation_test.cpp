// What a run observes: columns of the history, summary, start values.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/observe/columns.h"
#include "mbd_solver/session/observe/metrics.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/observe/records.h"
#include "mbd_solver/session/observe/start_values.h"
#include "mbd_solver/session/observe/terrain_patch.h"
#include "tests/support/refused.h"
#include "tests/unit/scene/scene_text.h"
#include "tests/unit/session/small_machine.h"

namespace footfall {
namespace {

// The registry of the columns of history.csv: whole, told to users, and right.

using test::Bench;
using test::kSmallMachine;

// The small machine, as if LIGGGHTS had asked for its leg with `every auto`.
class HistoryColumns : public ::testing::Test {
 protected:
  explicit HistoryColumns(const std::vector<std::string>& settings = {})
      : bench(kSmallMachine, settings), flexible(bench.subject()), joints(bench.subject()) {
    agreement.boundaries = {0};
    coupling.substeps = 7;
    coupling.estimate = 0.01;
    coupling.energy_residual = -0.5;
    coupling.omega_h = {0.3};
    Subject subject{bench.scene, bench.mechanism, bench.equations.layout(), &agreement};
    columns = history_columns(subject, flexible, joints);
  }
  double value(const std::string& name) {
    const Sample& sample = bench.take(1, &coupling);
    flexible.update(sample);
    joints.update(sample);
    for (const Column& column : columns)
      if (column.name == name) return column.value(sample);
    ADD_FAILURE() << "no column " << name;
    return std::nan("");
  }

  Bench bench;
  Agreement agreement;
  CouplingSample coupling;
  FlexibleBodies flexible;
  JointObserver joints;
  std::vector<Column> columns;
};

// Lines of the table in docs/reference/history.md: pattern -> unit, and pattern -> meaning. A line may have several patterns, as in
// `<body>.x`, `.y`: names that begin with a dot continue what is before the last dot of the first.
std::map<std::string, std::pair<std::string, std::string>> documented() {
  std::map<std::string, std::pair<std::string, std::string>> lines;
  std::ifstream page(FOOTFALL_SOURCE_DIR "/docs/reference/history.md");
  EXPECT_TRUE(page) << "docs/reference/history.md";
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    const std::size_t name_end = line.find("` | "), unit_end = line.find(" | ", name_end + 4);
    EXPECT_NE(unit_end, std::string::npos) << line;
    if (unit_end == std::string::npos) continue;
    std::string first;
    for (std::string name : split(line.substr(3, name_end - 3), ',')) {
      name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return c == '`' || c == ' '; }), name.end());
      if (first.empty()) first = name;
      if (name[0] == '.') name = first.substr(0, first.rfind('.')) + name;
      EXPECT_EQ(lines.count(name), 0u) << name << " occurs twice in docs/reference/history.md";
      lines[name] = {line.substr(name_end + 4, unit_end - name_end - 4), line.substr(unit_end + 3)};
    }
  }
  return lines;
}

// Those of a scene whose pattern begins so.
std::vector<Column> columns_of(const std::string& toml, std::initializer_list<std::string> beginnings) {
  const Scene scene = SceneText().read(toml);
  const Mechanism mechanism = build_mechanism(scene);
  const Layout layout(mechanism.model);
  const Subject subject{scene, mechanism, layout, nullptr};
  const FlexibleBodies flexible(subject);
  const JointObserver joints(subject);
  std::optional<LandingWatch> landing;
  if (scene.landing) landing.emplace(subject);
  std::vector<Column> out;
  for (const Column& column : history_columns(subject, flexible, joints, landing ? &*landing : nullptr))
    for (const std::string& beginning : beginnings)
      if (column.pattern.rfind(beginning, 0) == 0) out.push_back(column);
  return out;
}

// Gears hold bodies; they stand in a scene of their own: a pinion and a rack, first by the one and then by the other. So does
// a planar joint, which has coordinates that no other joint has.
std::vector<Column> columns_of_more_joints() {
  return columns_of(R"(end_time = 1.0
bodies = [{ name = "pinion", mass = 1, inertia = [1, 1, 1], position = [0, 0, 0] },
          { name = "rack", mass = 1, inertia = [1, 1, 1], position = [0, 1, 0] },
          { name = "puck", mass = 1, inertia = [1, 1, 1], position = [0, 2, 0] }]
joints = [{ name = "axle", kind = "revolute", bodies = ["ground", "pinion"], point = [0, 0, 0], axis = "z" },
          { name = "guide", kind = "prismatic", bodies = ["ground", "rack"], point = [0, 1, 0], axis = "x" },
          { name = "table", kind = "planar", bodies = ["ground", "puck"], point = [0, 2, 0], axis = "z" }]
gears = [{ name = "mesh", joints = ["axle", "guide"], factors = [1, -2] },
         { name = "again", joints = ["guide", "axle"], factors = [2, -1] }]
)",
                    {"<gear>", "<joint>"});
}

std::vector<Column> columns_of_a_cable() {
  return columns_of(R"(end_time = 1.0
bodies = [{ name = "load", mass = 1, inertia = [1, 1, 1], position = [0, 0, -1] }]
cables = [{ name = "rope", stiffness = 1e3, path = [{ body = "ground", point = [0, 0, 0] }, { body = "load", point = [0, 0, -1] }] }]
)",
                    {"<cable>"});
}

// A plate that lands on three points of itself.
std::vector<Column> columns_of_a_landing() {
  return columns_of(R"(end_time = 1.0
bodies = [{ name = "plate", mass = 1, inertia = [1, 1, 1], position = [0, 0, 1] }]
boundaries = [{ body = "plate", beams = { radius = 0.1, points = [[0, 0, 1], [1, 0, 1]] } }]
[ground]
kind = "plane"
plane = { stiffness = 1e6, damping = 1 }
[landing]
pads = ["a", "b", "c"]
points = [{ name = "a", body = "plate", point = [1, 0, 0] }, { name = "b", body = "plate", point = [0, 1, 0] },
          { name = "c", body = "plate", point = [-1, -1, 0] }]
)",
                    {"landing."});
}

TEST_F(HistoryColumns, HaveANameOfTheirOwnAUnitAndAFiniteValue) {
  const Sample& sample = bench.take(1, &coupling);
  flexible.update(sample);
  joints.update(sample);
  std::set<std::string> names;
  for (const Column& column : columns) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name << " occurs twice";
    EXPECT_EQ(column.name.find_first_of("<>, "), std::string::npos) << column.name;
    EXPECT_FALSE(column.unit.empty()) << column.name;
    EXPECT_TRUE(std::isfinite(column.value(sample))) << column.name;
  }
}

TEST_F(HistoryColumns, OfASceneWithEverythingAreTheWholeRegistry) {
  std::map<std::string, std::string> registry, seen;
  for (const ColumnPattern& entry : column_patterns()) {
    EXPECT_EQ(registry.count(entry.pattern), 0u) << entry.pattern << " occurs twice";
    registry[entry.pattern] = entry.unit;
  }
  for (const Column& column : columns) seen[column.pattern] = column.unit;
  for (const Column& column : columns_of_more_joints()) seen[column.pattern] = column.unit;
  for (const Column& column : columns_of_a_cable()) seen[column.pattern] = column.unit;
  for (const Column& column : columns_of_a_landing()) seen[column.pattern] = column.unit;
  bench.scene.output.modal_forces = true;
  if (!bench.scene.particles) bench.scene.particles.emplace();
  bench.scene.particles->box.emplace().follow = "wheel";
  const Subject coupled{bench.scene, bench.mechanism, bench.equations.layout(), &agreement};
  for (const Column& column : history_columns(coupled, flexible, joints)) seen[column.pattern] = column.unit;
  EXPECT_EQ(registry, seen);
}

TEST_F(HistoryColumns, AreThoseOfThePageForUsers) {
  const auto page = documented();
  std::set<std::string> registry;
  for (const ColumnPattern& entry : column_patterns()) {
    registry.insert(entry.pattern);
    const auto line = page.find(entry.pattern);
    if (line == page.end()) {
      ADD_FAILURE() << "docs/reference/history.md has no line for " << entry.pattern << " [" << entry.unit << "]";
      continue;
    }
    EXPECT_EQ(line->second.first, entry.unit) << entry.pattern << ": unit in docs/reference/history.md";
    EXPECT_GT(line->second.second.size(), 5u) << entry.pattern << ": meaning in docs/reference/history.md";
  }
  for (const auto& line : page)
    EXPECT_EQ(registry.count(line.first), 1u)
        << "docs/reference/history.md tells of " << line.first << ", which is no column";
}

TEST_F(HistoryColumns, EveryKindOfEnergyIsToldToUsers) {
  const auto told = [](const std::string& pattern, const std::vector<std::string>& kinds) {
    const std::string meaning = documented()[pattern].second;
    for (const std::string& kind : kinds) EXPECT_NE(meaning.find("`" + kind + "`"), std::string::npos) << kind;
  };
  told("energy.<form>", names_of<Stored>());
  told("dissipated.<kind>", names_of<Dissipation>());
  told("work.<source>", names_of<Supply>());
}

TEST_F(HistoryColumns, WithoutGrainsNoneSpeaksOfTheCoupling) {
  for (const Column& column : history_columns(bench.subject(), flexible, joints))
    EXPECT_NE(column.name.rfind("coupling.", 0), 0u) << column.name;
}

TEST_F(HistoryColumns, OfFixedWindowsHaveNoEstimate) {
  agreement.substeps = 5;
  const Subject subject{bench.scene, bench.mechanism, bench.equations.layout(), &agreement};
  for (const Column& column : history_columns(subject, flexible, joints)) EXPECT_NE(column.name, "coupling.estimate");
}

TEST_F(HistoryColumns, ShowTheCouplingsSample) {
  EXPECT_EQ(value("coupling.substeps"), 7.0);
  EXPECT_EQ(value("coupling.estimate"), 0.01);
  EXPECT_EQ(value("coupling.energy_error"), -0.5);
  EXPECT_EQ(value("coupling.omega_h.leg"), 0.3);
}

TEST_F(HistoryColumns, ShowPositionVelocityAndFreeFall) {
  const double tolerance = 1e-10;  // of the linear solve behind the accelerations
  EXPECT_DOUBLE_EQ(value("cabin.x"), 0.0);
  EXPECT_DOUBLE_EQ(value("cabin.z"), 1.2);
  EXPECT_DOUBLE_EQ(value("cabin.vx"), 0.1);
  EXPECT_DOUBLE_EQ(value("cabin.vy"), 0.2);
  EXPECT_DOUBLE_EQ(value("cabin.vz"), -1.0);
  EXPECT_NEAR(value("cabin.az"), -1.62, tolerance);
  EXPECT_NEAR(value("leg.az"), -1.62, tolerance);
}

TEST_F(HistoryColumns, ShowTheVoltagesOfTheWindow) {
  bench.inputs.values(0) = 0.625;
  EXPECT_EQ(value("brain.U1"), 0.625);
}

TEST_F(HistoryColumns, ShowSignalsAndStates) {
  bench.state.v(2) = -1.5;  // the cabin sinks onto the leg at 0.5 m/s
  bench.state.time = 0.25;
  EXPECT_NEAR(value("signal.sum"), 0.25 + 2.0 * 0.5, 1e-12);  // round-off
  EXPECT_EQ(value("state.first"), 1.0);
  EXPECT_EQ(value("state.second"), 0.0);
  EXPECT_EQ(value("state.since"), 0.25);
}

// Turned by yaw, pitch and roll, in this order about moving axes.
TEST_F(HistoryColumns, ShowTheAttitudeAsRollPitchYaw) {
  const double roll = 0.3, pitch = -0.7, yaw = 2.1;
  const Eigen::Quaterniond L = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
  bench.state.q.segment<4>(3) << L.w(), L.x(), L.y(), L.z();
  const double round_off = 1e-14;
  EXPECT_NEAR(value("cabin.roll"), roll, round_off);
  EXPECT_NEAR(value("cabin.pitch"), pitch, round_off);
  EXPECT_NEAR(value("cabin.yaw"), yaw, round_off);
}

// The state knows the turn, the attitude the angle within it.
TEST_F(HistoryColumns, ShowAnAngleInTheTurnOfTheState) {
  const int wheel = bench.equations.layout().body_q[2];
  bench.state.q.segment<4>(wheel + 3) << std::cos(0.3), 0.0, std::sin(0.3), 0.0;
  bench.state.angles(0) = 6.0 * kPi + 0.5;
  EXPECT_NEAR(value("axle.angle"), 6.0 * kPi + 0.6, 1e-13);  // round-off
  EXPECT_TRUE(joints.warnings().empty());
}

TEST_F(HistoryColumns, TellWhereTurnsCannotBeCounted) {
  bench.state.uncertain_angle = 0;
  for (int i = 0; i < 2; ++i) value("axle.angle");
  ASSERT_EQ(joints.warnings().size(), 1u);
  EXPECT_TRUE(test::names(joints.warnings()[0], {"axle", "W1665"}));
}

TEST_F(HistoryColumns, ShowWhereASlideIs) {
  EXPECT_DOUBLE_EQ(value("slide.displacement"), 0.0);
  bench.state.v(2) = -1.5;                                    // the cabin sinks onto the leg at 0.5 m/s
  EXPECT_NEAR(value("slide.displacement_rate"), 0.5, 1e-12);  // round-off
}

class DrivenColumns : public HistoryColumns {
 protected:
  DrivenColumns() : HistoryColumns({"drives.pusher.command.polynomial=[3]"}) {}
};

// The drive pushes the leg down along the slide's axis by 3 N, at 0.5 m/s.
TEST_F(DrivenColumns, ShowWhatADriveDoes) {
  bench.state.v(2) = -1.5;
  EXPECT_NEAR(value("pusher.joint_force"), 3.0, 1e-12);  // round-off
  EXPECT_NEAR(value("pusher.power"), 1.5, 1e-12);
  EXPECT_EQ(value("spinner.joint_torque"), 0.0);
}

// The axle alone moves the wheel: its force is mass times acceleration beyond gravity's.
TEST_F(HistoryColumns, ShowReactions) {
  bench.state.v(2) = -1.5;        // the strut between cabin and leg is pushed together
  const double tolerance = 1e-9;  // of the linear solve, of forces of some N
  EXPECT_GT(std::abs(value("axle.fz")), 0.1);
  EXPECT_NEAR(value("axle.fx"), 2.0 * value("wheel.ax"), tolerance);
  EXPECT_NEAR(value("axle.fz"), 2.0 * (value("wheel.az") + 1.62), tolerance);
  EXPECT_NEAR(value("axle.my"), 0.0, tolerance);  // it turns freely
}

// The strut's rate is the derivative of its stroke; its force is the sum of its laws'.
TEST_F(HistoryColumns, ShowTheStrutsStrokeRateAndForce) {
  bench.inputs.values(0) = 0.5;
  bench.state.v(2) = -1.5;  // the cabin sinks onto the leg at 0.5 m/s
  const double before = value("damper.stroke"), rate = value("damper.rate");
  const double h = 1e-6;  // [s]
  bench.state.q(2) += -1.5 * h;
  const int leg = bench.equations.layout().body_q[1];
  bench.state.q(leg + 2) += -1.0 * h;
  const double difference = 1e-9;  // round-off of positions of 1 m over h, and the curvature of the way
  EXPECT_NEAR(rate, 0.5, difference);
  EXPECT_NEAR((value("damper.stroke") - before) / h, rate, 1e3 * difference);
  // U F_y tanh(v / v_s) + c v = 10 N + 8 N s/m 0.5 m/s, tanh(25) = 1
  EXPECT_NEAR(value("damper.force"), 14.0, 1e-8);
}

TEST_F(HistoryColumns, TotalEnergyIsTheSumOfItsParts) {
  double sum = 0.0;
  for (const char* part : {"kinetic", "gravity", "strain", "gas", "contact"})
    sum += value(std::string("energy.") + part);
  EXPECT_DOUBLE_EQ(value("energy.total"), sum);
  EXPECT_GT(value("energy.kinetic"), 0.5 * 10.0);  // of the cabin alone at 1 m/s
}

// Landings on grounds of different heights start with the same energy: sum of m g (z - height of the ground).
TEST(GravityEnergy, CountsFromTheHeightOfTheGround) {
  const auto gravity_energy = [](const std::string& height) {
    Bench bench(kSmallMachine, {"ground.plane.point=[0,0," + height + "]"});
    double by_hand = 0.0;
    for (int i = 0; i < bench.mechanism.model.body_count(); ++i)
      by_hand +=
          1.62 * bench.mechanism.model.body(i).mass() * (bench.take().kinematics.of(i).r.z() - std::stod(height));
    EXPECT_NEAR(bench.take().energy.stored[Stored::kGravity], by_hand, 1e-12 * by_hand);  // round-off
    return bench.take().energy.stored[Stored::kGravity] - by_hand;
  };
  gravity_energy("0");
  gravity_energy("-0.82");
}

// On request each mode of a flexible body shows the mean load of the grains.
class ModalForceColumns : public HistoryColumns {
 protected:
  ModalForceColumns() : HistoryColumns({"output.modal_forces=true"}) {}
};
TEST_F(ModalForceColumns, ShowTheLoadOfEachMode) {
  EXPECT_EQ(value("leg.contact.mode_2"), 0.0);
  bench.inputs.loads.resize(bench.scene.bodies.size());
  bench.inputs.loads[1].Q_a = Eigen::Vector3d(1.0, -2.0, 3.0);
  EXPECT_EQ(value("leg.contact.mode_1"), 1.0);
  EXPECT_EQ(value("leg.contact.mode_2"), -2.0);
  EXPECT_EQ(value("leg.contact.mode_3"), 3.0);
}

// A leg pushed into the plane is pushed out.
TEST_F(HistoryColumns, ShowTheForceOfThePlane) {
  EXPECT_EQ(value("leg.contact.fz"), 0.0);
  const int leg = bench.equations.layout().body_q[1];
  bench.state.q(leg + 2) -= 0.101;
  EXPECT_GT(value("leg.contact.fz"), 1.0);
  EXPECT_EQ(value("leg.contact.fz"), bench.take().contact[1].F_W.z());
}

TEST(Observation, RowHoldsAValueForEveryNameAndUnit) {
  Bench bench(kSmallMachine);
  Observation observation(bench.subject());
  const std::vector<double>& row = observation.row(bench.take());
  EXPECT_EQ(row.size(), observation.names().size());
  EXPECT_EQ(row.size(), observation.units().size());
  EXPECT_EQ(observation.names().front(), "time");
  EXPECT_EQ(row.front(), 0.0);
}

TEST(Observation, LeavesOutBodiesThatTheSceneDoesNotRecord) {
  Bench bench(kSmallMachine, {"output.bodies=[\"leg\"]"});
  for (const std::string& name : Observation(bench.subject()).names()) EXPECT_NE(name.rfind("cabin.", 0), 0u) << name;
}

using ::testing::HasSubstr;

const std::string kBall = R"(end_time = 1
[[bodies]]
name = "ball"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 3]
)";
const std::string kStates = "[[states]]\nname = \"up\"\n[[states]]\nname = \"down\"\n";

std::string sampled(const std::string& input, const std::string& more = "") {
  return "[[signals]]\nname = \"s\"\nkind = \"expression\"\nperiod_ms = 10\ninput = \"" + input + "\"\n" + more;
}
std::string event(const std::string& name, const std::string& when, const std::string& more = "") {
  return "[[events]]\nname = \"" + name + "\"\nto = \"down\"\nwhen = \"" + when + "\"\n" + more;
}

std::string complaint_at_start(const std::string& toml, bool is_placed = true) {
  const SceneText text;
  const Scene scene = text.read(toml);
  Mechanism mechanism = build_mechanism(scene);
  return test::refusal([&] { require_values_at_start(scene, is_placed, mechanism); });
}

TEST(StartValues, OfPlacesAccelerationsAndForcesAreThoseOfTheRun) {
  EXPECT_EQ(complaint_at_start(kBall + sampled("sqrt(-9 - ball.az)")), "");  // it falls
  EXPECT_THAT(complaint_at_start(kBall + sampled("sqrt(-10 - ball.az)")), HasSubstr("signals.s.input"));
  EXPECT_THAT(complaint_at_start(kBall + kStates + event("e", "1 / work.contact")), HasSubstr("events.e.when"));
}

TEST(StartValues, NamesThatNothingHasAreToldTogether) {
  const std::string told =
      complaint_at_start(kBall + kStates + sampled("ball.q + bal.z") + event("e", "ball.q > 1"), false);
  EXPECT_THAT(told, HasSubstr("signals.s.input"));
  EXPECT_THAT(told, HasSubstr("signals.s.input"));
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << told;
}

TEST(StartValues, AreLeftToTheRunWhereItAloneKnowsThem) {
  const std::string root = sampled("sqrt(ball.z - 4)");
  EXPECT_NE(complaint_at_start(kBall + root), "");
  EXPECT_EQ(complaint_at_start(kBall + root, false), "");
  EXPECT_NE(complaint_at_start(kBall + sampled("sqrt(time - 4)"), false), "");
}

// What the first state does not look at, or ends at once, is no mistake.
TEST(StartValues, CountInTheStateOfTheStart) {
  const std::string root = "sqrt(ball.z - 4)";
  EXPECT_EQ(complaint_at_start(kBall + kStates + sampled(root, "states = [\"down\"]\n") + event("e", "time > 1")), "");
  const std::string up = sampled(root, "states = [\"up\"]\n");
  EXPECT_THAT(complaint_at_start(kBall + kStates + up + event("e", "time > 1")), HasSubstr("signals.s.input"));
  EXPECT_EQ(complaint_at_start(kBall + kStates + up + event("e", "ball.z > 1")), "");
  EXPECT_EQ(complaint_at_start(kBall + kStates + event("a", "ball.z > 1") + event("b", root)), "");
  EXPECT_THAT(complaint_at_start(kBall + kStates + event("b", root) + event("a", "ball.z > 1")),
              HasSubstr("events.b.when"));
}

// Peaks of a run for its summary, from samples made by hand.

TEST(MetricRecorder, ObservesTheHeaviestBody) {
  Bench bench(kSmallMachine);
  EXPECT_EQ(MetricRecorder(bench.subject()).body_name(), "cabin");
}

TEST(MetricRecorder, KeepsTheDeepestDescentNotTheLast) {
  Bench bench(kSmallMachine);
  MetricRecorder taker(bench.subject());
  const double start = bench.state.q(2);
  for (const double way : {0.0, 0.25, 0.5, 0.125}) {
    bench.state.q(2) = start - way;
    taker.update(bench.take());
  }
  EXPECT_DOUBLE_EQ(taker.metrics().max_descent.value, 0.5);
}

// Against gravity, wherever that points.
TEST(MetricRecorder, MeasuresDescentAgainstGravity) {
  Bench bench(kSmallMachine, {"gravity=[-1.62,0,0]"});
  MetricRecorder taker(bench.subject());
  taker.update(bench.take());
  bench.state.q(0) -= 0.5;
  bench.state.q(2) -= 3.0;
  taker.update(bench.take());
  EXPECT_DOUBLE_EQ(taker.metrics().max_descent.value, 0.5);
}

// Of the beam's surface, 0.02 m from its line, and the same that the contact force counts with.
TEST(MetricRecorder, PenetrationIsThatOfTheContactOnThePlane) {
  for (const char* normal : {"[0,0,1]", "[0,-0.6,0.8]"}) {
    Bench bench(kSmallMachine, {"initial.clearance=0", std::string("ground.plane.normal=") + normal});
    MetricRecorder taker(bench.subject());
    taker.update(bench.take());
    EXPECT_NEAR(taker.metrics().max_penetration.value, 0.0, 1e-15);  // round-off of lengths below 1 m
    const int leg = bench.equations.layout().body_q[1];
    bench.state.q(leg + 2) -= 0.03;
    const Sample& sample = bench.take();
    taker.update(sample);
    const Handle<ContactElement> plane = bench.mechanism.contacts[0].force;
    const double overlap =
        plane.of(bench.mechanism.model).largest_overlap(element_input(bench.subject(), sample, plane.index()));
    EXPECT_NEAR(taker.metrics().max_penetration.value, overlap, 1e-15);
    EXPECT_NEAR(overlap, 0.03 * bench.scene.ground.plane->normal.z(), 1e-15);
  }
}

// A bed that is cut to a slope of 12 degrees, 2 m from its origin: the depth counts from the slope below the ball, along the normal
// of the slope; a rock on it does not sink. The wave of 1 um makes the slope an uneven field. The mesh of the ball lies within
// 0.4 mm of the sphere.
TEST(MetricRecorder, DepthInGrainsCountsFromTheSlopeBelowTheBody) {
  constexpr double kDepth = 0.03, kSlope = 12.0 * kPi / 180.0;
  for (const char* more :
       {"", ", rocks = [{ x = -2.5, y = 0, diameter = 0.1 }] }\nplane = { stiffness = 1e6, damping = 1",
        ", waves = [{ length = 3, height = 1e-6 }]"}) {
    SCOPED_TRACE(more);
    Bench bench(std::string(R"(end_time = 1
gravity = [0, 0, -9.81]
bodies = [{ name = "ball", mass = 1, shape = { kind = "sphere", centre = [2, 0, 1], radius = 0.05 } }]
boundaries = [{ body = "ball", surface = { element_size = 0.01 } }]
[ground]
kind = "particles"
terrain = { slope_deg = 12, position = [0, 0, 0.5])") +
                more + R"( }
[particles.box]
size = [6, 0.4]
depth = 0.1
radius = 0.02
)");
    MetricRecorder taker(bench.subject());
    bench.state.q.segment<3>(0) << 2.0, 0.0, 0.5 - 2.0 * std::tan(kSlope) + (0.05 - kDepth) / std::cos(kSlope);
    taker.update(bench.take());
    EXPECT_NEAR(taker.metrics().max_penetration.value, kDepth, 4e-4);
  }
}

TEST(MetricRecorder, ReferenceEnergyIsThatOfTheStartOrTheLargestKinetic) {
  Bench bench(kSmallMachine);
  MetricRecorder taker(bench.subject());
  const double start = bench.take().energy.stored[Stored::kKinetic];
  taker.update(bench.take());
  EXPECT_DOUBLE_EQ(taker.metrics().reference_energy, start);
  bench.state.v *= 0.5;
  taker.update(bench.take());
  EXPECT_DOUBLE_EQ(taker.metrics().reference_energy, start);
  bench.state.v *= 4.0;
  taker.update(bench.take());
  EXPECT_NEAR(taker.metrics().reference_energy, 4.0 * start, 1e-12 * start);
}

// Energy that appears from nowhere is told; energy that was dissipated, or came from grains or motions, is not. Both
// bodies have one velocity at the start: seen from there they have no kinetic energy, and a quarter of E when they have
// half of it.
TEST(MetricRecorder, WarnsOfEnergyThatDoesNotClose) {
  Bench bench(kSmallMachine);
  MetricRecorder taker(bench.subject());
  taker.update(bench.take());
  const double E = taker.metrics().reference_energy;
  bench.state.v *= 0.5;
  bench.state.dissipated[Dissipation::kStop] = E;  // of which a quarter is left
  bench.state.supplied[Supply::kMotion] = 0.25 * E;
  taker.update(bench.take());
  EXPECT_LT(taker.metrics().energy_balance_relative(), 1e-12);
  EXPECT_EQ(taker.balance_warning(), "");
  bench.state.dissipated[Dissipation::kStop] = 0.98 * E;
  taker.update(bench.take());
  // What flowed: to K' 0.25 E, to stops E and 0.02 E back, from the motion 0.25 E; half of the sum.
  EXPECT_NEAR(taker.metrics().energy_flow, 0.76 * E, 1e-12 * E);
  EXPECT_NEAR(taker.metrics().energy_balance_relative(), 0.02 / 0.76, 1e-12);
  EXPECT_NE(taker.balance_warning(), "");
}

TEST(MetricRecorder, KeepsTheLargestForceOnABodyAndTellsThePresentOneOnAll) {
  Bench bench(kSmallMachine);
  MetricRecorder taker(bench.subject());
  bench.inputs.loads.resize(bench.scene.bodies.size());
  for (const double force : {40.0, 30.0}) {
    bench.inputs.loads[0].F_W = Eigen::Vector3d(0, 0, force);
    taker.update(bench.take());
  }
  EXPECT_DOUBLE_EQ(taker.metrics().max_contact_force.value, 40.0);
  EXPECT_DOUBLE_EQ(taker.metrics().contact_force, 30.0);
}

// The rigid motion of a surface's nodes.

TEST(FitRigid, FindsTheMotionOfARigidSurface) {
  const Eigen::Matrix3Xd x0 = Eigen::Matrix3Xd::Random(3, 40);
  for (const double angle : {0.0, 1e-6, 0.4, 3.0}) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    const Eigen::Vector3d shift(0.3, -4.0, 2.0);
    const RigidFit fit = fit_rigid(x0, (R * x0).colwise() + shift);
    EXPECT_LT((fit.R - R).norm(), 1e-14);
    EXPECT_LT((fit.centre - (R * x0.rowwise().mean() + shift)).norm(), 1e-14);
    EXPECT_LT(fit.residual, 1e-14);
  }
}

// A plate: all points in one plane, where a reflection would fit as well.
TEST(FitRigid, TurnsAPlateOverInsteadOfReflectingIt) {
  Eigen::Matrix3Xd x0 = Eigen::Matrix3Xd::Random(3, 30);
  x0.row(2).setZero();
  const Eigen::Matrix3d R = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  const RigidFit fit = fit_rigid(x0, R * x0);
  EXPECT_NEAR(fit.R.determinant(), 1.0, 1e-14);
  EXPECT_LT((fit.R - R).norm(), 1e-13);
}

// Bent symmetrically, a plate has not turned; what is left over is the bending about its mean.
TEST(FitRigid, LeavesTheBendingOver) {
  Eigen::Matrix3Xd x0(3, 3), x(3, 3);
  x0 << -1, 0, 1, 0, 0, 0, 0, 0, 0;
  x = x0;
  x(2, 0) = x(2, 2) = 0.03;
  const RigidFit fit = fit_rigid(x0, x);
  EXPECT_LT((fit.R * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitX()).norm(), 1e-14);
  EXPECT_NEAR(fit.residual, 0.02, 1e-15);
  EXPECT_NEAR(fit.centre.z(), 0.02, 1e-15);
}

// A bed is drawn from end to end, by the heights of its terrain in 0.1 mm, a tilted plane too; its rocks are bodies.
TEST(TerrainPatch, OfABedIsItsSurface) {
  const Scene scene = SceneText().read(R"(end_time = 1
gravity = [0, 0, -9.81]
bodies = [{ name = "ball", mass = 1, shape = { kind = "sphere", centre = [0, 0, 1], radius = 0.05 } }]
boundaries = [{ body = "ball", surface = {} }]
[ground]
kind = "particles"
terrain = { slope_deg = 12, position = [0, 0, 0.5] }
[particles.box]
size = [0.6, 0.4]
centre = [0.1, 0]
depth = 0.1
radius = 0.01
)");
  const auto patch = nlohmann::json::parse(terrain_text(scene, build_mechanism(scene)));
  const double x = patch["first"][0], y = patch["first"][1], dx = patch["step"][0], dy = patch["step"][1];
  const int columns = patch["counts"][0], rows = patch["counts"][1];
  EXPECT_NEAR(x, -0.2, 1e-12);
  EXPECT_NEAR(y, -0.2, 1e-12);
  EXPECT_NEAR(x + (columns - 1) * dx, 0.4, 1e-12);
  EXPECT_NEAR(y + (rows - 1) * dy, 0.2, 1e-12);
  for (int i = 0; i < columns; ++i)
    EXPECT_NEAR(patch["heights"][i].get<double>(), 0.5 - std::tan(12.0 * kPi / 180.0) * (x + i * dx), 0.51e-4);
  EXPECT_TRUE(patch["rocks"].empty());
}

}  // namespace
}  // namespace footfall
