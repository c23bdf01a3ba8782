// Runs as a whole: every example is copied, checked and run; resumed runs reproduce the uninterrupted ones; the tolerance alone makes a run
// more exact. The folders of the examples remain for other tests.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "mbd_solver/app/new_case.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/session/output/history.h"
#include "tests/app/programs.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using app::holds;

class Example : public ::testing::TestWithParam<std::string> {};

// Of the rows from `start` until before `end` [s].
double mean_of(const std::vector<double>& time, const std::vector<double>& values, double start,
               double end = INFINITY) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (time[k] < start || time[k] >= end) continue;
    sum += values[k];
    ++count;
  }
  return sum / count;
}

TEST_P(Example, IsCopiedCheckedAndRun) {
  const std::string& name = GetParam();
  // Smaller beds where pouring takes long; what readable.py looks at.
  const std::map<std::string, std::string> more = {
      {"lander",
       "--set particles.box.size=[3.2,3.2] --set particles.box.depth=0.2 --set particles.box.radius=0.05"
       " --set particles.box.zones.0.size=[0.4,0.4] --set particles.box.zones.0.depth=0.06 --set "
       "particles.box.pour.settle_time=0.05 --ranks 1 --until 0.01"},
      {"drop", app::kSmallSphere.substr(app::kSmallSphere.find(" --set")) + " --until 0.05"},
      {"flexible_rake", "--set particles.bed.variables.depth=0.06 --until 0.005"},
      {"wheel", "--set particles.box.frame_interval=0.01 --set output.vtk_interval=0.01 --until 0.04"}};
  const app::Folder folder("example_" + name);
  folder.done("new " + name + " --from " + name);
  EXPECT_EQ(app::lines_of(folder.read(name + "/README.md")), 3);
  EXPECT_EQ(folder.footfall("new " + name + " --from " + name).exit_code, 2) << "nothing is written over";
  folder.done("check " + name);
  const auto options = more.find(name);
  const std::string out = app::shared_run(name);
  folder.done("run " + name + " --quiet --force --out " + out + " " +
                  (options == more.end() ? "--until 0.05" : options->second),
              600);
  EXPECT_TRUE(holds(folder.command("cat " + out + "/summary.json", 10).text, "\"status\": \"done\""));
  const std::string log = folder.command("cat " + out + "/liggghts.log", 10).text;
  EXPECT_FALSE(holds(log, "inputs/regolith") || holds(log, "inputs/dropped"))
      << "the copy needs no files of the program";
}

std::vector<std::string> examples() {
  std::vector<std::string> names;
  for (const CaseKind& kind : case_kinds()) names.push_back(kind.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(All, Example, ::testing::ValuesIn(examples()),
                         [](const auto& tested) { return tested.param; });

// A plate above a small bed; above the plate grains come into being, 1000 a second for 50 ms, and others vanish below it.
const std::string kFountain = R"(end_time = 0.08
gravity = [0, 0, -9.81]
[[bodies]]
name = "plate"
mass = 1.0
shape = { kind = "disc", centre = [0, 0, 0.05], radius = 0.03, thickness = 0.01 }
[[joints]]
name = "weld"
kind = "fixed"
bodies = ["ground", "plate"]
point = [0, 0, 0.05]
[[boundaries]]
body = "plate"
surface = {}
[ground]
kind = "particles"
[output]
vtk = false
plots = false
[particles.box]
size = [0.2, 0.2]
depth = 0.04
radius = 0.008
headroom = 0.4
[[particles.box.sources]]
region = [[-0.08, -0.08, 0.25], [0.08, 0.08, 0.35]]
grains_per_second = 1000
velocity = [0, 0, -1]
from = 0.01
until = 0.06
)";
const std::string kDrain = "[[particles.box.sinks]]\nregion = [[0.05, -0.1, -0.04], [0.1, 0.1, 0]]\nfrom = 0.02\n";

// A run with two checkpoints against the run that is resumed from the first: history, surfaces, pictures, energies of grains and the second
// checkpoint are equal byte by byte, but for wall-clock times.
struct Resumed {
  const char* name;
  std::string line;
};
void PrintTo(const Resumed& r, std::ostream* out) { *out << r.name; }

class Resume : public ::testing::TestWithParam<Resumed> {
 protected:
  static std::string without_clock(const std::string& path) {
    const bool all = fs::path(path).filename() != "run.txt" && fs::path(path).filename() != "summary.json";
    std::ifstream file(path, std::ios::binary);
    std::string text, line;
    while (std::getline(file, line))
      if (all || !std::regex_search(line, std::regex("wall|times/|_seconds|waited"))) text += line + "\n";
    return text;
  }
};

TEST_P(Resume, ReproducesTheRun) {
  const app::Folder folder(std::string("resume_") + GetParam().name);
  folder.write("fountain.toml", kFountain + kDrain);
  folder.done("run " + GetParam().line + " --set output.plots=false --out run --quiet", 300);
  std::vector<long> sets;
  for (const auto& entry : fs::directory_iterator(folder.file("run/checkpoint")))
    sets.push_back(std::stol(entry.path().filename()));
  ASSERT_EQ(sets.size(), 2u);
  fs::copy(folder.file("run"), folder.file("straight"), fs::copy_options::recursive);
  fs::remove_all(folder.file("run/checkpoint/" + std::to_string(std::max(sets[0], sets[1]))));
  folder.done("run --resume run --quiet", 300);
  int compared = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.file("straight"))) {
    const std::string file = fs::relative(entry.path(), folder.file("straight")), name = entry.path().filename();
    if (!entry.is_regular_file() || name[0] == '.' || name.rfind("liggghts", 0) == 0 || name == "ledger.csv" ||
        name == "checksums.txt" || name == "start.json")
      continue;
    EXPECT_TRUE(without_clock(entry.path()) == without_clock(folder.file("run/" + file))) << file << " differs";
    ++compared;
  }
  EXPECT_GT(compared, 3);
  EXPECT_GT(app::lines_of(folder.read("run/history.csv")), 10);
  EXPECT_EQ(folder.summary("run")["status"], "done");
}

// A look of the sink falls on each checkpoint.
TEST(Sink, RemovesGrainsAlsoWhereEveryLookIsACheckpoint) {
  const app::Folder folder("sink_checkpoints");
  folder.write("fountain.toml", kFountain + kDrain);
  const std::string run =
      "run fountain.toml --quiet --set particles.box.exchange_steps=14";  // 1 ms: the period of looks
  folder.done(run + " --out without");
  folder.done(run + " --set output.checkpoint_interval=1e-6 --out with");
  EXPECT_EQ(folder.summary("with")["particles"], folder.summary("without")["particles"]);
}

// Atoms by the log of LIGGGHTS, at its rows.
std::vector<std::pair<long, long>> atoms_in(const std::string& log) {
  std::vector<std::pair<long, long>> rows;
  std::istringstream lines(log);
  bool table = false;
  for (std::string line; std::getline(lines, line);) {
    long step = 0, atoms = 0;
    std::istringstream words(line), numbers(line);
    std::string first, second;
    if (words >> first >> second && first == "Step" && second == "Atoms")
      table = true;
    else if (table && numbers >> step >> atoms)
      rows.emplace_back(step, atoms);
  }
  return rows;
}

// Grains of 6 and 10 mm (2 and 11 g) at 0.6 kg/s, one or two in a batch: what has come differs from the rate by less than two of the
// larger ones, however many batches came.
TEST(Source, OfTwoSizesHasItsMass) {
  const app::Folder folder("two_sizes");
  std::string scene = kFountain;
  const auto change = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(scene.find(from), std::string::npos) << from;
    scene.replace(scene.find(from), from.size(), to);
  };
  change("end_time = 0.08", "end_time = 0.67");
  change("vtk = false", "vtk = true\nvtk_interval = 0.67");
  change("radius = 0.008", "radius = [0.006, 0.01]\nshares = [0.5, 0.5]\nframe_interval = 0.03");
  change("grains_per_second = 1000", "rate = 0.6");
  change("until = 0.06", "until = 0.61");
  folder.write("scene.toml", scene);
  folder.done("run . --out run --quiet --ranks 1", 300);
  const auto mass = [](const BedFrame& frame) {
    double sum = 0.0;
    for (const double r : frame.radius) sum += 2600 * 4.0 / 3.0 * M_PI * r * r * r;
    return sum;
  };
  const double largest = 2600 * 4.0 / 3.0 * M_PI * 1e-6, dt = folder.summary("run")["dt_dem_s"].get<double>();
  const std::map<long, std::string> frames = find_bed_frames(folder.file("run"));
  const double first = mass(read_bed_frame(frames.begin()->second));
  for (const auto& [step, file] : frames) {
    const double t = std::min(static_cast<double>(step) * dt, 0.61), rate = 0.6;
    const double come = mass(read_bed_frame(file)) - first;
    // A batch comes every 10 ms at most.
    EXPECT_LT(come, std::max(0.0, rate * (t - 0.01)) + 2.0 * largest) << t;
    EXPECT_GT(come, rate * (t - 0.01 - 0.011) - 2.0 * largest) << t;
  }
  EXPECT_NEAR(mass(read_bed_frame(frames.rbegin()->second)) - first, 0.6 * 0.6, 2.0 * largest);
}

// A block whose edge has a further corner next to its end, so that two of its triangles have angles of 0.17 degrees, as CAD programs write them.
TEST(Box, TakesNeedlesOfACadMesh) {
  const app::Folder folder("needles");
  folder.write(
      "block.obj",
      "v 0 0 0.08\nv 0.06 0 0.08\nv 0.06 0.06 0.08\nv 0 0.06 0.08\nv 0 0 0.02\nv 0.06 0 0.02\nv 0.06 0.06 0.02\n"
      "v 0 0.06 0.02\nv 0.00018 0 0.08\n"
      "f 1 9 4\nf 9 2 4\nf 2 3 4\nf 5 6 2\nf 5 2 9\nf 5 9 1\nf 6 7 3\nf 6 3 2\nf 7 8 4\nf 7 4 3\nf 8 5 1\nf 8 1 4\n"
      "f 5 8 7\nf 5 7 6\n");
  std::string scene = kFountain.substr(0, kFountain.find("[[particles.box.sources]]"));
  const std::string disc = "{ kind = \"disc\", centre = [0, 0, 0.05], radius = 0.03, thickness = 0.01 }";
  scene.replace(scene.find(disc), disc.size(), "{ kind = \"mesh\", file = \"block.obj\" }");
  folder.write("scene.toml", scene);
  folder.done("run . --quiet --until 0.005 --out run", 300);
  EXPECT_EQ(folder.summary("run")["status"], "done");
}

// Of 1000 grains a second from 10 ms on as many have come as are due, less the grains of one interval of 10 ms; 50 in the end.
TEST(Source, HasItsRateToTheGrainAndTheLedgerCloses) {
  const double m = 2600 * 4.0 / 3.0 * M_PI * std::pow(0.008, 3), g = 9.81;
  for (const int ranks : {1, 2}) {
    const app::Folder folder("fountain_" + std::to_string(ranks));
    folder.write("scene.toml", kFountain);
    folder.write("drained.toml", kFountain + kDrain);
    const std::string options = " --quiet --ranks " + std::to_string(ranks);
    folder.done("run . --out run" + options, 300);
    const std::vector<std::pair<long, long>> rows = atoms_in(folder.read("run/liggghts.log"));
    ASSERT_GT(rows.size(), 2u);
    const nlohmann::json summary = folder.summary("run");
    for (const auto& [step, atoms] : rows) {
      const double t = std::min(static_cast<double>(step) * summary["dt_dem_s"].get<double>(), 0.06);
      const double due = std::max(0.0, 1000 * (t - 0.01));
      EXPECT_LE(atoms - rows.front().second, due + 1e-6) << step;
      EXPECT_GE(atoms - rows.front().second, due - 11.0) << step;
    }
    EXPECT_EQ(summary["particles"].get<long>() - rows.front().second, 50);
    // Their energy: of 50 grains at 1 m/s between 0.258 and 0.342 m.
    const History ledger = read_history(folder.file("run/ledger.csv"));
    const double inserted = ledger.column("grains.inserted").back();
    EXPECT_GT(inserted, 50 * m * (0.5 + g * 0.258));
    EXPECT_LT(inserted, 50 * m * (0.5 + g * 0.342));
    // None of them has met anything until the end; the bed settles by some 4e-4 J. In no row is a batch of ten missing, nor one
    // grain (8 mJ).
    for (const double dissipated : ledger.column("grains.dissipated")) EXPECT_NEAR(dissipated, 0.0, 1e-3);

    folder.done("run drained.toml --out drained" + options, 300);
    const long left = rows.front().second + 50 - folder.summary("drained")["particles"].get<long>();
    EXPECT_GT(left, 20);  // of the bed in the sink
    // They lie within the depth of the bed.
    const History drained = read_history(folder.file("drained/ledger.csv"));
    EXPECT_GT(drained.column("grains.left").back(), 0.0);
    EXPECT_LT(drained.column("grains.left").back(), static_cast<double>(left) * m * g * 0.04);
    EXPECT_EQ(folder.summary("drained")["grains_lost"], 0);
    // Stock LIGGGHTS, which has neither style, replays the motion over the bed of the start.
    const test::Outcome replay = folder.done("compare drained", 300);
    EXPECT_TRUE(holds(replay.text, "sources and sinks")) << replay.text;
  }
}

// Grains fall into an open tray of M = 50 kg, which a force bears and a guide leads along z, so that its momentum is the impulse of
// the grains, exactly. A grain of mass m that comes at t_i with v_0 and lies in the tray at the end has given it m (v_0 + g (T -
// t_i)), however it fell and bounced; it goes along with the tray.
TEST(Source, GivesItsMomentumAndWeightToWhatCatchesIt) {
  const app::Folder folder("tray");
  const double m = 2600 * 4.0 / 3.0 * M_PI * std::pow(0.008, 3), g = 9.81, M = 50.0, end = 0.6, from = 0.01,
               rate = 400.0;
  const int grains = 80;
  folder.write("tray.obj",
               "v -0.09 -0.09 0.06\nv 0.09 -0.09 0.06\nv 0.09 0.09 0.06\nv -0.09 0.09 0.06\n"
               "v -0.09 -0.09 0.18\nv 0.09 -0.09 0.18\nv 0.09 0.09 0.18\nv -0.09 0.09 0.18\n"
               "f 1 2 3\nf 1 3 4\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n");
  folder.write("scene.toml", R"(end_time = 0.6
gravity = [0, 0, -9.81]
bodies = [{ name = "tray", mass = 50, inertia = [1, 1, 1], position = [0, 0, 0.1] }]
joints = [{ name = "guide", kind = "prismatic", bodies = ["ground", "tray"], point = [0, 0, 0.1], axis = "z" }]
forces = [{ name = "bears", body = "tray", direction = [0, 0, 1], force = { polynomial = [490.5] } }]
boundaries = [{ body = "tray", surface = { file = "tray.obj" } }]
[ground]
kind = "particles"
[output]
vtk = false
plots = false
[particles.box]
size = [0.24, 0.24]
depth = 0.034
radius = 0.008
headroom = 0.4
[[particles.box.sources]]
region = [[-0.07, -0.07, 0.25], [0.07, 0.07, 0.36]]
grains_per_second = 400
velocity = [0, 0, -1]
from = 0.01
until = 0.21
)");
  folder.done("run . --out run --quiet --ranks 1", 300);
  const History run = read_history(folder.file("run/history.csv"));
  const double v = run.column("tray.vz").back();
  double given = 0.0;
  for (int i = 1; i <= grains; ++i) given += m * (1.0 + g * (end - from - i / rate));
  // Grains come in batches every 10 ms at most, 5 ms late in the mean: g 5 ms of 4.9 m/s is 1 %; what still rolls bounces by some cm/s.
  EXPECT_NEAR(-(M + grains * m) * v, given, 0.02 * given);
  EXPECT_EQ(folder.summary("run")["particles"].get<long>(),
            atoms_in(folder.read("run/liggghts.log")).front().second + grains);
  // Its force at the end is their weight.
  const double mean = -mean_of(run.column("time"), run.column("tray.contact.fz"), 0.5);
  EXPECT_NEAR(mean, grains * m * g, 0.1 * grains * m * g);  // of rows, between which it rattles
}

// A pendulum of 1 s, and another from the end of its first half: the same motion, with a body more.
TEST(StartFromARun, ContinuesItsMotionWithABodyMore) {
  const app::Folder folder("start_from");
  const std::string rod =
      "end_time = END\noutput = { plots = false, vtk = false }\n[[bodies]]\nname = \"rod\"\nmass = 1.0\n"
      "shape = { kind = \"rod\", from = [0, 0, 0], to = [0.5, 0, 0], diameter = 0.02 }\n"
      "[[joints]]\nname = \"hinge\"\nkind = \"revolute\"\nbodies = [\"ground\", \"rod\"]\npoint = [0, 0, 0]\n"
      "axis = \"y\"\n";
  const auto until = [&](const std::string& end) { return std::regex_replace(rod, std::regex("END"), end); };
  folder.write("whole.toml", until("2.0"));
  folder.write("first.toml", until("1.0"));
  folder.write("second.toml", until("1.0") +
                                  "[[bodies]]\nname = \"ball\"\nmass = 1.0\n"
                                  "shape = { kind = \"sphere\", centre = [3, 0, 0], radius = 0.1 }\n"
                                  "[initial]\nfrom = \"first\"\nvelocity = [0, 0, 2]\n");
  for (const char* name : {"whole", "first", "second"})
    folder.done("run " + std::string(name) + ".toml --quiet --out " + name);
  const History whole = read_history(folder.file("whole/history.csv")),
                second = read_history(folder.file("second/history.csv"));
  // At the instant of the start to all digits of the file, later to the tolerance of the integrator.
  const std::size_t half = whole.columns[0].size() / 2;
  for (const char* name : {"rod.x", "rod.z", "rod.vx", "rod.vz", "rod.wy", "hinge.angle"}) {
    EXPECT_NEAR(second.column(name).front(), whole.column(name)[half], 1e-6) << name;
    EXPECT_NEAR(second.column(name).back(), whole.column(name).back(), 1e-4) << name;
  }
  EXPECT_NEAR(second.column("ball.vz").front(), 2.0, 1e-12);
  folder.write("other.toml", "base = \"second.toml\"\n[initial]\nsettle = true\n");
  folder.refused("check other.toml", "E0140");
  folder.write("none.toml", "base = \"second.toml\"\n[initial]\nfrom = \".\"\n");
  folder.refused("check none.toml", "E0263");
}

// What the pages say of the small scenes.
TEST(SmallScenes, HaveTheNumbersOfTheirPage) {
  const app::Folder folder("small_scenes");
  for (const char* name : {"winch", "tripod", "hopping_leg"}) {
    folder.done("new " + std::string(name) + " --from " + name);
    folder.done("run " + std::string(name) + " --quiet --set output.vtk=false --set output.plots=false --out run_" +
                name);
  }
  const History winch = read_history(folder.file("run_winch/history.csv"));
  // The swing adds less than 2 % to the mean; the drum takes up 0.05 m times 4 rad/s from 0.5 s on, and half of it before.
  EXPECT_NEAR(mean_of(winch.columns[0], winch.column("rope.force"), 1.0), 98.1, 2.0);
  EXPECT_NEAR(winch.column("rope.length").front() - winch.column("rope.length").back(), 0.2 * 3.75, 0.005);
  const History tripod = read_history(folder.file("run_tripod/history.csv"));
  double weight = 0.0;
  for (const char* foot : {"foot_1", "foot_2", "foot_3"})
    weight += tripod.column(std::string(foot) + ".contact.fz").back();
  EXPECT_NEAR(weight, 60 * 1.62, 1.0);
  EXPECT_EQ(folder.summary("run_tripod")["requirements_missed"], 0);
  const History hop = read_history(folder.file("run_hopping_leg/history.csv"));
  double highest = -1e9;  // of the last second: it still flies
  for (std::size_t i = 0; i < hop.columns[0].size(); ++i)
    if (hop.columns[0][i] > 2.0) highest = std::max(highest, hop.column("foot.z")[i]);
  EXPECT_GT(highest, 0.08);
}

// The scenes of grains in their own numbers, in the numbers of their page, and each in a balance. Nothing is to be told: contacts stay below 5 % of a radius.
TEST(SmallScenes, OfGrainsBalance) {
  const app::Folder folder("small_scenes_of_grains");
  const auto run = [&](const std::string& name) {
    folder.done("run " + app::kInputs + "/starters/" + name +
                    " --quiet --ranks 1 --set output.vtk=false --set output.plots=false --out " + name,
                900);
    EXPECT_EQ(folder.summary(name)["warnings"].size(), 0u) << name << folder.summary(name)["warnings"];
    return read_history(folder.file(name + "/history.csv"));
  };
  const double g = 9.81;

  // Penetrator: the guide carries nothing along z, so the momentum of rod and hammer is the impulse of grains and weight. The
  // impulse is a sum over rows of means of coupling intervals that are as long: 2 % of the weight's.
  const History rod = run("penetrator");
  const std::vector<double>&t = rod.column("time"), &fz = rod.column("rod.contact.fz"), &z = rod.column("rod.z");
  double impulse = 0.0;
  for (std::size_t k = 1; k < t.size(); ++k) impulse += 0.5 * (fz[k] + fz[k - 1]) * (t[k] - t[k - 1]);
  const double momentum = 0.8 * rod.column("rod.vz").back() + 2.0 * rod.column("hammer.vz").back();
  const double weight = 2.8 * g * t.back();
  EXPECT_NEAR(impulse - weight, momentum, 0.02 * weight);
  // Each blow by hand: the hammer falls freely from its highest place to the anvil, v^2 = 2 g H. What it and the rod lose until the
  // rod is deepest, E = M g (H + s) + m g s, is the work of the grains over the set s, but for what the anvil takes: at most the energy of a
  // plastic impact, M g H m / (M + m).
  const std::vector<double>&speed = rod.column("hammer.vz"), &height = rod.column("hammer.z");
  int blows = 0;
  for (std::size_t k = 300; k + 150 < t.size();) {
    if (!(speed[k - 1] < -0.6 && speed[k] > speed[k - 1] + 0.25)) {
      ++k;
      continue;
    }
    // Its contact lasts for some rows: before it the hammer is fastest.
    const auto fastest =
        std::min_element(speed.begin() + static_cast<long>(k) - 3, speed.begin() + static_cast<long>(k)) -
        speed.begin();
    const double v = -speed[fastest],
                 H = *std::max_element(height.begin() + fastest - 200, height.begin() + fastest) - height[fastest];
    EXPECT_NEAR(v, std::sqrt(2.0 * g * H), 0.03 * v) << t[k];  // a row is 0.7 % of it
    const auto deepest = static_cast<std::size_t>(
        std::min_element(z.begin() + static_cast<long>(k), z.begin() + static_cast<long>(k) + 150) - z.begin());
    const double set = z[k - 1] - z[deepest], E = 2.0 * g * (H + set) + 0.8 * g * set;
    double work = 0.0;
    for (std::size_t i = k; i <= deepest; ++i) work += 0.5 * (fz[i] + fz[i - 1]) * (z[i - 1] - z[i]);
    EXPECT_GT(work, E - 2.0 * g * H * 0.8 / 2.8 - 0.1 * E) << t[k];  // rows of a mean force: 10 %
    EXPECT_LT(work, 1.1 * E) << t[k];
    ++blows;
    k += 150;
  }
  EXPECT_EQ(blows, 3);
  // Under its weight by 24 mm, by three blows to 88 mm; another bed may differ by a grain's radius or two.
  EXPECT_NEAR(z.front() - z[static_cast<std::size_t>(0.3 / t[1])], 0.024, 0.012);
  EXPECT_NEAR(z.front() - z.back(), 0.088, 0.02);

  // Blade: where it is deepest, the grains resist by more than Rankine's passive pressure on a wide wall, K_p rho g d^2 b / 2,
  // phi = 33 degrees, d = 61 mm, and by less than twelve times that: it is only three grains deep, lifts what is next to it and
  // pushes a heap.
  const History blade = run("blade");
  const double force = -mean_of(blade.column("time"), blade.column("blade.contact.fx"), 0.38, 0.5);
  const double depth = folder.summary("blade")["max_sinkage_m"].get<double>();
  const double passive = 0.5 * 3.4 * 2600 * 0.6 * g * depth * depth * 0.16;
  EXPECT_GT(force, passive);
  EXPECT_LT(force, 12.0 * passive);

  // Seesaw: the board leaves its stop when the grains on it turn it by as much as counterweight and friction hold, g (0.5 kg 0.1 m -
  // 0.3 kg 0.02 m) + 0.01 N m. Means of 0.1 s, in which the source adds 0.6 N times 0.1 m: within 20 %.
  const History board = run("seesaw");
  const std::vector<double>&angle = board.column("hinge.angle"), &time = board.column("time");
  std::vector<double> turning;
  for (std::size_t k = 0; k < time.size(); ++k)
    turning.push_back(board.column("board.contact.my")[k] -
                      board.column("board.x")[k] * board.column("board.contact.fz")[k] +
                      (board.column("board.z")[k] - 0.15) * board.column("board.contact.fx")[k]);
  std::size_t tips = 0;
  while (tips + 1 < angle.size() && angle[tips] < 0.01) ++tips;
  EXPECT_NEAR(mean_of(time, turning, time[tips] - 0.1, time[tips]), g * (0.5 * 0.1 - 0.3 * 0.02) + 0.01, 0.09);
  EXPECT_NEAR(time[tips], 1.0, 0.15);
  EXPECT_GT(*std::max_element(angle.begin(), angle.end()), 0.5);
  EXPECT_LT(angle.back(), 0.05);  // it has returned
}

const std::string kSphere =
    app::kSmallSphere + " --until 0.07 --set output.vtk=true --set output.checkpoint_interval=0.02";
INSTANTIATE_TEST_SUITE_P(
    Runs, Resume,
    ::testing::Values(
        Resumed{"mechanism", app::kInputs + "/rigid_plane --until 0.1 --set output.checkpoint_interval=0.03" +
                                 " --set output.vtk=true --set flexible=false"},
        Resumed{"flexible", app::kInputs + "/rigid_plane --until 0.1 --set output.checkpoint_interval=0.03"},
        Resumed{"ida",
                app::kInputs + "/rigid_plane --until 0.014 --integrator ida --set output.checkpoint_interval=0.005"},
        Resumed{"contacts", app::kSource + "/tests/app/stack.toml --set output.checkpoint_interval=0.12"},
        // A checkpoint at 12 ms: the plate is partly off the bed, and leaves the box of the grains at 21 ms.
        Resumed{"beside_the_bed", app::kPlate + " --until 0.03 --set output.checkpoint_interval=0.012 --set " +
                                      "initial.velocity=[12,0,0.4] --set particles.script='\"" + app::kPlate +
                                      "/beside.in\"' --set particles.bed.script='\"" + app::kPlate + "/bed.in\"'"},
        Resumed{"grains", kSphere}, Resumed{"two_ranks", kSphere + " --ranks 2"},
        Resumed{"tangent", kSphere + " --scheme tangent"},
        Resumed{"source", "fountain.toml --set output.checkpoint_interval=0.03"},
        Resumed{"source_on_two_ranks", "fountain.toml --ranks 2 --set output.checkpoint_interval=0.03"},
        Resumed{"chosen_windows",
                kSphere + " --set particles.variables.every=auto --set output.checkpoint_interval=0.03"},
        Resumed{"box", app::kExamples + "/02_wheel --until 0.05 --set output.checkpoint_interval=0.02" +
                           " --set particles.box.frame_interval=0.01"},
        Resumed{"follow", app::kSource + "/tests/app/follow.toml --set output.checkpoint_interval=0.12" +
                              " --set particles.box.frame_interval=0.1"},
        Resumed{"follow_on_two_ranks",
                app::kSource + "/tests/app/follow.toml --ranks 2 --set output.checkpoint_interval=0.12"},
        // At the checkpoint of 0.28 s LIGGGHTS asks for new neighbour lists, as its mesh has moved by half the skin.
        Resumed{"follow_where_its_mesh_asks_for_lists",
                app::kSource + "/tests/app/follow.toml --set output.checkpoint_interval=0.04"},
        // At the checkpoint of 0.6 s most of the wheel is beyond the first box.
        Resumed{"follow_beyond_the_box",
                app::kSource + "/tests/app/follow.toml --set end_time=0.85" + " --set output.checkpoint_interval=0.2"},
        Resumed{"clumps", app::kSource + "/tests/app/clumps.toml --set output.checkpoint_interval=0.02"},
        Resumed{"bent_mesh",
                app::kSource + "/tests/app/bent_rod.toml --ranks 2 --set output.checkpoint_interval=0.09"}),
    [](const auto& tested) { return std::string(tested.param.name); });

// By hand a script may have several runs. What a wall-clock checkpoint holds for a resumed run must not come back when the
// next `run` is set up: checkpoints change no bit.
TEST(ResumeByHand, WithSeveralRunsIsNotChangedByCheckpoints) {
  const app::Folder folder("resume_by_hand");
  const std::string box = "include " + app::kPlate + "/box.lammps\n",
                    bed = "include " + app::kPlate + "/from_bed.lammps\n";
  const std::string couple = "include " + app::kPlate + "/couple.lammps\n";
  folder.write("stop.sh",
               "p=$PPID\nwhile [ \"$(cat /proc/$p/comm)\" != liggghts_mbd ]; do p=$(cut -d' ' -f4 "
               "/proc/$p/stat); done\nkill -TERM $p\n");
  folder.write("in.first", box + couple + "run 120\nshell sh stop.sh\nrun 1000000\n");  // the plate touches at step 100
  folder.write("in.second", bed + couple + "run 13\nrun 1000000\n");                    // in contact, within a window
  const auto both = [&](const std::string& script, const std::string& solver) {
    return folder.mpirun("-np 1 " + test::RunFolder::program("liggghts_mbd") + " -screen none -log none -in " + script +
                         " : -np 1 " + test::RunFolder::program("mbd_solver") + " --quiet " + solver);
  };
  const std::string scene = app::kPlate + "/scene.toml --until 0.03";
  ASSERT_EQ(both("in.first", scene + " --keep-every 1000 --out without").exit_code, 3);
  fs::copy(folder.file("without"), folder.file("with"), fs::copy_options::recursive);
  const std::string restart =
      fs::path(folder.shell("ls $PWD/without/checkpoint/*/grains.restart").text).parent_path().filename();
  for (const std::string out : {"without", "with"}) {
    const test::Outcome resumed = both("in.second -var bed " + out + "/checkpoint/" + restart + "/grains.restart",
                                       "--resume " + out + " --keep-every " + (out == "with" ? "1e-6" : "0"));
    EXPECT_EQ(resumed.exit_code, 0) << resumed.text;
  }
  EXPECT_TRUE(folder.read("without/history.csv") == folder.read("with/history.csv"));
  EXPECT_EQ(folder.summary("with")["status"], "done");
}

TEST(Tolerance, AloneMakesARunMoreExact) {
  const app::Folder folder("tolerance");
  const auto end = [&](const std::string& integrator, const std::string& rtol) {
    const std::string out = integrator + rtol;
    folder.command(test::RunFolder::program("mbd_solver") + " " + app::kSliderCrank + " --quiet --out " + out +
                       " --integrator " + integrator + " --set solver.rtol=" + rtol + " --set solver.max_step=1",
                   60);
    const History history = read_history(folder.file(out + "/history.csv"));
    return Eigen::Vector3d(history.columns[1].back(), history.columns[2].back(), history.columns[3].back());
  };
  const Eigen::Vector3d reference = end("one_step", "1e-11");
  for (const std::string integrator : {"one_step", "ida"}) {
    double last = 1.0;
    for (const std::string rtol : {"1e-4", "1e-6", "1e-8", "1e-10"}) {
      const double error = (end(integrator, rtol) - reference).cwiseAbs().maxCoeff();  // [m], of a mechanism of 1 m
      EXPECT_LT(error, 100.0 * std::stod(rtol)) << integrator << " " << rtol;
      EXPECT_TRUE(error < 0.3 * last || error < 1e-9)
          << integrator << " " << rtol << ": " << error << " after " << last;
      last = error;
    }
  }
}

}  // namespace
}  // namespace footfall
