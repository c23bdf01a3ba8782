// A bed that goes along with a body: [particles.box] follow.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/session/output/history.h"
#include "tests/app/programs.h"

namespace footfall {
namespace {

// A probe above the bed goes along x and y, on a slope of tilted gravity.
const std::string kHover = R"(title = "Nothing touches the bed"
end_time = 0.9
gravity = [1.2, 0.4, -9.7]
ground = { kind = "particles" }
boundaries = [{ body = "probe", surface = { element_size = 0.03 } }]
output = { plots = false }
bodies = [{ name = "probe", mass = 2, shape = { kind = "box", size = [0.05, 0.04, 0.05], centre = [0, 0, 0.1] } }]
[particles.box]
size = [0.4, 0.4]
depth = 0.04
radius = 0.01
follow = "probe"
[[joints]]
name = "rig"
kind = "prescribed"
bodies = ["ground", "probe"]
point = [0, 0, 0.1]
axis = "z"
axis2 = "x"
motion = { x = { polynomial = [0, -1] }, y = { polynomial = [0, 0.5] }, z = { polynomial = [0] }, rotation = { polynomial = [0] }, hold_other_rotations = true }
)";

// Of this run, from its first dump: number of grains.
long grains_at_start(const app::Folder& folder, const std::string& run) {
  return read_bed_frame(find_bed_frames(folder.file(run)).begin()->second).count();
}

TEST(FollowingBed, TakesWhatItAddsWhereNothingTouches) {
  const app::Folder folder("follow_hover");
  folder.write("scene.toml", kHover);
  folder.done("run . --out run --quiet --set particles.box.frame_interval=0.3", 300);
  const nlohmann::json summary = folder.summary("run"), bed = summary["bed"];
  const long added = bed["grains_added"], removed = bed["grains_removed"], start = grains_at_start(folder, "run");
  EXPECT_EQ(summary["particles"].get<long>(), start + added - removed);
  // Two lengths of the bed along x and one along y have come, and to the grain as much has gone.
  EXPECT_GT(added, 5 * start / 2);
  EXPECT_EQ(added, removed);
  EXPECT_EQ(summary["grains_lost"], 0);
  // Their energy: on the slope a grain in front has another height than one behind, by a period. Six digits of the file.
  const History ledger = read_history(folder.file("run/ledger.csv"));
  const double gravity = ledger.column("grains.gravity").back();
  EXPECT_GT(gravity, 1.0);
  EXPECT_NEAR(ledger.column("grains.dissipated").back(), 0.0, 0.01 * gravity);
  // The bed is around the probe.
  const BedFrame last = read_bed_frame(find_bed_frames(folder.file("run")).rbegin()->second);
  EXPECT_LT(last.x.row(0).maxCoeff(), -0.9 + 0.4);
  EXPECT_GT(last.x.row(0).minCoeff(), -0.9 - 0.4);
  EXPECT_GT(last.x.row(1).minCoeff(), 0.45 - 0.4);
}

TEST(FollowingBed, CountsEveryGrainUnderAWheel) {
  const app::Folder folder("follow_wheel");
  folder.done("run " + app::kSource +
                  "/tests/app/follow.toml --set end_time=1 --out run --quiet --set particles.box.frame_interval=0.2",
              300);
  const nlohmann::json summary = folder.summary("run"), bed = summary["bed"];
  const long added = bed["grains_added"], removed = bed["grains_removed"], start = grains_at_start(folder, "run");
  EXPECT_EQ(summary["particles"].get<long>(), start + added - removed);
  const double grain = 2600.0 * 4.0 / 3.0 * kPi * 1e-6;  // [kg]
  EXPECT_NEAR(bed["mass_added_kg"].get<double>(), static_cast<double>(added) * grain, 1e-9);
  EXPECT_NEAR(bed["mass_removed_kg"].get<double>(), static_cast<double>(removed) * grain, 1e-9);
  // The wheel has gone half a metre, a length of the bed: to the grain as much has gone as come.
  EXPECT_GT(added, 3 * start / 4);
  EXPECT_EQ(added, removed);
  const History history = read_history(folder.file("run/history.csv"));
  EXPECT_EQ(history.column("bed.grains_added").back(), static_cast<double>(added));
  // The wheel stays on the bed: neither through its floor nor on top.
  EXPECT_LT(history.column("wheel.z").back(), 0.06);
  EXPECT_GT(history.column("wheel.z").back(), 0.01);
}

TEST(FollowingBed, EndsTheRunOfABodyThatStaysBehind) {
  const app::Folder folder("follow_left");
  const auto with = [](std::string text, const std::string& old, const std::string& now) {
    return text.replace(text.find(old), old.size(), now);
  };
  std::string scene = with(kHover, "0.1] } }]",
                           "0.1] } },\n  { name = \"stone\", mass = 1, shape = { kind = \"sphere\", " +
                               std::string("centre = [0.06, 0, 0.05], radius = 0.02 } }]"));
  scene = with(scene, "boundaries = [", "boundaries = [{ body = \"stone\", surface = { element_size = 0.02 } }, ");
  folder.write("scene.toml", scene +
                                 "[[joints]]\nname = \"held\"\nkind = \"fixed\"\nbodies = [\"ground\", \"stone\"]\n" +
                                 "point = [0.06, 0, 0.05]\n");
  const test::Outcome result = folder.footfall("run . --out run --quiet", 300);
  EXPECT_EQ(result.exit_code, 1) << result.text;
  EXPECT_NE(result.text.find("E0484"), std::string::npos) << result.text;
}

// A run that ends and is resumed after each of its checkpoints about a shift of the bed (at 0.1 s) gives the bytes of the run that does
// not end: history, and the grains of the last two checkpoints.
TEST(FollowingBed, ResumesToTheByteFromCheckpointsBeforeAndAfterAShift) {
  const app::Folder folder("follow_resumed");
  const auto run = [&](const std::string& words, double until) {
    folder.done("run " + words + " --quiet --until " + std::to_string(until));
  };
  const auto newest = [&](const std::string& out) {
    long step = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.file(out + "/checkpoint")))
      step = std::max(step, std::stol(entry.path().filename()));
    return step;
  };
  const auto grains_added = [&] {
    return folder.summary("parts").value(nlohmann::json::json_pointer("/bed/grains_added"), 0L);
  };
  const std::string scene = app::kSource + "/tests/app/follow.toml --set output.checkpoint_interval=1e-3";
  constexpr double kBegin = 0.0975, kPart = 1e-3, kEnd = 0.1045;
  run(scene + " --out whole", kEnd);
  run(scene + " --out parts", kBegin);
  int before = 0, after = 0;
  for (double until = kBegin + kPart; until < kEnd + 0.5 * kPart; until += kPart) {
    (grains_added() == 0 ? before : after) += 1;
    const long resumed = newest("parts");
    run("--resume parts", std::min(until, kEnd));
    EXPECT_GT(newest("parts"), resumed) << "a checkpoint for each part";
  }
  EXPECT_GE(before, 2);
  EXPECT_GE(after, 2);
  EXPECT_TRUE(folder.read("whole/history.csv") == folder.read("parts/history.csv"));
  for (const auto& entry : std::filesystem::directory_iterator(folder.file("whole/checkpoint"))) {
    const std::string grains = "checkpoint/" + entry.path().filename().string() + "/grains.restart";
    EXPECT_TRUE(folder.read("whole/" + grains) == folder.read("parts/" + grains)) << grains;
  }
}

// Means over four parts of a drive: their mean, and its standard error.
struct DriveMean {
  double mean = 0.0, error = 0.0;
};

std::map<std::string, DriveMean> driven(const History& history, double from, double to) {
  constexpr int kParts = 4;
  std::map<std::string, DriveMean> all;
  for (const char* name : {"wheel.contact.fx", "wheel.contact.my", "wheel.z"}) {
    std::array<double, kParts> sums{};
    std::array<int, kParts> counts{};
    const std::vector<double>&time = history.column("time"), &values = history.column(name);
    for (std::size_t i = 0; i < time.size(); ++i) {
      const int part = static_cast<int>(std::floor(kParts * (time[i] - from) / (to - from)));
      if (part < 0 || part >= kParts) continue;
      sums[part] += values[i];
      ++counts[part];
    }
    double mean = 0.0, square = 0.0;
    for (std::size_t k = 0; k < kParts; ++k) {
      const double value = sums[k] / counts[k];
      mean += value / kParts;
      square += value * value / kParts;
    }
    all[name] = {mean, std::sqrt(std::max(0.0, square - mean * mean) / (kParts - 1))};
  }
  return all;
}

// Drawbar pull, torque and sinkage of a wheel that drives two and a half lengths of its patch, and of the same wheel on one long bed
// of the same width, also periodic. Four standard errors of the difference of two means, of four parts each: one in some hundred
// such pairs differs by more; and a tenth of the radius of a grain where the parts are alike by chance.
TEST(FollowingBed, CarriesAWheelAsALongBedDoes) {
  const app::Folder folder("follow_long");
  const std::string wheel = "run " + app::kSource +
                            "/tests/app/follow.toml --quiet --set end_time=3.3 --set particles.box.depth=0.08"
                            " --set bodies.wheel.mass=1 --set bodies.axle.mass=0.5 --set bodies.wheel.shape.length=0.08"
                            " --set boundaries.wheel.surface.element_size=0.02 --set output.interval=0.01";
  folder.done(wheel + " --set particles.box.size=[0.64,0.24] --out patch", 1800);
  std::string scene = folder.command("cat " + app::kSource + "/tests/app/follow.toml", 10).text;
  for (const char* line : {"follow = \"wheel\"\n", "follow_directions = \"x\"\n"})
    scene.erase(scene.find(line), std::string(line).size());
  folder.write("long.toml", scene);
  folder.done(
      std::regex_replace(wheel, std::regex("run [^ ]*"), "run long.toml") +
          " --set particles.box.size=[2.5,0.24] --set particles.box.centre=[0.9,0] --set particles.box.periodic=true "
          "--out long",
      3600);
  const auto patch = driven(read_history(folder.file("patch/history.csv")), 1.0, 3.25),
             bed = driven(read_history(folder.file("long/history.csv")), 1.0, 3.25);
  const std::map<std::string, double> least = {
      {"wheel.contact.fx", 0.2}, {"wheel.contact.my", 0.01}, {"wheel.z", 0.001}};  // [N], [N m], [m]
  for (const auto& [name, one] : patch) {
    const DriveMean& other = bed.at(name);
    EXPECT_NEAR(one.mean, other.mean, least.at(name) + 4.0 * std::hypot(one.error, other.error)) << name;
  }
  const nlohmann::json counts = folder.summary("patch")["bed"];
  EXPECT_EQ(counts["grains_added"], counts["grains_removed"]);
}

}  // namespace
}  // namespace footfall
