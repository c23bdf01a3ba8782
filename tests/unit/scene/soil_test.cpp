// mbd_solver/scene/soil.h: published soils as beds by numbers.
#include "mbd_solver/scene/soil.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/scene/shipped_files.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

const std::string kScene = R"(end_time = 1.0
[[bodies]]
name = "plate"
mass = 1.0
shape = { kind = "disc", centre = [0, 0, 0.05], radius = 0.05, thickness = 0.01 }
[[boundaries]]
body = "plate"
surface = {}
[ground]
kind = "particles"
[particles]
soil = "SOIL"
[particles.box]
size = [0.3, 0.2]
depth = 0.08
radius = 0.008
)";

std::string with_soil(const std::string& name, const std::string& more = "") {
  std::string text = kScene;
  return text.replace(text.find("SOIL"), 4, name) + more;
}

TEST(Soil, EveryOneIsReadAndSaysWhereItsNumbersComeFrom) {
  ASSERT_GE(known_soils().size(), 6u);
  for (const std::string& name : known_soils()) {
    const Scene scene = SceneText().read(with_soil(name));
    const BoxSpec& box = *scene.particles->box;
    EXPECT_EQ(box.packing, name.find("dense") != std::string::npos ? Packing::kDense : Packing::kLoose) << name;
    EXPECT_NE(box.material.density, GrainMaterialSpec{}.density) << name;
    const std::string text = read_whole_file(shipped_file("inputs/soils/" + name + ".toml")).value();
    EXPECT_NE(text.find("Source"), std::string::npos) << name;
    EXPECT_NE(text.find("assumed"), std::string::npos) << name;
  }
}

TEST(Soil, WhatTheSceneSaysItselfStays) {
  const Scene scene =
      SceneText().read(with_soil("grc-1-dense", "packing = \"loose\"\n[particles.box.material]\nfriction = 0.7\n"));
  EXPECT_EQ(scene.particles->box->packing, Packing::kLoose);
  EXPECT_EQ(scene.particles->box->material.friction, 0.7);
  EXPECT_EQ(scene.particles->box->material.density, 3098.0);
}

TEST(Soil, AnUnknownOneIsToldWithItsLine) {
  EXPECT_NE(SceneText().findings(with_soil("mud")).find("there is no soil \"mud\". Known soils: grc-1-dense"),
            std::string::npos);
}

}  // namespace
}  // namespace footfall
