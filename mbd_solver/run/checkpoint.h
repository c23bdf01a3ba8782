#pragma once
// A run kept so that it can be gone on with: RUN/checkpoint/N/ (checkpoint_folder.h), where
//   start.json   how the run was started, and its scene with all defaults (run_start.h)
//   run.txt      the memory of the mechanism's side (archive.h)
// and the grains' side adds its own: grains.restart of LIGGGHTS, and grains.txt.

#include <functional>
#include <string>

#include "coupler/archive.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// until [s], ranks: as in RunStart. visit: describes the memory.
void write_checkpoint(const std::string& folder, const Scene& scene, double until, int ranks,
                      const std::function<void(Archive&)>& visit);
// Throws InputError when `scene` is not the one of the checkpoint, naming the first value that differs, and when the
// memory does not fit.
void restore_checkpoint(const std::string& folder, const Scene& scene, const std::function<void(Archive&)>& visit);

}  // namespace footfall
