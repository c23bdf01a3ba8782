// Runs that end before their first step, or by Ctrl-C: every command says how they ended and why, and how to begin them again.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/app/programs.h"

namespace footfall::app {
namespace {

namespace fs = std::filesystem;

class Starts : public ::testing::Test {
 protected:
  const Folder folder{"starts"};
  const std::string footfall = Folder::program("footfall") + " ";

  Starts() {
    for (const std::string name :
         {"scene.toml", "box.lammps", "couple.lammps", "good.in", "bed.in", "on_bed.in", "from_bed.lammps"})
      fs::copy_file(kPlate + "/" + name, folder.path() / name);
  }
  void expect_end(const std::string& status, const std::string& reason) const {
    const nlohmann::json summary = folder.summary("run");
    EXPECT_EQ(summary["status"], status);
    EXPECT_TRUE(holds(summary["reason"], reason)) << summary["reason"];
  }
};

struct FailedStart {
  const char* name;
  const char* script;  // of the plate
  const char* reason;
};
// An error of LIGGGHTS on all ranks, one of our fix, and one of a single rank.
const FailedStart kFailedStarts[] = {
    {"error of a command",
     "include ${here}/box.lammps\nset group all density 0\ninclude ${here}/couple.lammps\nrun 9\n",
     "Invalid density in set command"},
    {"script without coupling", "include ${here}/box.lammps\ninclude ${here}/couple.lammps\nunfix mbd\nrun 9\n",
     "E0465"},
    {"error of one rank",
     "include ${here}/box.lammps\ncreate_atoms 1 single 0.05 0 0.05\nset group all density 2600 diameter 0.04\n"
     "include ${here}/couple.lammps\nrun 1000\n",
     "tri_mesh"}};

// A run that one of its programs refuses, or that LIGGGHTS ends, has not been interrupted.
TEST_F(Starts, ThatFailAreReportedWithTheirReason) {
  for (const FailedStart& start : kFailedStarts) {
    SCOPED_TRACE(start.name);
    folder.write("good.in", start.script);
    const test::Outcome run = folder.footfall("run scene.toml --quiet --force --out run --ranks 2");
    EXPECT_EQ(run.exit_code, 2) << run.text;
    EXPECT_TRUE(holds(run.text, start.reason)) << run.text;
    for (const char* wrong : {"interrupted", "stopped by a signal"}) EXPECT_FALSE(holds(run.text, wrong)) << run.text;
    expect_end("failed", start.reason);
    EXPECT_EQ(folder.summary("run")["failed_at_start"], true);
    for (const char* command : {"view run", "view run --follow --once", "plot run contact", "report run"}) {
      const std::string said =
          folder.footfall(command).text + (folder.has("run/report.html") ? folder.read("run/report.html") : "");
      EXPECT_FALSE(holds(said, "interrupted")) << command << "\n" << said;
    }
    const std::string followed = folder.footfall("view run --follow --once").text;
    EXPECT_TRUE(holds(followed, "failed at the start: ") && holds(followed, start.reason)) << followed;
    if (!folder.has("run/history.csv")) {
      for (const char* command : {"view run", "plot run contact", "report run"}) {
        const test::Outcome refused = folder.refused(command, "E0506");
        EXPECT_TRUE(holds(refused.text, "failed at the start: ") && holds(refused.text, start.reason)) << refused.text;
      }
    } else {
      folder.done("report run");
      EXPECT_TRUE(holds(folder.read("run/report.html"), "failed at the start: ")) << start.name;
    }
  }
}

// In a sweep each row has the reason.
TEST_F(Starts, ThatFailInASweepAreNamedThere) {
  folder.write("good.in", kFailedStarts[2].script);
  folder.write("sweep.toml",
               "scene = \"scene.toml\"\nsettings = [\"particles.ranks=2\"]\n"
               "[[parameters]]\nname = \"v\"\nsettings = [\"initial.velocity=[0,0,{value}]\"]\nvalues = "
               "[-1]\n[[figures]]\nname = \"a\"\nkey = "
               "\"peak_acceleration_g\"\n");
  const test::Outcome sweep = folder.footfall("sweep sweep.toml");
  EXPECT_NE(sweep.exit_code, 0);
  EXPECT_TRUE(holds(sweep.text, "failed at the start: ") && holds(sweep.text, "tri_mesh")) << sweep.text;
  EXPECT_FALSE(holds(sweep.text, "signal")) << sweep.text;
}

// Ctrl-C while the bed is made, while the script settles it, in the coupled run and in a run without grains: within ten seconds all is
// gone, and the last line is the command that continues.
TEST_F(Starts, AndRunsThatAreInterruptedSayHowToGoOn) {
  setenv("FOOTFALL_CACHE", folder.file("cache").c_str(), 1);
  const auto interrupted = [&](const std::string& line, const std::string& ready, const std::string& command) {
    SCOPED_TRACE(line);
    folder.shell("rm -rf run");
    const std::string pid = "run=$!; for i in $(seq 300); do " + ready + " && break; sleep 0.1; done; sleep 0.5; ";
    const test::Outcome outcome =
        folder.shell("exec 2>&1; " + footfall + line + " & " + pid +
                         "start=$(date +%s); kill -INT $run; wait $run; echo code $?; echo $(($(date +%s) - start)) s",
                     90);
    EXPECT_TRUE(holds(outcome.text, "code 3\n")) << outcome.text;
    EXPECT_TRUE(holds(outcome.text, command)) << outcome.text;
    EXPECT_EQ(processes_in(folder.path()), "");
    const std::size_t seconds = outcome.text.rfind("code 3\n");
    ASSERT_NE(seconds, std::string::npos);
    EXPECT_LE(std::stoi(outcome.text.substr(seconds + 7)), 10) << outcome.text;
    expect_end("interrupted", "");
  };
  const std::string again = "start it again with: footfall ", resume = "resume with: footfall run --resume run";
  const std::string grains = "run scene.toml --quiet --out run --set end_time=1000 --set particles.ranks=2";
  const std::string bed = grains + " --set particles.script=on_bed.in --set particles.bed.script=endless.in";
  folder.write("endless.in", "include ${here}/box.lammps\nrun 1000000000\nwrite_restart ${bed}\n");
  interrupted(bed, "ls cache/beds/*/liggghts.log > /dev/null 2>&1", again + bed);
  folder.write("good.in",
               "include ${here}/box.lammps\nrun 1000000000\ninclude ${here}/couple.lammps\nrun 1000000000\n");
  interrupted(grains, "grep -qs '^run 1' run/liggghts.log", again + grains);
  folder.write("good.in", "include ${here}/box.lammps\ninclude ${here}/couple.lammps\nrun 1000000000\n");
  interrupted(grains, "(($(cat run/history.csv 2> /dev/null | wc -l) > 3))", resume);
  const std::string alone = "run " + kSliderCrank + " --quiet --out run --set end_time=1e5";
  interrupted(alone, "(($(cat run/history.csv 2> /dev/null | wc -l) > 3))", resume);
  unsetenv("FOOTFALL_CACHE");
}

}  // namespace
}  // namespace footfall::app
