#pragma once
// Scenes written by a test: in a folder of their own, which goes away with the test.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {

class SceneText {
 public:
  SceneText() {
    std::string pattern = (std::filesystem::temp_directory_path() / "footfall_scene_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~SceneText() { std::filesystem::remove_all(folder_); }
  SceneText(const SceneText&) = delete;
  SceneText& operator=(const SceneText&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    const std::string file = (std::filesystem::path(folder_) / name).string();
    std::ofstream(file) << text;
    return file;
  }
  Scene read(const std::string& toml, const std::vector<std::string>& settings = {}) const {
    return read_scene(write("scene.toml", toml), settings);
  }
  // The findings, or "no findings".
  std::string findings(const std::string& toml, const std::vector<std::string>& settings = {}) const {
    try {
      read(toml, settings);
    } catch (const InputError& e) {
      return e.what();
    }
    return "no findings";
  }

 private:
  std::string folder_;
};

// A scene that is good as it stands.
inline const std::string kPendulum = R"(end_time = 1.0
[[bodies]]
name = "bob"
mass = 2.0
inertia = [0.1, 0.1, 0.2]
position = [1.0, 0.0, 0.0]
[[joints]]
name = "hinge"
type = "revolute"
bodies = ["ground", "bob"]
point = [0, 0, 0]
axis = "y"
)";

}  // namespace footfall
