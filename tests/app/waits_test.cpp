// Programs that never get on: the run ends after coupling.timeout (at least ten seconds) with exit code 1 and says what was
// waited for, and nothing of it is left.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/app/programs.h"

namespace footfall::app {
namespace {

namespace fs = std::filesystem;

class Waits : public ::testing::Test {
 protected:
  const Folder folder{"waits"};
  const std::string run = "run scene.toml --quiet --out run --set coupling.timeout=1";

  Waits() {
    for (const std::string name :
         {"scene.toml", "box.lammps", "couple.lammps", "good.in", "bed.in", "on_bed.in", "from_bed.lammps"})
      fs::copy_file(kPlate + "/" + name, folder.path() / name);
  }
  // An mpirun that starts nothing, or whose programs end.
  void replace_mpirun(const std::string& lines) const {
    fs::create_directories(folder.path() / "bin");
    folder.write("bin/mpirun", "#!/bin/bash\n" + lines);
    fs::permissions(folder.path() / "bin/mpirun", fs::perms::owner_all);
  }
  void expect_end(const test::Outcome& outcome, const std::string& code) const {
    EXPECT_EQ(outcome.exit_code, 1) << outcome.text;
    EXPECT_TRUE(holds(outcome.text, "[" + code + " ")) << outcome.text;
    EXPECT_EQ(processes_in(folder.path()), "");
  }
};

TEST_F(Waits, MpirunWithoutPrograms) {
  for (const std::string lines : {"exec sleep 600\n", "sleep 1 &\nwait\nexec sleep 600\n"}) {
    replace_mpirun(lines);
    const std::string path = "PATH=" + folder.file("bin") + ":$PATH ", footfall = Folder::program("footfall") + " ";
    expect_end(folder.shell(path + footfall + run + " --force"), "E0568");
    const std::string bed = " --set particles.script=on_bed.in --set particles.bed.script=bed.in";
    expect_end(folder.shell(path + "FOOTFALL_CACHE=cache " + footfall + run + bed + " --force"), "E0568");
  }
}

TEST_F(Waits, AScriptThatMakesNoStep) {
  folder.write("good.in",
               "include ${here}/box.lammps\necho none\nlabel again\njump SELF again\ninclude ${here}/couple.lammps\n");
  expect_end(folder.footfall(run), "E0569");
  EXPECT_EQ(folder.summary("run")["status"], "failed");
}

// A script may take its time, as long as it makes steps.
TEST_F(Waits, AScriptThatSettlesInSilence) {
  folder.write(
      "good.in",
      "include ${here}/box.lammps\nthermo 100000000\nrun 1000000\ninclude ${here}/couple.lammps\nrun 1000000\n");
  const test::Outcome outcome = folder.footfall(run + " --until 0.001", 300);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
}

}  // namespace
}  // namespace footfall::app
