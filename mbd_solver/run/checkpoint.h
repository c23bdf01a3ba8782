#pragma once
// A run kept so that it can be gone on with: RUN/checkpoint/N/ (checkpoint_folder.h), where
//   start.json   how the run was started, and its scene with all defaults: the scene of a resumed run must be the same
//   run.txt      the memory of the mechanism's side (archive.h)
// and the grains' side adds its own files.

#include <functional>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// What a run was started with: enough to start it again.
struct RunStart {
  std::string scene;                  // file, as an absolute path
  std::vector<std::string> settings;  // --set key=value
  double until = 0.0;                 // [s]; 0: the scene's end
};

void write_checkpoint(const std::string& folder, const Scene& scene, double until,
                      const std::function<void(Archive&)>& visit);

// Of the set in `folder`. Throws InputError for a file that cannot be read.
RunStart read_run_start(const std::string& folder);
// Throws InputError when `scene` is not the one of the set, naming the first value that differs.
void restore_checkpoint(const std::string& folder, const Scene& scene, const std::function<void(Archive&)>& visit);

}  // namespace footfall
