// Studies: sweeps, error against run time, calibrations and rigs resume where they were interrupted and give the tables of uninterrupted
// ones. The studies of inputs/ are run by CMakeLists.txt.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "tests/app/programs.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using app::holds;

class Study : public ::testing::Test {
 protected:
  const app::Folder folder{"study"};

  // Eight runs of a ball that falls on the plane, in a few milliseconds each.
  void write_sweep(const std::string& name, const std::string& column = "ball.z",
                   const std::string& key = "peak_acceleration_g") const {
    folder.write("ball.toml", R"(end_time = 0.1
[[bodies]]
name = "ball"
mass = 1.0
shape = { kind = "sphere", centre = [0, 0, 0.12], radius = 0.1 }
[[boundaries]]
body = "ball"
surface = { element_size = 0.05 }
[ground]
kind = "plane"
plane = { stiffness = 1e5, damping = 1.0, friction = 0.3 }
[output]
plots = false
)");
    folder.write(name, R"(scene = "ball.toml"
until = 0.05
minimise = "peak acceleration [g]"
[[parameters]]
name = "speed"
settings = ["initial.velocity=[0,0,-{value}]"]
values = [1, 2, 3, 4]
[[parameters]]
name = "friction"
ensemble = true
settings = ["ground.plane.friction={value}"]
values = [0.2, 0.5]
[[figures]]
name = "peak acceleration [g]"
key = ")" + key + R"("
[[figures]]
name = "end [m]"
columns = [")" + column + R"("]
reduce = "final"
[[plots]]
name = "height"
column = "ball.z"
title = "Height"
[[statements]]
text = "a faster fall hits harder"
figure = "peak acceleration [g]"
case = "speed 4"
against = "speed 1"
least = 1.5
[[statements]]
text = "the slowest fall hits hardest"
figure = "peak acceleration [g]"
case = "speed 1"
against = "speed 4"
least = 1
why = "it does not"
)");
  }
  // Names of the runs that are done, with the time and the number of their files.
  std::set<std::string> records(const std::string& study) const {
    std::set<std::string> found;
    if (!folder.has(study + "/runs")) return found;
    const std::string listed =
        folder.command("find " + study + "/runs -name '*.done.json' -printf '%f %i %T@\\n'", 10).text;
    std::istringstream lines(listed);
    for (std::string line; std::getline(lines, line);) found.insert(line);
    return found;
  }
  // Ends a study with a signal once so many runs are done; its exit code.
  int stopped(const std::string& line, const std::string& study, std::size_t runs, const std::string& signal) const {
    const std::string program = test::RunFolder::program("footfall") + " " + line;
    return folder
        .shell(program + " > part.txt 2>&1 & study=$!; for ((k = 0; k < 2000; ++k)); do " + "(($(find " + study +
                   " -name \"*.done.json\" 2>/dev/null | wc -l) >= " + std::to_string(runs) +
                   ")) && break; kill -0 $study 2>/dev/null || break; sleep 0.02; done; kill -" + signal +
                   " $study; wait $study; code=$?; sleep 0.3; exit $code",
               120)
        .exit_code;
  }
  void expect_same(const std::string& a, const std::string& b, std::initializer_list<const char*> files) const {
    for (const std::string file : files)
      EXPECT_TRUE(folder.read(a + "/" + file) == folder.read(b + "/" + file)) << b << "/" << file;
  }
};

TEST_F(Study, OfASweepResumesWhereItWasStopped) {
  write_sweep("sweep.toml");
  folder.done("sweep sweep.toml --out whole");
  EXPECT_EQ(records("whole").size(), 8u);
  EXPECT_EQ(stopped("sweep sweep.toml --out parts --jobs 2", "parts", 2, "INT"), 3);
  EXPECT_EQ(stopped("sweep sweep.toml --out parts --jobs 2", "parts", 4, "KILL"), 137);
  const std::set<std::string> before = records("parts");
  folder.done("sweep sweep.toml --out parts");
  const std::set<std::string> after = records("parts");
  EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()))
      << "finished runs were done again";
  expect_same("whole", "parts", {"runs.csv", "cases.csv", "samples.csv"});
  // What was expected, and whether it was reproduced.
  EXPECT_TRUE(
      std::regex_search(folder.read("whole/statements.csv"), std::regex("\na faster fall hits harder.*,yes\n")));
  EXPECT_TRUE(
      std::regex_search(folder.read("whole/statements.csv"), std::regex("\nthe slowest fall hits hardest.*,no\n")));
  EXPECT_TRUE(holds(folder.read("whole/statements.md"), "it does not"));
  folder.done("report whole");
  EXPECT_TRUE(holds(folder.read("whole/report.html"), "speed_4__friction_0.5"));
  // The values of the ensemble are samples of a case.
  EXPECT_TRUE(holds(folder.read("whole/samples.csv"), "speed 4,runs/speed_4__friction_0.5\n"));
  EXPECT_TRUE(holds(folder.read("whole/height.gp"), "with filledcurves"));
  folder.done("plot whole ball.z --out ball.png");
  EXPECT_TRUE(holds(folder.read("whole/plots/ball.z.gp"), "speed 4: mean and 5 to 95 % of 2"));
  folder.refused("plot whole ball.z --srs", "E0500");
  folder.done("report whole parts");
  EXPECT_TRUE(holds(folder.read("whole/difference.html"), "speed 4"));
}

TEST_F(Study, OfAJobArrayGivesTheSameTables) {
  write_sweep("sweep.toml");
  folder.done("sweep sweep.toml --out whole");
  folder.done("sweep sweep.toml --out array --slurm");
  EXPECT_TRUE(holds(folder.read("array/sweep.sbatch"), "--array=0-7"));
  const test::Outcome beds = folder.shell("eval \"$(sed -n 's/^# First.*the beds: *//p' array/sweep.sbatch)\"");
  EXPECT_TRUE(beds.exit_code == 0 && holds(beds.text, "beds made: 0")) << beds.text;
  for (int element = 0; element < 8; ++element)
    folder.done("sweep sweep.toml --out array --only " + std::to_string(element));
  folder.done("sweep sweep.toml --out array --merge");
  expect_same("whole", "array", {"runs.csv", "cases.csv"});
}

// --list reads files and prints: no bed, no folder, no file.
TEST_F(Study, OfASweepIsListedAndNothingIsMade) {
  write_sweep("sweep.toml");
  setenv("FOOTFALL_CACHE", folder.file("cache").c_str(), 1);
  std::vector<std::string> lines = {"sweep sweep.toml", "sweep sweep.toml --only 3", "rig plate --short",
                                    "accuracy " + app::kInputs + "/accuracy/bed_windows.toml --short"};
  if (fs::exists(test::RunFolder::program("footfall_campaign")))
    for (const char* line :
         {"ground fit @/ground_fits/regolith.toml --short", "sweep @/sweeps/touchdowns_on_grains.toml"})
      lines.push_back(std::regex_replace(std::string(line), std::regex("@"), app::kInputs));
  const std::string before = folder.shell("find . -printf '%p %y\\n' | sort").text;
  for (const std::string& line : lines) {
    const std::string listed = folder.done(line + " --list").text;
    EXPECT_TRUE(holds(listed, "     --set ")) << line << ": " << listed;
    EXPECT_EQ(folder.shell("find . -printf '%p %y\\n' | sort").text, before) << line;
  }
  EXPECT_EQ(folder.footfall("sweep sweep.toml --list --beds").exit_code, 2);
  unsetenv("FOOTFALL_CACHE");
}

// A column or a key that no run has is reported after the first run, which remains; so does everything except a damaged summary.
TEST_F(Study, OfASweepReportsWhatNoRunHas) {
  for (const auto& [column, key] :
       {std::pair("ball.q", "peak_acceleration_g"), std::pair("ball.z", "peak_acceleration")}) {
    write_sweep("wrong.toml", column, key);
    fs::remove_all(folder.file("typo"));
    const test::Outcome outcome = folder.footfall("sweep wrong.toml --out typo --jobs 1");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
    EXPECT_TRUE(holds(outcome.text, column == std::string("ball.q") ? "ball.q" : "peak_acceleration_g"))
        << outcome.text;
    EXPECT_EQ(records("typo").size(), 1u);
  }
  const std::set<std::string> first = records("typo");
  write_sweep("wrong.toml");
  folder.done("sweep wrong.toml --out typo");
  EXPECT_EQ(records("typo").count(*first.begin()), 1u) << "the first run was done again";

  const std::string cut = "typo/runs/speed_1__friction_0.2/summary.json";
  ASSERT_TRUE(folder.has(cut));
  folder.write(cut, folder.read(cut).substr(0, 300));
  folder.done("report typo");
  EXPECT_TRUE(holds(folder.read("typo/report.html"), "damaged"));
  EXPECT_LE(folder.footfall("sweep wrong.toml --out typo --merge").exit_code, 1);
  folder.done("sweep wrong.toml --out typo");
  EXPECT_TRUE(holds(folder.read(cut), "\"done\"")) << "the damaged run was not done again";
}

TEST_F(Study, OfErrorsResumesAndNoticesOtherSettings) {
  const std::string text = "scene = \"" + app::kSliderCrank + R"("
settings = ["output.plots=false"]
until = 0.02
[reference]
settings = ["solver.rtol=1e-6"]
[[curves]]
name = "time tolerance"
settings = ["solver.rtol={value}"]
values = [1e-3, 1e-4, 1e-6]
[[figures]]
name = "drift"
error = "itself"
key = "drift_position"
)";
  folder.write("small.toml", text);
  // Runs with the times of their summaries.
  const auto times = [&] { return folder.command("stat -c '%n %y' study/runs/*/summary.json", 10).text; };
  folder.done("accuracy small.toml --out study");
  const std::string first = times(), table = folder.read("study/small.csv");
  EXPECT_EQ(app::lines_of(first), 3) << "the reference is one of the values";
  EXPECT_TRUE(folder.has("study/runs/time_tolerance_0.001/summary.json")) << "no blanks: LIGGGHTS splits paths there";
  folder.done("accuracy small.toml --out study --resume");
  EXPECT_EQ(times(), first);
  EXPECT_EQ(folder.read("study/small.csv"), table);
  folder.write("small.toml", std::regex_replace(text, std::regex("until = 0.02"), "until = 0.03"));
  folder.done("accuracy small.toml --out study --resume");
  std::istringstream now(times());
  for (std::string line; std::getline(now, line);) EXPECT_FALSE(holds(first, line)) << "kept though it ends later now";
}

TEST_F(Study, OfConstantInputsIsBeatenByTheFuzzyController) {
  const std::string said = folder.done("sweep " + app::kInputs + "/sweeps/control_plane.toml --out sweep", 600).text;
  EXPECT_TRUE(holds(said, "control fuzzy\n")) << said;
}

// A set of parameters whose bed cannot be made has failed, and the calibration continues.
TEST_F(Study, OfACalibrationGoesOnWhereABedCannotBeMade) {
  folder.write("beds.toml", "scene = \"" + app::kInputs + R"(/dropped_sphere/scene.toml"
settings = ["bodies.ball.shape.radius=0.07", "particles.variables.width=0.42", "particles.bed.variables.width=0.42",
  "particles.bed.variables.depth=0.2", "particles.bed.variables.settle=0.5"]
until = 0.02
step = 0.1
[[figures]]
name = "depth [m]"
key = "max_sinkage_m"
[[targets]]
figure = "depth [m]"
value = 0.05
tolerance = 0.006
[[parameters]]
name = "bed_depth"
settings = ["particles.bed.variables.depth={value}"]
least = -0.6
most = 0.6
start = 0.2
[[stages]]
method = "direct"
evaluations = 3
)");
  folder.done("calibrate beds.toml --out run --jobs 2", 300);
  const std::string way = folder.read("run/way.csv");
  EXPECT_EQ(app::lines_of(way), 4) << way;
  EXPECT_EQ(app::count(way, "ERROR"), 2) << way;
  folder.done("calibrate beds.toml --out run --so-far");
}

// Some 200 runs, killed five times: no finished run is lost, and tables equal the undisturbed calibration's. The ledger alone, with
// scenes elsewhere, gives them without a run.
TEST_F(Study, OfACalibrationThatIsKilledFiveTimes) {
  fs::copy(app::kInputs + "/calibrations/strut", folder.file("strut"), fs::copy_options::recursive);
  std::string text = folder
                         .command("sed '/^\\[\\[stages\\]\\]/,$d; s|^step = .*|until = 0.05\\nalone = 3|' " +
                                      app::kInputs + "/calibrations/strut.toml",
                                  10)
                         .text;
  text += R"([[figures]]
name = "peak"
key = "peak_acceleration_g"
[[targets]]
name = "out of reach"
scene = "off"
figure = "peak"
least = 1e4
tolerance = 1e4
[[stages]]
method = "direct"
evaluations = 60
[[stages]]
method = "sbplx"
evaluations = 40
precision = 1e-9
[[stages]]
method = "surrogate"
evaluations = 12
)";
  folder.write("many.toml", text);
  folder.done("calibrate many.toml --out whole --jobs 1", 900);
  EXPECT_TRUE(std::regex_search(folder.read("whole/many.md"), std::regex("\n\\| out of reach \\|.* \\| 3 \\| ")))
      << "the target that cannot be met is sought alone";
  EXPECT_GE(records("whole").size(), 200u);
  std::set<std::string> known;
  for (std::size_t k = 1; k <= 5; ++k) {
    EXPECT_EQ(stopped("calibrate many.toml --out parts --jobs 2", "parts", 35 * k, "KILL"), 137);
    const std::set<std::string> now = records("parts");
    known.insert(now.begin(), now.end());
  }
  const std::string files = folder.command("find parts -type f -printf '%p %T@\\n' | sort", 10).text;
  folder.done("calibrate many.toml --out parts --so-far");
  EXPECT_EQ(folder.command("find parts -type f -printf '%p %T@\\n' | sort", 10).text, files) << "--so-far has written";
  EXPECT_EQ(folder.footfall("calibrate many.toml --out none --so-far").exit_code, 2);
  folder.done("calibrate many.toml --out parts --jobs 2", 900);
  const std::set<std::string> all = records("parts");
  EXPECT_TRUE(std::includes(all.begin(), all.end(), known.begin(), known.end())) << "finished runs were done again";
  expect_same("whole", "parts", {"way.csv", "best.txt", "most_met.txt", "parameters.csv", "targets.csv"});

  fs::create_directory(folder.file("moved"));
  fs::copy(folder.file("whole/numbers.jsonl"), folder.file("moved/numbers.jsonl"));
  fs::rename(folder.file("strut"), folder.file("elsewhere"));
  folder.write("moved.toml", std::regex_replace(text, std::regex("\"strut/"), "\"elsewhere/"));
  folder.done("calibrate moved.toml --out moved --jobs 2", 300);
  EXPECT_TRUE(records("moved").empty()) << "runs of the ledger were done again";
  expect_same("whole", "moved", {"way.csv"});
  std::string ledger = folder.read("moved/numbers.jsonl");
  const std::size_t line = ledger.find('\n') + 1;
  ledger.replace(line, ledger.find('\n', line) - line, "{\"scene\": 7}");
  folder.write("moved/numbers.jsonl", ledger);
  const test::Outcome damaged = folder.footfall("calibrate moved.toml --out moved");
  EXPECT_EQ(damaged.exit_code, 2);
  EXPECT_TRUE(holds(damaged.text, "numbers.jsonl:2")) << damaged.text;
}

// Rigs in their short forms: an answer for every bed; the same command again does no run again.
struct Rig {
  const char *name, *line;
};
void PrintTo(const Rig& rig, std::ostream* out) { *out << rig.name; }
class Rigs : public Study, public ::testing::WithParamInterface<Rig> {};

TEST_P(Rigs, AnswerInTheirShortForm) {
  const std::string line = std::string("rig ") + GetParam().line, name = line.substr(4, line.find(' ', 4) - 4);
  folder.done(line + " --short --out out", 300);
  for (const std::string end : {".md", ".csv", "_samples.csv", "_curves.csv"})
    EXPECT_TRUE(folder.has("out/" + name + end)) << end;
  const std::string page = folder.read("out/" + name + ".md");
  EXPECT_TRUE(holds(page, "| answer | unit | mean")) << page;
  if (name == "repose") {
    EXPECT_FALSE(holds(page, "not found")) << "a steep slope has points enough for a line";
  }
  const std::set<std::string> before = records("out");
  folder.done(line + " --short --out out", 300);
  EXPECT_EQ(records("out"), before);
}
INSTANTIATE_TEST_SUITE_P(
    Short, Rigs,
    ::testing::Values(Rig{"plate", "plate"}, Rig{"cone", "cone"}, Rig{"wheel", "wheel"}, Rig{"shear", "shear"},
                      Rig{"box", "box"}, Rig{"repose", "repose"}, Rig{"sphere", "sphere"}, Rig{"rft", "rft"},
                      Rig{"repose_of_clumps", "repose --samples 1 --set 'particles.box.clumps=[\"pair\"]'"},
                      Rig{"box_of_clumps_on_the_moon",
                          "box --samples 1 --gravity moon --set 'particles.box.clumps=[\"pair\"]'"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(Study, OfARigIsRefusedBeforeAnythingRuns) {
  const std::string rigs = app::kInputs + "/rigs";
  const auto write = [&](const std::string& name, const std::string& rig, const std::string& change) {
    folder.write(
        name, folder.command("sed -e 's#\"scenes/#\"" + rigs + "/scenes/#' -e '" + change + "' " + rigs + "/" + rig, 10)
                  .text);
  };
  write("own.toml", "plate.toml", "s/^values = \\[1, 2, 3\\]/values = [11, 12, 13]/");
  write("still.toml", "wheel.toml", "s/polynomial=\\[0,5\\]/polynomial=[0,0]/");
  const std::pair<const char*, const char*> lines[] = {
      {"plat", "\"plate\""},
      {"plate --gravity venus", "venus"},
      {"plate --set 'bodies.plate.shape.size=[1,1,1]'", "\"width\""},
      {"plate --set particles.box.seed=4", "\"seed\""},
      {"plate --file own.toml --samples 4 --list", "\"seed\""},
      {"plate --set particles.box.colour=3 --list", "colour"},
      {"plate --set particles.soil=mud --list", "\"mud\""},
      {"cone --file @/plate.toml --list", "\"cone\""},
      {"cone --set bodies.cone.shape.file=ring.stl --list", "cone.stl"},
      {"wheel --set 'joints.hub.motion.rotation={table=[[0,0],[1,2],[9,20]]}' --list", "\"hub\""},
      {"wheel --file still.toml --list", "wheel"},
      {"repose --set particles.box.frame_interval=0 --list", "particles.box.frame_interval"}};
  for (const auto& [line, names] : lines) {
    const test::Outcome outcome =
        folder.footfall("rig " + std::regex_replace(std::string(line), std::regex("@"), rigs));
    EXPECT_EQ(outcome.exit_code, 2) << line << ": " << outcome.text;
    EXPECT_TRUE(holds(outcome.text, names)) << line << ": " << outcome.text;
  }
}

}  // namespace
}  // namespace footfall
