// An imported arm digs in a bed of grains: the scenes of inputs/robots, as the page on the import starts them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/session/output/history.h"
#include "tests/support/run_folder.h"

namespace footfall {
namespace {

const std::string kRobots = FOOTFALL_SOURCE_DIR "/inputs/robots/";

void done(const test::RunFolder& folder, const std::string& line, int limit) {
  const test::Outcome outcome = folder.command(test::RunFolder::program("footfall") + " " + line, limit);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
}

// The scene of a robot with the import next to it.
std::string scene_beside(const test::RunFolder& folder, const std::string& name, const std::string& robot) {
  std::string scene = folder.read(kRobots + name);
  const std::string base = "../../" + robot;
  const std::size_t at = scene.find("\"" + base + "/scene.toml\"");
  EXPECT_NE(at, std::string::npos);
  return at == std::string::npos ? scene : scene.replace(at + 1, base.size(), robot);
}

// The quadruped's trot on a plane instead of sand: feet that do not slip or sink make steps of 6 cm, three times two a second, while
// the trunk stays level: 0.36 m/s once the steps have grown at 0.3 s, so at least half of 0.36 m/s * 0.6 s.
TEST(Walking, OfAnImportedQuadrupedGoesForward) {
  const test::RunFolder folder("walk");
  ASSERT_NO_FATAL_FAILURE(
      done(folder, "import " + kRobots + "quadruped.urdf --hold --ground plane --quiet --out dog", 60));
  std::string scene = scene_beside(folder, "walk.toml", "dog");
  const std::size_t bed = scene.find("\nparticles");
  ASSERT_NE(bed, std::string::npos);
  folder.write("walk.toml", scene.erase(bed, scene.find('\n', bed + 1) - bed));
  ASSERT_NO_FATAL_FAILURE(done(folder, "run walk.toml --quiet --out run", 120));
  const History history = read_history((folder.path() / "run/history.csv").string());
  const std::vector<double> y = history.column("trunk.y"), roll = history.column("trunk.roll"),
                            pitch = history.column("trunk.pitch");
  EXPECT_GT(y.back() - y.front(), 0.11);
  for (std::size_t k = 0; k < y.size(); ++k) EXPECT_LT(std::max(std::abs(roll[k]), std::abs(pitch[k])), 0.15);
}

// The arm goes 7 to 9 cm into loose sand, drags its spade by 0.25 m and leaves a furrow.
TEST(Digging, OfAnImportedArmMovesWhatItsSpadeSweeps) {
  const test::RunFolder folder("dig");
  ASSERT_NO_FATAL_FAILURE(
      done(folder, "import " + kRobots + "arm.urdf --fix-base --hold --ground toyoura-loose --quiet --out arm", 60));
  folder.write("dig.toml", scene_beside(folder, "dig.toml", "arm"));
  ASSERT_NO_FATAL_FAILURE(done(folder, "run dig.toml --ranks 1 --quiet --out run", 900));

  const nlohmann::json summary = nlohmann::json::parse(folder.read("run/summary.json"));
  EXPECT_EQ(summary["warnings"].size(), 0u) << summary["warnings"];
  EXPECT_GT(summary["max_sinkage_m"].get<double>(), 0.07);
  EXPECT_LT(summary["max_sinkage_m"].get<double>(), 0.1);
  // The sum of all parts of the energy stays, to the work that a coupling interval leaves unresolved.
  EXPECT_LT(std::abs(summary["ledger"]["closing_error_relative"].get<double>()), 1e-3);

  // While the spade drags, the sand pushes it back (+x) by more than Rankine's passive pressure on a wide wall of its depth below
  // the mean surface, K_p rho g d^2 b / 2 with phi = 33 degrees: a narrow spade lifts what is next to it as well, and
  // a heap, which for a spade as wide as it is deep multiplies the force by up to ten.
  const History history = read_history((folder.path() / "run/history.csv").string());
  const std::vector<double>&time = history.column("time"), &fx = history.column("hand.contact.fx");
  double force = 0.0;
  int rows = 0;
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] > 0.5 && time[k] < 1.0) {
      force += fx[k];
      ++rows;
    }
  force /= rows;
  const double depth = 0.075, width = 0.12, bulk = 2437 * 0.55;
  const double rankine = 0.5 * 3.4 * bulk * 9.81 * depth * depth * width;
  EXPECT_GT(force, rankine);
  EXPECT_LT(force, 12.0 * rankine);

  // Moved by more than two radii: at least what the spade swept, at most the wedges next to it as well.
  const std::map<long, std::string> frames = find_bed_frames((folder.path() / "run").string());
  ASSERT_GT(frames.size(), 2u);
  const BedFrame first = read_bed_frame(frames.begin()->second), last = read_bed_frame(frames.rbegin()->second);
  ASSERT_EQ(first.id, last.id);
  double moved = 0.0;
  for (int k = 0; k < first.count(); ++k) {
    const double r = first.radius[k];
    if ((last.x.col(k) - first.x.col(k)).norm() > 2.0 * r) moved += 2437 * 4.0 / 3.0 * M_PI * r * r * r;
  }
  const double swept = bulk * depth * width * 0.25;
  EXPECT_GT(moved, swept);
  EXPECT_LT(moved, 5.0 * swept);
  RecordProperty("force_N", std::to_string(force));
  RecordProperty("moved_kg", std::to_string(moved));
}

}  // namespace
}  // namespace footfall
