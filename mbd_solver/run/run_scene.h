#pragma once
// One scene from start to files: what the program mbd_solver does once it knows its partner.

#include <csignal>
#include <string>

#include "coupler/transport.h"
#include "mbd_solver/run/output/checkpoint_folder.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

struct RunOptions {
  std::string out = "out";  // folder for history.csv, summary.json, VTU
  double until = 0.0;       // end earlier than the scene [s]; 0: the scene's end
  bool quiet = false;       // no progress line
  int ranks = 0;            // of LIGGGHTS; 0 without
  std::string checkpoint;   // folder of the set that the run goes on from; empty: from the start
  // A scene without checkpoint_interval is kept every so often on the clock on the wall [s]; 0: never.
  double keep_every = kKeepEvery;
  double try_for = 0.0;     // a trial (trial.h): ends after so many seconds on the wall; 0: the run goes to its end
  std::string mpi_version;  // of the library, for the summary; empty: not used
};

// Runs the scene and writes its files. Returns the exit code: done or interrupted. `transport`: null without grains.
// Throws what Simulation throws, after writing a summary that says `failed`; the partner is told.
int run_scene(const Scene& scene, const RunOptions& options, Transport* transport,
              const volatile std::sig_atomic_t& interrupted);

}  // namespace footfall
