#pragma once
// What a run was started with, as it stands in each of its checkpoints (start.json): enough to start it again.

#include <string>
#include <vector>

namespace footfall {

struct RunStart {
  std::string scene_file;             // absolute path
  std::vector<std::string> settings;  // --set key=value
  double until = 0.0;                 // [s]; 0: the scene's end
  int ranks = 0;                      // of LIGGGHTS; 0 without grains
  std::string scene;                  // with all defaults, as JSON: that of a resumed run must be the same
};

// `folder`: of the checkpoint. Both throw InputError for a file that cannot be written or read, or that another version
// wrote.
void write_run_start(const std::string& folder, const RunStart& start);
RunStart read_run_start(const std::string& folder);

}  // namespace footfall
