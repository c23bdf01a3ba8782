// A run owns its folder: another run into it is refused while it lives and afterwards; --force removes what belongs to the earlier run and
// nothing of the user's. Damaged runs and checkpoints are reported with their files.
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "tests/app/programs.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using app::holds;

const std::string kShort = "run " + app::kSliderCrank + " --quiet --until 0.02";

class Folders : public ::testing::Test {
 protected:
  const app::Folder folder{"folders"};
  const std::string footfall = test::RunFolder::program("footfall") + " ";
  void write_own(const std::string& file) const {
    fs::create_directories(fs::path(folder.file(file)).parent_path());
    folder.write(file, "mine\n");
  }
};

TEST_F(Folders, KeepWhatIsTheUsers) {
  const std::string own[] = {"mine/notes.txt", "mine/plots/own.txt", "mine/pictures/own.txt", "mine/vtk/own.txt"};
  for (const std::string& file : own) write_own(file);
  folder.done(kShort + " --out mine --set output.plots=true");
  ASSERT_TRUE(folder.has("mine/plots/energy.png"));
  folder.done("report mine");
  folder.refused(kShort + " --out mine", "E0504");
  write_own("mine/vtk/later.txt");
  folder.done(kShort + " --out mine --force --set output.plots=false");
  EXPECT_FALSE(folder.has("mine/plots/energy.png")) << "of the earlier run";
  EXPECT_FALSE(folder.has("mine/report.html")) << "of the earlier run";
  for (const std::string& file : own) EXPECT_EQ(folder.read(file), "mine\n");
  EXPECT_EQ(folder.read("mine/vtk/later.txt"), "mine\n");

  write_own("here/notes.txt");
  EXPECT_EQ(folder.shell("cd here && " + footfall + kShort + " --out .").exit_code, 0);
  write_own("work/other/deep/grains_0.txt");  // no folder that a run fills
  folder.done(kShort + " --out work");
  EXPECT_EQ(folder.read("work/other/deep/grains_0.txt"), "mine\n");
  write_own("named/history.csv");
  folder.refused(kShort + " --out named", "E0505");
  folder.refused(kShort + " --out named --force", "E0505");
  EXPECT_EQ(folder.read("named/history.csv"), "mine\n");
}

TEST_F(Folders, BelongToTheRunThatLives) {
  app::Background run(folder, footfall + "run " + app::kSliderCrank + " --quiet --out busy --set end_time=1e5",
                      "busy/history.csv");
  const std::string solver = test::RunFolder::program("mbd_solver") + " " + app::kSliderCrank + " --out busy";
  for (const std::string more : {"", " --force"})
    EXPECT_EQ(folder.footfall(kShort + " --out busy" + more).exit_code, 2);
  EXPECT_EQ(folder.command(solver, 60).exit_code, 2);
  run.end(SIGINT, false);
  folder.refused(kShort + " --out busy", "E0504");
  EXPECT_EQ(folder.summary("busy")["status"], "interrupted");
}

TEST_F(Folders, OfKilledRunsAreReplacedByForce) {
  write_own("dead/before.txt");
  {
    app::Background run(folder,
                        footfall + "run " + app::kInputs + "/rigid_plane --quiet --out dead --set flexible=false" +
                            " --set end_time=1e3 --set output.vtk_interval=0.01",
                        "dead/bodies_0003.vtu");
    run.end(SIGKILL, true);
  }
  write_own("dead/since.txt");
  folder.done(kShort + " --out dead --force");
  EXPECT_EQ(folder.read("dead/before.txt") + folder.read("dead/since.txt"), "mine\nmine\n");
  EXPECT_FALSE(folder.has("dead/bodies_0003.vtu"));
}

TEST_F(Folders, OfPlainLinesAndOfTwoRunsAtOnce) {
  const std::string solver = test::RunFolder::program("mbd_solver");
  EXPECT_EQ(folder.command(solver + " " + app::kSliderCrank + " --quiet --until 0.02 --out plain", 60).exit_code, 0);
  folder.refused(kShort + " --out plain", "E0504");
  folder.done(kShort + " --out plain --force");
  folder.shell(footfall + kShort + " & " + footfall + kShort + "; wait");
  for (const char* run : {"runs/slider_crank", "runs/slider_crank-2"}) EXPECT_EQ(folder.summary(run)["status"], "done");
}

TEST_F(Folders, WithBlanksAreRefusedForGrains) {
  folder.refused("run " + app::kPlate + " --quiet --out 'a b'", "E0507");
  EXPECT_FALSE(folder.has("a b"));
}

TEST_F(Folders, OfDamagedRunsAreReported) {
  folder.done(kShort + " --out good");
  const std::string summaries[] = {folder.read("good/summary.json").substr(0, 200),
                                   "[1, 2]",
                                   "{}",
                                   R"({"status": 3, "scene": 4, "versions": [], "warnings": 7, "active": "x"})",
                                   R"({"status": "done", "scene": {}, "dt_dem_s": "x", "max_omega_h": {"a": "b"}})",
                                   R"({"status": "done", "scene": {"particles": {}}, "dt_dem_s": 1e-5})"};
  for (const std::string& summary : summaries) {
    fs::remove_all(folder.file("bad"));
    fs::copy(folder.file("good"), folder.file("bad"), fs::copy_options::recursive);
    folder.write("bad/summary.json", summary);
    EXPECT_EQ(folder.footfall("compare bad").exit_code, 2) << summary;
    EXPECT_EQ(folder.footfall("view bad --pictures").exit_code, 2) << summary;
    const int code = folder.footfall("report bad").exit_code;  // needs little of a summary
    EXPECT_TRUE(code == 0 || code == 2) << summary;
  }
}

// Damages a file: missing, empty, half, longer, flipped.
void damage(const std::string& file, const std::string& how) {
  const auto size = fs::exists(file) ? fs::file_size(file) : 0;
  if (how == "missing") fs::remove(file);
  if (how == "empty") fs::resize_file(file, 0);
  if (how == "half") fs::resize_file(file, size / 2);
  if (how == "longer") std::ofstream(file, std::ios::app) << 'x';
  if (how == "flipped") {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<long>(size / 3));
    stream << '\xff';
  }
}

TEST_F(Folders, WithADamagedCheckpointResumeFromTheOneBefore) {
  folder.done("run " + app::kSliderCrank + " --quiet --until 0.05 --set output.checkpoint_interval=0.015 --out good");
  std::vector<std::string> sets;
  for (const auto& entry : fs::directory_iterator(folder.file("good/checkpoint")))
    sets.push_back(entry.path().filename());
  std::sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return std::stol(a) < std::stol(b); });
  ASSERT_EQ(sets.size(), 2u);
  const auto resume = [&](std::vector<std::string> files, const std::string& how) {
    fs::remove_all(folder.file("bad"));
    fs::copy(folder.file("good"), folder.file("bad"), fs::copy_options::recursive);
    for (const std::string& file : files) damage(folder.file("bad/" + file), how);
    return folder.footfall("run --resume bad --quiet");
  };
  const std::string older = "checkpoint/" + sets[0] + "/", newer = "checkpoint/" + sets[1] + "/";
  for (const std::string how : {"missing", "empty", "half", "longer", "flipped"}) {
    for (const std::string file : {"run.txt", "start.json", "checksums.txt"}) {
      EXPECT_EQ(resume({newer + file}, how).exit_code, 0) << file << " " << how;
      EXPECT_EQ(folder.read("bad/history.csv"), folder.read("good/history.csv")) << file << " " << how;
    }
    const test::Outcome none = resume({newer + "run.txt", older + "start.json"}, how);
    EXPECT_EQ(none.exit_code, 2) << how;
    EXPECT_TRUE(holds(none.text, sets[1]) && holds(none.text, sets[0])) << none.text;
    if (how == "longer" || how == "flipped") continue;
    const test::Outcome history = resume({"history.csv"}, how);
    EXPECT_EQ(history.exit_code, 2) << how;
    EXPECT_TRUE(holds(history.text, "history.csv")) << history.text;
  }
  fs::remove_all(folder.file("good/checkpoint"));
  folder.refused("run --resume good --quiet", "E0669");
}

TEST_F(Folders, OfBedsThatAreDamagedAreMadeAgain) {
  setenv("FOOTFALL_CACHE", folder.file("cache").c_str(), 1);
  const std::string run = "run " + app::kInputs +
                          "/dropped_sphere --quiet --force --out run --until 0.002 --set output.plots=false"
                          " --set particles.ranks=1 --set bodies.ball.shape.radius=0.07"
                          " --set particles.variables.width=0.42 --set particles.bed.variables.width=0.42"
                          " --set particles.bed.variables.depth=0.1 --set particles.bed.variables.settle=0.02"
                          " --set particles.bed.variables.rest=0.01";
  folder.done(run);
  const std::string bed = fs::path(folder.shell("ls $PWD/cache/beds/*/bed.restart").text).parent_path();
  const std::string restart = bed + "/bed.restart";
  fs::copy(restart, folder.file("whole"));
  EXPECT_FALSE(holds(folder.done(run).text, bed)) << "a bed that is there is used without a word";
  const auto made_again = [&](const std::string& how) {
    EXPECT_TRUE(holds(folder.done(run).text, fs::path(bed).filename().string())) << how;
    EXPECT_EQ(folder.command("cmp whole " + app::quoted(restart), 10).exit_code, 0) << how;
  };
  for (const std::string how : {"empty", "half", "missing"}) {
    damage(restart, how);
    made_again(how);
  }
  std::fstream(restart, std::ios::in | std::ios::out | std::ios::binary).seekp(6000).write("\xff\xff\xff\xff", 4);
  made_again("flipped");
  EXPECT_EQ(folder.shell("ls cache/beds/*/bed.restart | wc -l").text, "1\n");
  unsetenv("FOOTFALL_CACHE");
}

// One run makes a bed; another that needs it at the same time waits.
TEST_F(Folders, OfBedsAreMadeOnceForTwoRuns) {
  setenv("FOOTFALL_CACHE", folder.file("cache").c_str(), 1);
  const std::string run = footfall + "run " + app::kSmallSphere + " --ranks 1 --until 0.001 --out ";
  folder.shell(run + "a > a.txt 2>&1 & " + run + "b > b.txt 2>&1; wait", 120);
  for (const std::string name : {"a", "b"}) EXPECT_EQ(folder.summary(name)["status"], "done");
  EXPECT_EQ(folder.shell("ls cache/beds/*/bed.restart | wc -l").text, "1\n");
  const bool a = holds(folder.read("a.txt"), "Making the bed"), b = holds(folder.read("b.txt"), "Making the bed");
  EXPECT_NE(a, b) << "the bed was made twice, or by nobody";
  unsetenv("FOOTFALL_CACHE");
}

// A file that may not grow, and a folder that is gone, end a run with exit code 1 and the file's name; what is there is complete.
class Disks : public Folders {
 protected:
  const std::string solver = test::RunFolder::program("mbd_solver") + " ";
  // mbd_solver where no file may have more than so many kB.
  test::Outcome limited(int size, const std::string& line) const {
    const test::Outcome outcome = folder.shell("ulimit -f " + std::to_string(size) + "; exec " + solver + line);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.text;
    EXPECT_EQ(app::lines_of(outcome.text), 1) << outcome.text;
    return outcome;
  }
};

TEST_F(Disks, ThatAreFullEndARunWithAWholeHistory) {
  const std::string many = app::kSliderCrank + " --quiet --set end_time=1e3 --set output.interval=1e-3 --out full";
  EXPECT_TRUE(holds(limited(48, many).text, "full/history.csv"));
  const std::string history = folder.read("full/history.csv");
  EXPECT_EQ(history.back(), '\n');
  const std::size_t names = history.find('\n') + 1, last = history.rfind('\n', history.size() - 2) + 1;
  EXPECT_EQ(app::count(history.substr(last), ","),
            app::count(history.substr(names, history.find('\n', names) - names), ","));
  EXPECT_GT(app::lines_of(history), 10);
  EXPECT_EQ(folder.summary("full")["status"], "failed");
}

TEST_F(Disks, ThatAreFullLeaveNoHalfFile) {
  const std::string line = app::kSliderCrank + " --quiet --set output.interval=0.05 ";
  EXPECT_TRUE(holds(limited(7, line + "--until 0.01 --out small").text, "small/summary.json"));
  EXPECT_FALSE(folder.has("small/summary.json") || folder.has("small/summary.json.part"));
  const std::string set = limited(7, line + "--until 0.1 --set output.checkpoint_interval=0.04 --out saved").text;
  EXPECT_TRUE(holds(set, "saved/checkpoint/")) << set;
  EXPECT_NE(folder.shell("ls -d saved/checkpoint/*[0-9]").exit_code, 0) << "half a set passes for a checkpoint";
  const std::string drawn =
      "/rigid_plane --quiet --until 0.002 --set flexible=false --set output.vtk=true --set "
      "'boundaries.footpad_{leg}.surface.element_size=0.02' --out drawn";
  EXPECT_TRUE(holds(limited(200, app::kInputs + drawn).text, "drawn/bodies"));
}

TEST_F(Disks, ThatLoseTheFolderOfARunEndIt) {
  const std::string line = app::kSliderCrank + " --quiet --out gone --set end_time=1e5";  // gone after its first row
  folder.shell(
      "(exec " + solver + line +
      "; ) > gone.txt 2>&1 & run=$!; until (($(cat gone/history.csv 2>/dev/null | wc -l) > 2)); do sleep 0.05;" +
      " done; rm -rf gone; wait $run; echo code $? >> gone.txt");
  EXPECT_TRUE(holds(folder.read("gone.txt"), "gone/history.csv")) << folder.read("gone.txt");
  EXPECT_TRUE(holds(folder.read("gone.txt"), "code 1\n")) << folder.read("gone.txt");
}

// Paths of scripts are those from the current folder, as LIGGGHTS gets them: what is above it may have a blank.
TEST_F(Folders, HaveABlankAboveTheSceneOfARun) {
  folder.shell("mkdir 'two words' && cp " + app::kPlate + "/* 'two words'");
  const std::string inside = "cd 'two words' && " + app::quoted(test::RunFolder::program("footfall")) + " ";
  const std::string script = " --set 'particles.script=\"dumped.in\"'";
  const std::vector<std::string> lines = {"check scene.toml", "run scene.toml --quiet --out run" + script,
                                          "compare run --quiet"};
  for (const std::string& line : lines) {
    const test::Outcome outcome = folder.shell(inside + line);
    EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.text;
    EXPECT_FALSE(holds(outcome.text, "W1135")) << line << "\n" << outcome.text;
  }
  EXPECT_TRUE(folder.has("two words/run/compare/comparison.txt"));
  EXPECT_FALSE(holds(folder.done("check 'two words/scene.toml'").text, "W1135"));
  folder.refused("run 'two words/scene.toml' --out run", "E0507");
  folder.refused("compare 'two words/run'", "E0507");
}

// Nothing of the texts of a scene or an experiment is run by a shell or gnuplot, and nothing is written outside.
class Quoting : public Folders {
 protected:
  void TearDown() override {
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
      EXPECT_NE(entry.path().filename().string().rfind("ran_", 0), 0u) << entry.path() << ": a text was run";
  }
  static std::string experiment(const std::string& plot) {
    return R"(title = "t`touch ran_5`'\""
x_name = "x`touch ran_6`'\""
scene = ")" +
           app::kSliderCrank + R"("
settings = ["output.plots=false"]
until = 0.02
[[parameters]]
name = "p`touch ran_7`'"
settings = ["solver.rtol={value}"]
values = [1e-4, 1e-5]
[[figures]]
name = "f`touch ran_8`'"
key = "drift_position"
[[plots]]
name = ")" +
           plot + R"("
title = "`touch ran_9`'\""
label = "`touch ran_10`'\""
column = "time"
)";
  }
};

TEST_F(Quoting, OfAScene) {
  folder.write("scene.toml", "base = \"" + app::kSliderCrank + R"("
title = "`touch ran_1` \" . system('touch ran_2') . \" ' . system('touch ran_3') . ' $(touch ran_4) <script>x</script>"
end_time = 0.02
[output]
plots = true
)");
  folder.done("run scene.toml --out run --quiet");
  EXPECT_TRUE(folder.has("run/plots/overview.png"));
  folder.done("plot run crank.wz --title 'a \"b\" `touch ran_14` $(touch ran_15)' --out run/plots/both.png");
  folder.done("report run");
  const std::string page = folder.read("run/report.html");
  EXPECT_TRUE(holds(page, "&lt;script&gt;x") && !holds(page, "<script>x"));
}

TEST_F(Quoting, OfAnExperiment) {
  folder.write("good.toml", experiment("good"));
  folder.done("sweep good.toml --out sweep");
  EXPECT_TRUE(folder.has("sweep/good.png"));
  for (const std::string& name : {std::string("../../ran_"), std::string("/tmp/ran_"), std::string(".ran_"),
                                  std::string("a b"), std::string(120, 'a')}) {
    folder.write("bad.toml", experiment(name));
    EXPECT_TRUE(holds(folder.refused("sweep bad.toml --out bad", "E0116").text, "bad.toml:")) << name;
  }
  EXPECT_FALSE(folder.has("bad"));
}

TEST_F(Quoting, OfAJobArray) {
  const std::string name = "a b'c;touch ran_11;`touch ran_12`%a";
  folder.write(name + ".toml", experiment("good"));
  folder.done("sweep " + app::quoted(name + ".toml") + " --out " + app::quoted(name) + " --slurm");
  folder.write("said.sh", "#!/bin/sh\nprintf '<%s>\\n' \"$@\" > words.txt\n");
  folder.shell("chmod +x said.sh && sed \"s#^[^#]*/footfall'\\{0,1\\} #./said.sh #\" " +
               app::quoted(name + "/sweep.sbatch") + " > job.sh && SLURM_ARRAY_TASK_ID=1 bash job.sh");
  const std::string words = folder.read("words.txt");
  EXPECT_TRUE(holds(words, "/" + name + ".toml>") && holds(words, "/" + name + ">")) << words;
  folder.write("a\ntouch ran_13\n.toml", experiment("good"));
  EXPECT_EQ(folder.footfall("sweep 'a\ntouch ran_13\n.toml' --out line --slurm").exit_code, 2);
  fs::remove(folder.file("a\ntouch ran_13\n.toml"));
  fs::rename(folder.file(name), folder.file("renamed"));
  fs::remove(folder.file(name + ".toml"));
}

}  // namespace
}  // namespace footfall
