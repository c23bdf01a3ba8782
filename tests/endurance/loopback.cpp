// endurance_loopback WINDOWS: a coupled run of so many windows in this process, with grains that only push. Its memory may not grow with the windows.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include "coupler/link.h"
#include "coupler/transport_loopback.h"
#include "mbd_solver/run/run_scene.h"
#include "tests/unit/scene/scene_text.h"

namespace {

using namespace footfall;

constexpr double kDt = 1e-4;  // [s]
constexpr int kSubsteps = 4;
constexpr double kPatience = 60.0;  // [s]

const char* const kScene = R"(gravity = [0, 0, -1.5]
[[bodies]]
name = "ball"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 3]
[[boundaries]]
body = "ball"
[boundaries.beams]
points = [[-0.1, 0, 3], [0.1, 0, 3]]
radius = 0.05
[ground]
kind = "particles"
[particles]
script = "in.grains"
[output]
interval = 0.1
plots = false
)";

// Resident memory of this process [kB].
long resident() {
  std::ifstream file("/proc/self/statm");
  long all = 0, pages = 0;
  file >> all >> pages;
  return pages * sysconf(_SC_PAGESIZE) / 1024;
}

// Carries the ball, and remembers nothing; at_tenth: memory after a tenth of the windows [kB].
void serve(Transport& transport, long windows, long& at_tenth) {
  Link link(transport, kPatience);
  Hello hello;
  hello.unit_style = kUnitStyle;
  link.send(hello);
  Geometry geometry;
  link.receive(geometry);
  Start start;
  start.dt = kDt;
  start.n = kSubsteps;
  start.bodies = {"ball"};
  link.send(start);
  Accept accept;
  link.receive(accept);
  Motion motion;
  Load load;
  load.particles = 1000;
  load.bodies.emplace_back();
  load.bodies[0].mean = MeanLoad(0);
  while (!motion.last_window) {
    link.receive(motion);
    load.window = motion.window;
    load.bodies[0].mean.F_W.z() = 2.0 * 1.5;  // [N]
    link.send(load);
    if (!motion.checkpoint.empty()) {
      CheckpointDone kept;
      kept.window = motion.window;
      link.send(kept);
    }
    if (motion.window == windows / 10) at_tenth = resident();
  }
  link.close();
}

}  // namespace

int main(int argc, char** argv) {
  const long windows = argc > 1 ? std::atol(argv[1]) : 0;
  if (windows < 100) {
    std::fprintf(stderr, "endurance_loopback WINDOWS: expected 100 or more\n");
    return kExitBadInput;
  }
  try {
    const SceneText folder;
    folder.write(
        "in.grains",
        "timestep 1e-4\nfix m all mesh/surface file m.stl type 1\nfix mbd all couple/mbd every 4 mesh m ball\nrun 1\n");
    char end_time[64];
    std::snprintf(end_time, sizeof end_time, "end_time = %.10g\n", static_cast<double>(windows) * kSubsteps * kDt);
    const Scene scene = folder.read(std::string(end_time) + kScene);
    RunOptions options;
    options.out = (std::filesystem::path(scene.file).parent_path() / "out").string();
    options.quiet = true;
    auto [grains, mechanism] = TransportLoopback::make_pair();
    long at_tenth = 0;
    std::string failure;
    std::thread partner([&, end = grains.get()] {
      try {
        serve(*end, windows, at_tenth);
      } catch (const std::exception& error) {
        failure = error.what();
      }
    });
    const volatile std::sig_atomic_t never = 0;
    const int code = run_scene(scene, options, mechanism.get(), never);
    partner.join();
    if (!failure.empty()) throw PartnerError(failure);
    const long at_end = resident();
    std::printf("%ld windows: %ld kB after a tenth of them, %ld kB at the end\n", windows, at_tenth, at_end);
    constexpr long kMost = 1024;  // [kB] pages that the allocator keeps back
    return code != kExitDone || at_end - at_tenth > kMost ? kExitFailed : kExitDone;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "endurance_loopback: %s\n", error.what());
    return kExitFailed;
  }
}
