// Every scene of inputs/ passes `check`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "mbd_solver/app/command_line.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scenes_of_inputs() {
  std::vector<std::string> scenes;
  for (const auto& folder : fs::directory_iterator(FOOTFALL_SOURCE_DIR "/inputs"))
    if (fs::exists(folder.path() / "scene.toml")) scenes.push_back(folder.path() / "scene.toml");
  for (const auto& folder : fs::directory_iterator(FOOTFALL_SOURCE_DIR "/inputs/starters"))
    scenes.push_back(folder.path() / "scene.toml");
  for (const auto& file : fs::directory_iterator(FOOTFALL_SOURCE_DIR "/inputs/paper_identified"))
    if (file.path().extension() == ".toml" && file.path().filename() != "scene.toml") scenes.push_back(file.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

class Scene : public ::testing::TestWithParam<std::string> {};

TEST_P(Scene, IsGood) {
  std::string words[] = {"footfall", "check", GetParam()};
  char* argv[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(run_command_line(3, argv, subcommands()), 0);
  std::fflush(stdout);
  ::testing::internal::GetCapturedStdout();
}

INSTANTIATE_TEST_SUITE_P(OfInputs, Scene, ::testing::ValuesIn(scenes_of_inputs()), [](const auto& tested) {
  std::string name = fs::relative(tested.param, FOOTFALL_SOURCE_DIR "/inputs").replace_extension().string();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

}  // namespace
}  // namespace footfall
