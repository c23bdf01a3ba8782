// A run is kept where the clock says so: no trace in the run, and no set that a side could not write.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <string>
#include <vector>

#include "mbd_solver/run/safety_clock.h"
#include "mbd_solver/run/simulation.h"
#include "tests/unit/coupling/loopback_grains.h"
#include "tests/unit/run/never.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using test::LoopbackGrains;

// A ball on a string: nothing that the integrator takes exactly.
const std::string kPendulum = R"(end_time = 0.05
gravity = [0, 0, -9.81]
[[bodies]]
name = "ball"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0.5, 0, 3]
[[joints]]
name = "hinge"
type = "revolute"
bodies = ["ground", "ball"]
point = [0, 0, 3]
axis = [0, 1, 0]
[output]
interval = 1e-3
)";
const std::string kOnGrains = kPendulum + R"(
[[boundaries]]
body = "ball"
[boundaries.beams]
points = [[-0.1, 0, 3], [0.1, 0, 3]]
radius = 0.05
[ground]
kind = "particles"
[particles]
script = "in.grains"
[coupling]
stop_on_energy_gain = false
)";

struct Counted {
  int begun = 0, finished = 0, dropped = 0;
};
Keeper always_overdue(Counted& count) {
  Keeper keep;
  keep.begin = [&count](long windows) {
    ++count.begun;
    return "set_" + std::to_string(windows);
  };
  keep.finish = [&count] { ++count.finished; };
  keep.drop = [&count] { ++count.dropped; };
  keep.overdue = [] { return true; };
  return keep;
}

using States = std::vector<std::vector<double>>;
States states_of(Simulation& simulation, const Keeper& keep) {
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
  const Scene scene = SceneText().read(kPendulum);
  Simulation plain(scene, scene.end_time, nullptr), kept(scene, scene.end_time, nullptr);
  Counted count;
  EXPECT_EQ(states_of(plain, {}), states_of(kept, always_overdue(count)));
  EXPECT_GT(count.finished, 40) << "at every row";
  EXPECT_EQ(count.begun, count.finished);
}

States coupled_states(const Keeper& keep, std::int64_t cannot_before) {
  const SceneText folder;
  folder.write(
      "in.grains",
      "timestep 1e-4\nfix m all mesh/surface file m.stl type 1\nfix mbd all couple/mbd every 4 mesh m ball\nrun 1\n");
  const Scene scene = folder.read(kOnGrains);
  Start start;
  start.dt = 1e-4;
  start.n = 4;
  start.bodies = {"ball"};
  LoopbackGrains grains(start, [](const Motion& motion, Load& load) {
    load.bodies[0].mean.F_W.z() = 30.0 * std::sin(500.0 * motion.time);
  });
  grains.cannot_keep_quietly_before(cannot_before);
  Simulation simulation(scene, scene.end_time, &grains.transport());
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
  EXPECT_FALSE(never.runs());
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
