// Rows at multiples of their interval, peaks of all steps between them, and events that chatter.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/peaks.h"
#include "mbd_solver/session/output/summary.h"
#include "tests/support/refused.h"
#include "tests/unit/session/recorded.h"

namespace footfall {
namespace {

using test::run_into_folder;

// x = v / w sin w t, w = sqrt(k / m): 100 periods of 2 ms, a row per 70 ms.
const std::string kFastOscillator = R"(end_time = 0.2
gravity = [0, 0, 0]
[[bodies]]
name = "b"
mass = 1.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 0]
[[joints]]
name = "slide"
kind = "prismatic"
bodies = ["ground", "b"]
point = [0, 0, 0]
axis = "x"
displacement = { spring = { stiffness = 1e7, damping = 0 } }
[initial]
velocity = [1, 0, 0]
[output]
interval = 0.07
)";

// Steps of this tolerance take a period in more than 20: the nearest of steps and their middles is within 1/80 of a period of
// the peak, which then lacks 1 - cos(2 pi / 80) = 0.3 %.
TEST(PeaksOfARun, BelongToItsStepsNotToItsRows) {
  const SceneText folder;
  for (const char* integrator : {"one_step", "ida"}) {
    const Scene scene = folder.read(kFastOscillator, {std::string("solver.integrator=") + integrator});
    const std::string out = run_into_folder(scene);
    const double w = std::sqrt(1e7), a = w;  // [rad/s], [m/s2]
    const nlohmann::ordered_json summary = read_summary(out + "/summary.json");
    EXPECT_NEAR(summary["peak_acceleration_g"].get<double>() * 9.80665, a, 0.003 * a) << integrator;
    const double time = summary["peak_acceleration_time_s"];
    EXPECT_GT(std::abs(std::sin(w * time)), 0.99) << integrator;

    bool found = false;
    for (const ColumnPeaks& column : read_peaks(out + "/peaks.csv")) {
      if (column.name != "b.ax") continue;
      found = true;
      EXPECT_EQ(column.unit, "m/s2");
      EXPECT_NEAR(column.largest, a, 0.003 * a);
      EXPECT_NEAR(column.least, -a, 0.003 * a);
      EXPECT_LT(std::sin(w * column.largest_time), -0.99);
      EXPECT_GT(std::sin(w * column.least_time), 0.99);
    }
    EXPECT_TRUE(found);
  }
}

// With grains: windows of 0.4 ms that fit no row. Between them a ball falls under a constant force.
TEST(RowsOfARun, AreAtMultiplesOfTheirIntervalWithinWindows) {
  // The force has a corner between two windows.
  const test::GrainScene on({"initial.velocity=[0,0,-1.0]"}, test::kThrownBall + R"([[forces]]
name = "corner"
body = "ball"
direction = [0, 0, 1]
force = { table = [[0, 0], [0.003, 0], [0.0031, 0]] }
)" + test::kOnGrains);
  test::LoopbackGrains grains(test::start_of_ball(), test::pushes({0.0, 0.0, 5.0}));
  const std::string out = run_into_folder(on.scene, &grains.transport());
  EXPECT_EQ(grains.join(), "");
  const History history = read_history(out + "/history.csv");
  const std::vector<double>&time = history.column("time"), &z = history.column("ball.z");
  ASSERT_EQ(time.size(), 14u);  // 0 to 12 ms, and the end
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double t = i < 13 ? 1e-3 * static_cast<double>(i) : 0.0123;
    EXPECT_NEAR(time[i], t, 1e-12);
    EXPECT_NEAR(z[i], 3.0 - t + 0.5 * (5.0 / 2.0 - 1.5) * t * t, 1e-9);  // digits of the file
  }
}

// A blow between two rows bends a rod on grains: its stress is in peaks.csv as with a row per window.
TEST(PeaksOfARun, OnGrainsAreThoseOfEveryWindow) {
  const auto largest = [](const std::string& interval) {
    const SceneText folder;
    folder.write(
        "in.grains",
        "timestep 1e-4\nfix m all mesh/surface file m.stl type 1\nfix mbd all couple/mbd every 4 mesh m rod\nrun 1\n");
    const Scene scene = folder.read(R"(end_time = 0.04
gravity = [0, 0, -1.5]
[materials.steel]
density = 7850
young_GPa = 207
[[bodies]]
name = "rod"
material = "steel"
shape = { kind = "rod", from = [-0.5, 0, 3], to = [0.5, 0, 3], diameter = 0.02 }
flexible = { modes = 4, elements = 6, damping = 0.05 }
[[boundaries]]
body = "rod"
[boundaries.beams]
radius = 0.01
[ground]
kind = "particles"
[particles]
script = "in.grains"
)",
                                    {"output.interval=" + interval, "coupling.stop_on_energy_gain=false"});
    Start start;
    start.dt = 1e-4;
    start.n = 4;
    start.bodies = {"rod"};
    test::LoopbackGrains grains(start, [](const Motion& motion, Load& load) {
      MeanLoad& mean = load.bodies[0].mean;
      if (motion.window == 30) mean.Q_a.setConstant(50.0);
    });
    const std::string out = run_into_folder(scene, &grains.transport());
    EXPECT_EQ(grains.join(), "");
    double stress = 0.0;
    for (const ColumnPeaks& column : read_peaks(out + "/peaks.csv"))
      if (column.name == "rod.von_mises") stress = column.largest;
    EXPECT_GT(stress, 0.0);
    return stress;
  };
  const double rows = largest("0.0004"), seldom = largest("0.04");
  EXPECT_NEAR(seldom, rows, 1e-6 * rows);  // digits of the file
}

// A body driven to rest by two states, each of which reverses the force when the velocity has changed its sign: no motion of
// finite steps is possible. The message names both events and their rate.
TEST(EventsThatChatter, EndTheRunWithTheirNames) {
  const Scene scene = SceneText().read(R"(end_time = 2.0
gravity = [0, 0, 0]
[[bodies]]
name = "b"
mass = 1.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 0]
[[states]]
name = "forward"
[[states]]
name = "backward"
[[events]]
name = "turned_back"
when = "b.vx < 0"
to = "backward"
from = ["forward"]
[[events]]
name = "turned_forth"
when = "b.vx > 0"
to = "forward"
from = ["backward"]
[[signals]]
name = "push"
kind = "expression"
input = "state.backward * 2 - state.forward * 2 + 1"
[[forces]]
name = "f"
body = "b"
direction = [1, 0, 0]
force = { signal = "push" }
[initial]
velocity = [1, 0, 0]
)");
  Simulation simulation(scene, scene.end_time, nullptr);
  const std::string error = test::error_of<NumericalError>([&] { simulation.run([](const Sample&) {}, test::kNever); });
  EXPECT_TRUE(test::names(error, {code::kEventChatter.number, "turned_back", "turned_forth"})) << error;
  EXPECT_NEAR(simulation.state().time, 1.0, 1e-6);  // where the velocity first vanishes
}

// A pendulum switched every half period is none.
TEST(EventsThatChatter, AreNotThoseOfALongRun) {
  EventWatch watch;
  for (int i = 0; i < 100000; ++i) EXPECT_NO_THROW(watch.count(i % 2 == 0 ? "a" : "b", 1e-4 * i, 1e5));
}

// The condition holds for 0.2 ms between two rows: it is seen at the steps.
TEST(Simulation, SeesAnEventBetweenRows) {
  const Scene scene = SceneText().read(kFastOscillator + R"([[states]]
name = "slow"
[[states]]
name = "fast"
[[events]]
name = "far"
when = "b.x > 3e-4"
to = "fast"
)");
  Simulation simulation(scene, scene.end_time, nullptr);
  double since = 0.0;
  simulation.run([&](const Sample& sample) { since = sample.values[simulation.mechanism().state_since]; },
                 test::kNever);
  const double w = std::sqrt(1e7);
  EXPECT_NEAR(since, std::asin(3e-4 * w) / w, 1e-8);  // in the first quarter of a period; by solver.rtol
}

}  // namespace
}  // namespace footfall
