// The loop of a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "mbd_solver/coupling/codes.h"
#include "mbd_solver/session/checkpoint.h"
#include "mbd_solver/session/output/summary.h"
#include "tests/support/refused.h"
#include "tests/unit/session/recorded.h"

namespace footfall {
namespace {

// The loop: windows with and without grains, on one ball whose motion is known.

using test::GrainScene;
using test::kDt;
using test::kSubsteps;
using test::kThrownBall;
using test::LoopbackGrains;
using test::pushes;

constexpr double kMass = 2.0, kGravity = 1.5, kEnd = 0.0123;  // [kg], [m/s2], [s]: no multiple of a window
// What one sees of a sample of the ball.
struct Row {
  double time, x, z, vx, vz;
  long window;
  bool last;
};
Row row_of(const Sample& s) {
  const BodyKinematics& ball = s.kinematics.of(0);
  return {s.state.time, ball.r.x(), ball.r.z(), ball.dr.x(), ball.dr.z(), s.window, s.last};
}
std::vector<Row> rows_of(Simulation& simulation) {
  std::vector<Row> rows;
  simulation.run([&rows](const Sample& s) { rows.push_back(row_of(s)); }, test::kNever);
  return rows;
}

constexpr double kRoundOff = 1e-12;  // constant forces: the one-step method is exact

// Fixed steps: no window chooses between the orders, and what is not said is the fifth, as in windows of many steps.
TEST(Simulation, StepsOfAFixedLengthGoByTheFifthOrder) {
  const auto end = [](const std::string& method) {
    const SceneText folder;
    const Scene scene =
        folder.read(kPendulum, {"solver.error_control=false", "solver.max_step=0.01", "solver.method=" + method});
    Simulation simulation(scene, scene.end_time, nullptr);
    simulation.run([](const Sample&) {}, test::kNever);
    return simulation.state().q;
  };
  EXPECT_EQ(end("auto"), end("esdirk5"));
  EXPECT_NE(end("auto"), end("esdirk3"));
}

// Turns are counted from step to step, however far apart the rows are: a wheel of 0.1 kg m2 under 4 N m turns by 20 t^2, and a
// pendulum whose rate changes its sign between two rows has the angle that close rows show.
TEST(Simulation, CountsTurnsBetweenRows) {
  const auto angle = [](const std::string& what, double interval, const std::string& integrator) {
    const SceneText folder;
    const Scene scene = folder.read(
        "end_time = 2.7\ngravity = [0, 0, -9.81]\nbodies = [{ name = \"b\", mass = 1.0, inertia = [0.1, 0.1, 0.1], "
        "position "
        "= [0, 0, " +
            std::string(what == "wheel" ? "0" : "-1") +
            "] }]\njoints = [{ name = \"j\", kind = \"revolute\", bodies = [\"ground\", \"b\"], point = [0, 0, 0], "
            "axis = \"y\" }]\n" +
            (what == "wheel" ? "forces = [{ name = \"f\", body = \"b\", direction = [0, 1, 0], torque = { polynomial = "
                               "[4.0] } }]\n"
                             : "[initial]\njoints = { j = 1.0 }\n"),
        {"output.interval=" + std::to_string(interval), "solver.rtol=1e-8", "solver.max_step=1",
         "solver.integrator=" + integrator});
    test::Record record(scene);
    record.run();
    EXPECT_TRUE(record.observation.joints().warnings().empty());
    return record.last("j.angle");
  };
  const double tolerance = 1e-5;  // rtol over some hundred steps, of 146 rad
  for (const char* integrator : {"one_step", "ida"}) {
    EXPECT_NEAR(angle("wheel", 2.7, integrator), 20.0 * 2.7 * 2.7, tolerance) << integrator;
    EXPECT_NEAR(angle("pendulum", 2.7, integrator), angle("pendulum", 0.01, integrator), tolerance) << integrator;
  }
}

TEST(Simulation, OfAFreeBodyIsTheParabola) {
  const Scene scene = SceneText().read(kThrownBall);
  Simulation simulation(scene, scene.end_time, nullptr);
  for (const Row& row : rows_of(simulation)) {
    EXPECT_NEAR(row.x, 0.5 * row.time, kRoundOff);
    EXPECT_NEAR(row.z, 3.0 - row.time - 0.5 * kGravity * row.time * row.time, kRoundOff);
    EXPECT_NEAR(row.vz, -1.0 - kGravity * row.time, kRoundOff);
  }
  EXPECT_TRUE(simulation.finished());
}

TEST(Simulation, ObservesTheStartEveryRowAndTheEndOnce) {
  const Scene scene = SceneText().read(kThrownBall);
  Simulation simulation(scene, scene.end_time, nullptr);
  const std::vector<Row> rows = rows_of(simulation);
  ASSERT_EQ(rows.size(), 14u);  // 0, 1, ... 12 ms, and 12.3 ms
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].window, static_cast<long>(k));
    EXPECT_EQ(rows[k].last, k + 1 == rows.size());
    EXPECT_NEAR(rows[k].time, std::min(1e-3 * static_cast<double>(k), kEnd), kRoundOff);
  }
  EXPECT_EQ(rows.back().time, kEnd);
}

TEST(Simulation, StopsForTheSamplesOfControllers) {
  const std::string controller = R"(
[[controllers]]
name = "hold"
kind = "pid"
body = "ball"
outputs = ["U1"]
period_ms = 0.4
)";
  const Scene scene = SceneText().read(kThrownBall + controller);
  Simulation simulation(scene, 2e-3, nullptr);
  std::vector<double> times;
  for (const Row& row : rows_of(simulation)) times.push_back(row.time);
  const std::vector<double> expected = {0.0, 0.4e-3, 0.8e-3, 1.0e-3, 1.2e-3, 1.6e-3, 2.0e-3};
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(times[k], expected[k], kRoundOff);
}

TEST(Simulation, ThatIsInterruptedEndsWithItsWindow) {
  const Scene scene = SceneText().read(kThrownBall);
  Simulation simulation(scene, scene.end_time, nullptr);
  volatile std::sig_atomic_t interrupted = 0;
  long windows = 0;
  simulation.run(
      [&](const Sample& sample) {
        windows = sample.window;
        if (sample.window == 3) interrupted = 1;
      },
      interrupted);
  EXPECT_EQ(windows, 3);
  EXPECT_FALSE(simulation.finished());
}

// Nothing of the coupling: not constructed, not sent, not sampled, not written.
TEST(Simulation, WithoutGrainsMakesNothingOfTheCoupling) {
  const Scene scene = SceneText().read(kThrownBall);
  Simulation simulation(scene, scene.end_time, nullptr);
  EXPECT_EQ(simulation.coupled(), nullptr);
  EXPECT_EQ(simulation.subject().agreement, nullptr);
  simulation.run(
      [](const Sample& sample) {
        EXPECT_EQ(sample.coupling, nullptr);
        EXPECT_TRUE(sample.inputs.loads.empty());
      },
      test::kNever);
  for (const std::string& name : Observation(simulation.subject()).names())
    EXPECT_NE(name.rfind("coupling.", 0), 0u) << name;
}

TEST(Simulation, WithGrainsGainsTheImpulseThatTheyGive) {
  const GrainScene on;
  const Eigen::Vector3d F(3.0, 0.0, 20.0);  // [N]
  LoopbackGrains grains(test::start_of_ball(), pushes(F));
  Simulation simulation(on.scene, on.scene.end_time, &grains.transport());
  const std::vector<Row> rows = rows_of(simulation);
  EXPECT_EQ(grains.join(), "");
  const Row& end = rows.back();
  EXPECT_EQ(end.time, kEnd);
  EXPECT_NEAR(kMass * (end.vx - 0.5), F.x() * kEnd, kRoundOff);
  EXPECT_NEAR(kMass * (end.vz + 1.0), (F.z() - kMass * kGravity) * kEnd, kRoundOff);
}

// A constant load is a change of gravity: two routes to one motion.
TEST(Simulation, WithGrainsThatPushForEverFallsAsInOtherGravity) {
  const GrainScene on;
  LoopbackGrains grains(test::start_of_ball(), pushes({0.0, 0.0, 1.0}));
  Simulation pushed(on.scene, on.scene.end_time, &grains.transport());
  const Row end = rows_of(pushed).back();
  const Scene other = SceneText().read(kThrownBall, {"gravity=[0,0,-1.0]"});
  Simulation free(other, other.end_time, nullptr);
  const Row expected = rows_of(free).back();
  EXPECT_NEAR(end.z, expected.z, kRoundOff);
  EXPECT_NEAR(end.vz, expected.vz, kRoundOff);
}

TEST(Simulation, SendsTheMotionOfEveryWindowsStart) {
  const GrainScene on;
  LoopbackGrains grains(test::start_of_ball(), pushes({0.0, 0.0, 5.0}));
  Simulation simulation(on.scene, on.scene.end_time, &grains.transport());
  const std::vector<Row> rows = rows_of(simulation);
  EXPECT_EQ(grains.join(), "");
  const std::vector<Motion>& sent = grains.motions();
  ASSERT_EQ(sent.size() + 1, rows.size());
  for (std::size_t k = 0; k < sent.size(); ++k) {
    EXPECT_EQ(sent[k].window, static_cast<std::int64_t>(k));
    EXPECT_EQ(sent[k].time, rows[k].time);
    EXPECT_EQ(sent[k].bodies[0].r.z(), rows[k].z);
    EXPECT_EQ(sent[k].bodies[0].dr.z(), rows[k].vz);
    const bool last = k + 1 == sent.size();
    EXPECT_EQ(sent[k].last_window, last);
    EXPECT_EQ(sent[k].n, last ? 3 : kSubsteps);  // 123 substeps
  }
}

// The boundary comes to its prediction in the last window, unless it is much shorter than the window that left the gap.
TEST(Simulation, ClosesNoGapFasterThanItWasMade) {
  for (const auto& [steps, n, closing] :
       {std::tuple{123, 3, 3}, std::tuple{122, 2, 2}, std::tuple{121, 1, kSubsteps}}) {
    const GrainScene on;
    LoopbackGrains grains(test::start_of_ball(), pushes({0.0, 0.0, 0.0}));
    Simulation simulation(on.scene, steps * kDt, &grains.transport());
    rows_of(simulation);
    EXPECT_EQ(grains.join(), "");
    EXPECT_EQ(grains.motions().back().n, n);
    EXPECT_EQ(grains.motions().back().closing, closing);
  }
}

TEST(Simulation, SamplesWhatTheCouplingTells) {
  const GrainScene on;
  LoopbackGrains grains(test::start_of_ball(), [](const Motion& motion, Load& load) {
    load.bodies[0].contact_stiffness = 800.0;  // [N/m]: omega = 20 rad/s
    load.bodies[0].mean.work = 0.01 * static_cast<double>(motion.window == 0);
  });
  Simulation simulation(on.scene, 8e-4, &grains.transport());
  simulation.run(
      [](const Sample& sample) {
        ASSERT_NE(sample.coupling, nullptr);
        EXPECT_EQ(sample.coupling->substeps, sample.window > 0 ? kSubsteps : 0);
        ASSERT_EQ(sample.coupling->omega_h.size(), 1u);
        EXPECT_NEAR(sample.coupling->omega_h[0], sample.window > 0 ? 20.0 * kSubsteps * kDt : 0.0, kRoundOff);
        EXPECT_NEAR(sample.coupling->energy_residual, sample.window > 0 ? 0.01 : 0.0, kRoundOff);
      },
      test::kNever);
  EXPECT_EQ(simulation.coupled()->load().particles, 1000);
}

TEST(Simulation, WithEveryAutoFliesInLongWindows) {
  const GrainScene on({"particles.surface_height=0", "coupling.max_substeps=50"});
  LoopbackGrains grains(test::start_of_ball(0), pushes({0.0, 0.0, 0.0}));
  Simulation simulation(on.scene, 0.01, &grains.transport());
  rows_of(simulation);
  EXPECT_EQ(grains.join(), "");
  EXPECT_EQ(grains.accept().n_max, 50);
  ASSERT_EQ(grains.motions().size(), 2u);  // 100 substeps
  EXPECT_EQ(grains.motions()[0].n, 50);
}

// Windows of 0.4 ms, samples every 0.7 ms, and an event at 3.333 ms, after which the ball is pushed: both end their windows,
// the event with the DEM step in which it happens.
TEST(Simulation, EndsWindowsAtSamplesAndForeseenEvents) {
  const std::string controller =
      "[[controllers]]\nname = \"hold\"\nkind = \"pid\"\nbody = \"ball\"\noutputs = [\"U1\"]\nperiod_ms = 0.7\n";
  const std::string event =
      "[[states]]\nname = \"waits\"\n[[states]]\nname = \"pushed\"\n[[events]]\nname = \"fast\"\nto = \"pushed\"\n"
      "when = \"ball.vz < -1.005\"\n[[signals]]\nname = \"push\"\nkind = \"expression\"\ninput = \"100 * "
      "state.pushed\"\n[[forces]]\nname = \"engine\"\nbody = \"ball\"\ndirection = [0, 0, 1]\nforce = { signal = "
      "\"push\" }\n";
  const GrainScene folder;
  const auto run = [&](const std::string& more) {
    const Scene scene = folder.folder.read(kThrownBall + test::kOnGrains + more);
    LoopbackGrains grains(test::start_of_ball(), pushes({0.0, 0.0, 0.0}));
    Simulation simulation(scene, 0.01, &grains.transport());
    const double vz = rows_of(simulation).back().vz;
    EXPECT_EQ(grains.join(), "");
    std::vector<int> starts;  // of windows [DEM steps]
    for (const Motion& motion : grains.motions()) starts.push_back(static_cast<int>(std::lround(motion.time / kDt)));
    return std::pair(starts, vz);
  };
  const auto [samples, unused] = run(controller);
  for (int k = 7; k < 100; k += 7) EXPECT_TRUE(std::count(samples.begin(), samples.end(), k)) << k;
  // Or a time that has passed when a window would end.
  std::string passing = event;
  passing.replace(passing.find("ball.vz < -1.005"), 16, "ball.vz < -1.005 && ball.vz > -1.00522");
  for (const std::string& of_motion : {event, passing}) {
    const auto [ends, vz] = run(of_motion);
    const std::vector<int> expected = {0, 4, 8, 12, 16, 20, 24, 28, 32, 34, 38};
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), ends.begin()));
    EXPECT_NEAR(vz, -1.0 - kGravity * 0.01 + 100.0 / kMass * (0.01 - 0.0034), 1e-9);
  }
}

bool tells_of_late_event(const Simulation& simulation) {
  for (const std::string& warning : simulation.coupled()->watch().warnings())
    if (warning.find(code::kEventLate.number) != std::string::npos) return true;
  return false;
}

// Windows of 0.4 ms. The grains push with 2e5 N/s t, which passes 495 N at 2.475 ms, in the seventh window. Windows end where the
// means of the last two tell so if the force rises twice as fast; in the 25th DEM step it is 490 N, of the next 510 N.
TEST(Simulation, EndsWindowsWhereLoadsTriggerEvents) {
  const std::string event =
      "[[states]]\nname = \"waits\"\n[[states]]\nname = \"pushed\"\n[[events]]\nname = \"loaded\"\nto = \"pushed\"\n"
      "when = \"WHEN\"\n[[signals]]\nname = \"push\"\nkind = \"expression\"\ninput = \"100 * state.pushed\"\n"
      "[[forces]]\nname = \"engine\"\nbody = \"ball\"\ndirection = [0, 0, 1]\nforce = { signal = \"push\" }\n";
  const GrainScene folder;
  for (const std::string& when : std::vector<std::string>{"ball.contact.fz > 495", "ball.az > 246"}) {
    std::string text = event;
    text.replace(text.find("WHEN"), 4, when);
    const Scene scene = folder.folder.read(kThrownBall + test::kOnGrains + text);
    LoopbackGrains grains(test::start_of_ball(), [](const Motion& motion, Load& load) {
      load.bodies[0].mean.F_W.z() = 2e5 * (motion.time + 0.5 * motion.n * kDt);
    });
    Simulation simulation(scene, 0.004, &grains.transport());
    rows_of(simulation);
    EXPECT_EQ(grains.join(), "");
    std::vector<int> starts;  // of windows [DEM steps]
    for (const Motion& motion : grains.motions()) starts.push_back(static_cast<int>(std::lround(motion.time / kDt)));
    const std::vector<int> expected = {0, 4, 8, 12, 16, 20, 22, 23, 24, 25, 26, 30, 34};
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), starts.begin())) << when << testing::PrintToString(starts);
    EXPECT_FALSE(tells_of_late_event(simulation));
  }
}

// At once 500 N: nothing foretells them.
TEST(Simulation, TellsOfEventsThatLoadsTriggerLate) {
  const std::string event =
      "[[states]]\nname = \"waits\"\n[[states]]\nname = \"pushed\"\n[[events]]\nname = \"loaded\"\nto = \"pushed\"\n"
      "when = \"ball.contact.fz > 400\"\n[[signals]]\nname = \"push\"\nkind = \"expression\"\ninput = \"PUSH * "
      "state.pushed\"\n[[forces]]\nname = \"engine\"\nbody = \"ball\"\ndirection = [0, 0, 1]\nforce = { signal = "
      "\"push\" }\n";
  const GrainScene folder;
  for (const bool strong : {true, false}) {
    std::string text = event;
    text.replace(text.find("PUSH"), 4, strong ? "1000" : "10");  // 0.4 ms of it: over 1 % of the velocity, or less
    const Scene scene = folder.folder.read(kThrownBall + test::kOnGrains + text);
    LoopbackGrains grains(test::start_of_ball(), [](const Motion& motion, Load& load) {
      if (motion.window >= 3) load.bodies[0].mean.F_W.z() = 500.0;
    });
    Simulation simulation(scene, 0.004, &grains.transport());
    rows_of(simulation);
    EXPECT_EQ(grains.join(), "");
    EXPECT_EQ(tells_of_late_event(simulation), strong);
  }
}

// Led along its path against an alternating force: round-off of its work, and a window's impulse, are no energy of its.
TEST(Simulation, DoesNotJudgeABodyThatIsLed) {
  const std::string led = kThrownBall + test::kOnGrains + R"(
[[joints]]
name = "drive"
kind = "prescribed"
bodies = ["ground", "ball"]
point = [0, 0, 3]
axis = "z"
axis2 = "x"
[joints.motion]
x = { polynomial = [0, 0.5] }
y = { polynomial = [0] }
z = { polynomial = [0, -1.0, 20] }
rotation = { polynomial = [0] }
hold_other_rotations = true
)";
  for (const double mass : {1e3, 1.0, 1e-3}) {
    const GrainScene on({"bodies.ball.mass=" + std::to_string(mass)}, led);
    LoopbackGrains grains(test::start_of_ball(), [](const Motion& motion, Load& load) {
      load.bodies[0].mean.F_W.z() = motion.window % 2 == 0 ? 500.0 : 0.0;
      load.bodies[0].contact_stiffness = 1e6;
    });
    Simulation simulation(on.scene, on.scene.end_time, &grains.transport());
    EXPECT_NO_THROW(rows_of(simulation)) << mass;
    EXPECT_EQ(grains.join(), "");
    EXPECT_EQ(simulation.coupled()->watch().largest_omega_h(0), 0.0);
    // A force that alternates from window to window is not resolved; nothing else is wrong.
    for (const std::string& warning : simulation.coupled()->watch().warnings())
      EXPECT_NE(warning.find(code::kForceNotResolved.number), std::string::npos) << warning;
  }
}

TEST(Simulation, RefusesALoadThatIsNotFinite) {
  const GrainScene on;
  LoopbackGrains grains(test::start_of_ball(), [](const Motion& motion, Load& load) {
    if (motion.window == 2) load.bodies[0].mean.F_W.z() = std::numeric_limits<double>::quiet_NaN();
  });
  Simulation simulation(on.scene, on.scene.end_time, &grains.transport());
  EXPECT_TRUE(test::names(test::error_of<NumericalError>([&] { rows_of(simulation); }), {"0.0008"}));
}

TEST(Simulation, TwiceIsTheSameToTheBit) {
  std::vector<Row> runs[2];
  for (std::vector<Row>& rows : runs) {
    const GrainScene on;
    LoopbackGrains grains(test::start_of_ball(), [](const Motion& motion, Load& load) {
      load.bodies[0].mean.F_W.z() = 1e3 * (3.0 - motion.bodies[0].r.z());
    });
    Simulation simulation(on.scene, on.scene.end_time, &grains.transport());
    rows = rows_of(simulation);
  }
  ASSERT_EQ(runs[0].size(), runs[1].size());
  for (std::size_t k = 0; k < runs[0].size(); ++k) {
    EXPECT_EQ(runs[0][k].z, runs[1][k].z);
    EXPECT_EQ(runs[0][k].vz, runs[1][k].vz);
  }
}

TEST(RunScene, WithoutGrainsWritesNothingOfTheCoupling) {
  const SceneText folder;
  const Scene scene = folder.read(kThrownBall);
  const std::string out = test::run_into_folder(scene);
  EXPECT_FALSE(std::filesystem::exists(out + "/motion"));
  const nlohmann::ordered_json summary = read_summary(out + "/summary.json");
  EXPECT_EQ(summary["active"], nlohmann::ordered_json({"bodies"}));
  for (const auto& [key, value] : summary.items())
    for (const char* part : {"coupling", "dt_dem", "substeps", "particles", "omega"})
      EXPECT_EQ(key.find(part), std::string::npos) << key;
}

// A table of a force is what is drawn: straight lines between its points, constant beyond them. A thrust of 1 kN is cut
// off within 10 ms: m v = 1000 N 1.005 s.
TEST(Simulation, TakesTablesOfForcesByStraightLines) {
  const Scene scene = SceneText().read(R"(end_time = 7
gravity = [0, 0, 0]
[[bodies]]
name = "ship"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 0]
[[forces]]
name = "thrust"
body = "ship"
frame = "inertial"
direction = "x"
force = { table = [[0, 1000], [1, 1000], [1.01, 0], [5, 0]] }
)");
  Simulation simulation(scene, scene.end_time, nullptr);
  double speed = 0.0;
  simulation.run([&](const Sample& sample) { speed = sample.kinematics.of(0).dr.x(); }, test::kNever);
  EXPECT_NEAR(speed, 502.5, 1e-3);
}

// What joints hold at rest moves no energy: round-off of nothing is no fault.
TEST(RunScene, HasNothingToSayOfAMechanismAtRest) {
  const SceneText folder;
  const Scene scene = folder.read(R"(end_time = 0.1
[[bodies]]
name = "box"
mass = 1.0
shape = { kind = "box", size = [1, 1, 1], centre = [0, 0, 0] }
[[joints]]
name = "clamp"
kind = "fixed"
bodies = ["ground", "box"]
point = [0, 0, 0]
)");
  const std::string out = test::run_into_folder(scene);
  EXPECT_EQ(read_summary(out + "/summary.json")["warnings"], nlohmann::ordered_json::array());
}

TEST(RunScene, OnGrainsTellsOfBothSides) {
  const GrainScene on;
  LoopbackGrains grains(test::start_of_ball(), pushes({0.0, 0.0, 5.0}));
  const std::string out = test::run_into_folder(on.scene, &grains.transport());
  EXPECT_EQ(grains.join(), "");
  const nlohmann::ordered_json summary = read_summary(out + "/summary.json");
  EXPECT_EQ(summary["status"], "done");
  EXPECT_EQ(summary["particles"], 1000);
  EXPECT_EQ(summary["substeps_per_window"], kSubsteps);
  EXPECT_EQ(summary["windows"], 31);
  EXPECT_EQ(summary["active"], nlohmann::ordered_json({"bodies", "particles"}));
}

// Rows are read from the steps: without anything that samples the whole run is one window.
TEST(Simulation, RowsEndNoStepWhereNothingIsSampled) {
  SceneText folder;
  long steps[2];
  for (int k = 0; k < 2; ++k) {
    const Scene scene = folder.read(kThrownBall, {k == 0 ? "output.interval=1" : "output.interval=1e-4"});
    Simulation simulation(scene, kEnd, nullptr);
    simulation.run([](const Sample&) {}, test::kNever);
    steps[k] = simulation.integrator().statistics().steps;
    EXPECT_EQ(simulation.integrator().statistics().windows, 1) << k;
  }
  EXPECT_EQ(steps[0], steps[1]);
}

// A run is kept where the clock says so: no trace in the run, and no set that a side could not write.

// A ball on a string: nothing that the integrator takes exactly.
const std::string kBallOnAString = R"(end_time = 0.05
gravity = [0, 0, -9.81]
[[bodies]]
name = "ball"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0.5, 0, 3]
[[joints]]
name = "hinge"
kind = "revolute"
bodies = ["ground", "ball"]
point = [0, 0, 3]
axis = [0, 1, 0]
[output]
interval = 1e-3
)";
struct Counted {
  int begun = 0, finished = 0, dropped = 0;
};
CheckpointWriter always_overdue(Counted& count) {
  CheckpointWriter keep;
  keep.begin = [&count](long windows) {
    ++count.begun;
    return "set_" + std::to_string(windows);
  };
  keep.finish = [&count] { ++count.finished; };
  keep.cancel = [&count] { ++count.dropped; };
  keep.overdue = [] { return true; };
  return keep;
}

using States = std::vector<std::vector<double>>;
States states_of(Simulation& simulation, const CheckpointWriter& keep) {
  States states;
  simulation.run(
      [&](const Sample& sample) {
        states.emplace_back(sample.state.q.data(), sample.state.q.data() + sample.state.q.size());
        states.back().insert(states.back().end(), sample.state.v.data(), sample.state.v.data() + sample.state.v.size());
      },
      test::kNever, keep);
  return states;
}

TEST(KeptByTheClock, AMechanismGoesOnAsIfItWereNot) {
  const Scene scene = SceneText().read(kBallOnAString);
  Simulation plain(scene, scene.end_time, nullptr), kept(scene, scene.end_time, nullptr);
  Counted count;
  EXPECT_EQ(states_of(plain, {}), states_of(kept, always_overdue(count)));
  EXPECT_GT(count.finished, 40) << "at every row";
  EXPECT_EQ(count.begun, count.finished);
}

States coupled_states(const CheckpointWriter& keep, std::int64_t cannot_before) {
  const GrainScene on({"coupling.stop_on_energy_gain=false"}, kBallOnAString + test::kOnGrains);
  LoopbackGrains grains(test::start_of_ball(), [](const Motion& motion, Load& load) {
    load.bodies[0].mean.F_W.z() = 30.0 * std::sin(500.0 * motion.time);
  });
  grains.cannot_keep_quietly_before(cannot_before);
  Simulation simulation(on.scene, on.scene.end_time, &grains.transport());
  States states = states_of(simulation, keep);
  EXPECT_TRUE(simulation.finished());
  EXPECT_EQ(grains.join(), "");
  return states;
}

TEST(KeptByTheClock, ACoupledRunGoesOnAsIfItWereNot) {
  Counted count;
  EXPECT_EQ(coupled_states({}, 0), coupled_states(always_overdue(count), 0));
  EXPECT_EQ(count.finished, 124) << "after every window but the last";
  EXPECT_EQ(count.begun, count.finished);
}

TEST(KeptByTheClock, WhereTheGrainsCannotBeKeptTheSetIsDroppedAndTriedAgain) {
  Counted count;
  EXPECT_EQ(coupled_states({}, 0), coupled_states(always_overdue(count), 100));
  EXPECT_EQ(count.dropped, 100);
  EXPECT_EQ(count.finished, 24);
}

TEST(SafetyClock, RestsForAsLongAsSetsTake) {
  SafetyClock never(0.0, 300.0);
  EXPECT_FALSE(never.active());
  EXPECT_FALSE(never.overdue());
  SafetyClock often(1e-9, 0.0), rests(1e-9, 1e12);
  for (SafetyClock* clock : {&often, &rests}) {
    EXPECT_TRUE(clock->overdue());
    clock->begin();
    clock->finish();
  }
  EXPECT_TRUE(often.overdue());
  EXPECT_FALSE(rests.overdue());
}

}  // namespace
}  // namespace footfall
