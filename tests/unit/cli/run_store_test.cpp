// What a finished run is known by: its scene, and the contents of every file that the scene names.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/fingerprint.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/experiments/run_store.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

class RunStoreTest : public ::testing::Test {
 protected:
  RunStoreTest() {
    std::string pattern = (fs::temp_directory_path() / "footfall_store_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~RunStoreTest() override { fs::remove_all(folder_); }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(file(name)) << text; }

  fs::path folder_;
};

TEST_F(RunStoreTest, KnowsARunByEveryFileThatItsSceneNames) {
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
  write("in.grains",
        "include more.grains\nfix pad all mesh/surface file pad.stl type 1\nfix mbd all couple/mbd every 1 mesh pad "
        "pad\nrun 1\n");
  write("more.grains", "# grains\n");
  write("in.bed", "write_restart ${bed}\n");
  write("pad.stl",
        "solid pad\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid pad\n");
  const auto recipe = [&] { return recipe_of(read_scene(file("scene.toml"), {}), 0.1); };
  const std::string before = recipe();
  ASSERT_FALSE(before.empty());
  EXPECT_EQ(recipe(), before);
  for (const char* name : {"in.grains", "more.grains", "in.bed", "pad.stl"}) {
    const std::string kept = recipe();
    std::ofstream(file(name), std::ios::app) << "# changed\n";
    EXPECT_NE(recipe(), kept) << name;
  }
}

// A scene without grains.
RunRequest request(const std::string& name, const std::vector<std::string>& settings) {
  RunRequest request;
  request.name = name;
  request.scene = std::string(FOOTFALL_SOURCE_DIR) + "/inputs/accuracy/scenes/slider_crank.toml";
  request.settings = settings;
  return request;
}

TEST_F(RunStoreTest, RunsOfOneRecipeAreOne) {
  RunStore store(folder_.string(), true);
  const std::size_t first = store.add(request("first", {"solver.rtol=1e-6"}));
  const std::size_t same = store.add(request("same", {"solver.rtol=1e-3", "solver.rtol=1e-6"}));
  const std::size_t other = store.add(request("other", {"solver.rtol=1e-3"}));
  EXPECT_EQ(store.folder(same), file("first"));
  EXPECT_EQ(store.folder(other), file("other"));
  EXPECT_EQ(store.left({same, first, other}), (std::vector<std::size_t>{first, other}));
}

TEST_F(RunStoreTest, AFinishedRunIsKeptUntilItsRecipeChanges) {
  const RunRequest run = request("run", {});
  fs::create_directory(file("run"));
  write("run/summary.json", "{\"status\": \"done\"}");
  const std::string recipe = fingerprint(recipe_of(read_scene(run.scene, {}), run.until));
  write("run.done.json", "{\"recipe\": \"" + recipe + "\", \"cost\": {\"cpu_s\": 2.5}}");
  const auto done = [&](bool keep, const RunRequest& asked) {
    RunStore store(folder_.string(), keep);
    return store.is_done(store.add(asked));
  };
  EXPECT_TRUE(done(true, run));
  EXPECT_FALSE(done(false, run));
  EXPECT_FALSE(done(true, request("run", {"solver.rtol=1e-3"})));
  RunStore store(folder_.string(), true);
  EXPECT_EQ(store.end_of(store.add(run)).cost.cpu, 2.5);
  fs::remove(file("run/summary.json"));
  EXPECT_FALSE(done(true, run));
}

TEST_F(RunStoreTest, AWrongSceneIsToldUnlessTheRunMayBeRefused) {
  RunStore store(folder_.string(), true);
  RunRequest wrong = request("wrong", {"solver.rtol=-1"});
  EXPECT_THROW(store.add(wrong), InputError);
  wrong.may_be_refused = true;
  EXPECT_FALSE(store.is_done(store.add(wrong)));
}

TEST_F(RunStoreTest, WhatStoodThereIsKeptWhenTheNewFileCannotBeWritten) {
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
