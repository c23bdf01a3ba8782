// What a finished run is known by: its scene, and the contents of every file that the scene names.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/experiments/run_record.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

class RunRecordTest : public ::testing::Test, protected TemporaryFolder {
 protected:
};

TEST_F(RunRecordTest, KnowsARunByEveryFileThatItsSceneNames) {
  write("scene.toml", R"(
end_time = 0.1
[materials.steel]
density = 7800
[[bodies]]
name = "pad"
material = "steel"
shape = { kind = "sphere", radius = 0.1, centre = [0, 0, 1] }
[[boundaries]]
body = "pad"
surface = { file = "pad.stl" }
[ground]
kind = "particles"
[particles]
script = "in.grains"
bed = { script = "in.bed" }
)");
  write("in.grains", "include more.grains\nfix mbd all couple/mbd every 1 mesh pad pad\n");
  write("more.grains", "# grains\n");
  write("in.bed", "write_restart ${bed}\n");
  write("pad.stl",
        "solid pad\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid pad\n");
  const auto recipe = [&] { return run_recipe(file("scene.toml"), {}, 0.1); };
  const std::string before = recipe();
  ASSERT_FALSE(before.empty());
  EXPECT_EQ(recipe(), before);
  for (const char* name : {"in.grains", "more.grains", "in.bed", "pad.stl"}) {
    const std::string kept = recipe();
    std::ofstream(file(name), std::ios::app) << "# changed\n";
    EXPECT_NE(recipe(), kept) << name;
  }
}

TEST_F(RunRecordTest, ARecordIsThereWholeOrNotAtAll) {
  write("summary.json", "{}");
  const std::string run = folder_.string();
  record_run(run, "the recipe", {{"wall_s", 2.0}});
  EXPECT_EQ(recorded_cost(run, "the recipe").at("wall_s"), 2.0);
  EXPECT_TRUE(recorded_cost(run, "another recipe").is_null());
  fs::remove(run + ".done.json");
}

TEST_F(RunRecordTest, WhatStoodThereIsKeptWhenTheNewFileCannotBeWritten) {
  write("result.csv", "old\n");
  fs::create_directory(file("result.csv.part"));  // nothing can be written under this name
  EXPECT_THROW(write_whole_file(file("result.csv"), "new\n"), InputError);
  std::string text;
  std::ifstream(file("result.csv")) >> text;
  EXPECT_EQ(text, "old");
  fs::remove(file("result.csv.part"));
  write_whole_file(file("result.csv"), "new\n");
  std::ifstream(file("result.csv")) >> text;
  EXPECT_EQ(text, "new");
  EXPECT_FALSE(fs::exists(file("result.csv.part")));
}

}  // namespace
}  // namespace footfall
