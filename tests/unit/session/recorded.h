#pragma once
// Runs and their rows: without grains by columns, into a folder, and of a ball on grains that a loopback partner plays.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mbd_solver/session/observe/metrics.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/run_scene.h"
#include "mbd_solver/session/simulation.h"
#include "tests/unit/coupling/loopback_grains.h"
#include "tests/unit/scene/scene_text.h"
#include "tests/unit/session/never.h"

namespace footfall::test {

// The rows of a run without grains, by the names of their columns.
struct Record {
  explicit Record(const Scene& from)
      : scene(from),
        simulation(scene, scene.end_time, nullptr),
        observation(simulation.subject()),
        names(observation.names()) {}
  void run(const CheckpointWriter& keep = {}) {
    MetricRecorder recorder(simulation.subject());
    simulation.run(
        [&](const Sample& sample) {
          rows.push_back(observation.row(sample));
          recorder.update(sample);
        },
        kNever, keep);
    metrics = recorder.metrics();
  }
  bool has(const std::string& name) const { return std::find(names.begin(), names.end(), name) != names.end(); }
  double value(std::size_t row, const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      ADD_FAILURE() << "no column " << name;
      return std::nan("");
    }
    return rows[row][static_cast<std::size_t>(found - names.begin())];
  }
  double last(const std::string& name) const { return value(rows.size() - 1, name); }
  std::vector<double> column(const std::string& name) const {
    std::vector<double> values;
    for (std::size_t row = 0; row < rows.size(); ++row) values.push_back(value(row, name));
    return values;
  }
  std::vector<WorkEstimate> work_estimates() const {
    return footfall::work_estimates(metrics, simulation.integrator().statistics().summed_error * scene.solver.rtol);
  }
  void visit(Archive& archive) {
    archive("simulation", simulation);
    archive("observation", observation);
  }

  Scene scene;
  Simulation simulation;
  Observation observation;
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  Metrics metrics;  // at the end
};

// One that has run.
struct Ran : Record {
  explicit Ran(const std::string& toml, const std::vector<std::string>& settings = {})
      : Record(SceneText().read(toml, settings)) {
    run();
  }
};

// Resumed from its first checkpoint (output.checkpoint_interval), a run without grains writes the rows of the run that went on.
// The run that continued.
inline std::unique_ptr<Record> expect_resumed_to_the_bit(const Scene& scene) {
  auto whole = std::make_unique<Record>(scene);
  std::string kept;
  CheckpointWriter first, none;
  first.begin = none.begin = [](long) { return std::string("nowhere"); };
  first.finish = [&] {
    if (!kept.empty()) return;
    Archive archive;
    whole->visit(archive);
    kept = archive.text();
  };
  none.finish = [] {};
  whole->run(first);
  Record later(scene);
  Archive archive("kept", kept);
  later.visit(archive);
  later.run(none);
  EXPECT_LT(later.rows.size(), whole->rows.size());
  const std::size_t offset = whole->rows.size() - later.rows.size();
  for (std::size_t row = 0; row < later.rows.size(); ++row)
    EXPECT_EQ(later.rows[row], whole->rows[offset + row]) << row;
  return whole;
}

// Runs a scene in the folder of its file; the folder of its results.
inline std::string run_into_folder(const Scene& scene, Transport* transport = nullptr, int code = kExitDone) {
  RunOptions options;
  options.out = (std::filesystem::path(scene.file).parent_path() / "out").string();
  options.quiet = true;
  EXPECT_EQ(run_scene(scene, options, transport, kNever), code);
  return options.out;
}

// A ball of 2 kg on grains, after the lines of its scene before its boundary; its folder has a script that LIGGGHTS never reads.
const std::string kOnGrains = R"(
[[boundaries]]
body = "ball"
[boundaries.beams]
points = [[-0.1, 0, 3], [0.1, 0, 3]]
radius = 0.05
[ground]
kind = "particles"
[particles]
script = "in.grains"
)";
const std::string kThrownBall = R"(end_time = 0.0123
gravity = [0, 0, -1.5]
[[bodies]]
name = "ball"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 3]
[initial]
velocity = [0.5, 0, -1.0]
[output]
interval = 1e-3
)";
constexpr double kDt = 1e-4;  // of its grains [s]
constexpr int kSubsteps = 4;

struct GrainScene {
  explicit GrainScene(const std::vector<std::string>& settings = {}, const std::string& toml = kThrownBall + kOnGrains)
      : script(folder.write("in.grains",
                            "timestep 1e-4\nfix m all mesh/surface file m.stl type 1\nfix mbd all couple/mbd every 4 "
                            "mesh m ball\nrun 1\n")),
        scene(folder.read(toml, settings)) {}
  SceneText folder;
  std::string script;
  Scene scene;
};

inline Start start_of_ball(int substeps = kSubsteps) {
  Start start;
  start.dt = kDt;
  start.n = substeps;
  start.bodies = {"ball"};
  return start;
}

inline LoopbackGrains::Answer pushes(const Eigen::Vector3d& F) {
  return [F](const Motion&, Load& load) { load.bodies[0].mean.F_W = F; };
}

}  // namespace footfall::test
