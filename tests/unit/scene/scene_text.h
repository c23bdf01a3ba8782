#pragma once
// Scenes written by a test: in a folder of their own, which goes away with the test.

#include <string>
#include <vector>

#include "mbd_solver/scene/scene_reader.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {

class SceneText : TemporaryFolder {
 public:
  using TemporaryFolder::write;
  Scene read(const std::string& toml, const std::vector<std::string>& settings = {}) const {
    return read_scene(write("scene.toml", toml), settings);
  }
  // The findings; "" where there are none.
  std::string findings(const std::string& toml, const std::vector<std::string>& settings = {}) const {
    return test::refusal([&] { read(toml, settings); });
  }
};

// A scene that is good as it is.
const std::string kPendulum = R"(end_time = 1.0
[[bodies]]
name = "bob"
mass = 2.0
inertia = [0.1, 0.1, 0.2]
position = [1.0, 0.0, 0.0]
[[joints]]
name = "hinge"
kind = "revolute"
bodies = ["ground", "bob"]
point = [0, 0, 0]
axis = "y"
)";

}  // namespace footfall
