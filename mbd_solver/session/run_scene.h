#pragma once
// One scene from start to files: the work of the program mbd_solver, alone or with its partner.

#include <csignal>
#include <string>

#include "coupler/transport.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/session/output/checkpoint_folder.h"

namespace footfall {

struct RunOptions {
  std::string out = "out";  // folder for history.csv, summary.json, VTU
  double until = 0.0;       // end earlier than the scene [s]; 0: the scene's end
  bool quiet = false;       // no progress line
  int ranks = 0;            // of LIGGGHTS; 0 without grains
  std::string checkpoint;   // folder of the checkpoint to resume from; empty: a new run
  // Wall-clock checkpoint interval where the scene has no checkpoint_interval [s]; 0: no checkpoints.
  double keep_every = kCheckpointEvery;
  bool trusted = false;  // programs of the user that the scene names may run
  double try_for = 0.0;  // a trial (progress.h): ends after so many wall-clock seconds; 0: not a trial
  bool fleeting =
      false;  // a row of a campaign, whose files are read at once and removed: no note of the run, no end state
  std::string mpi_version;  // of the library, for the summary; empty: not used
};

// Runs the scene and writes its files. Returns the exit code: done or interrupted. `transport`: null without grains.
// Throws what Simulation throws, after writing a summary with status "failed" and informing the partner.
int run_scene(const Scene& scene, const RunOptions& options, Transport* transport,
              const volatile std::sig_atomic_t& interrupted);

}  // namespace footfall
