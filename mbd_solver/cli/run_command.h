#pragma once
// footfall run: check, bed, start the two programs, show what came out; or go on from a checkpoint.

#include <string>
#include <vector>

#include "mbd_solver/output/checkpoint_folder.h"

namespace footfall {

struct RunArguments {
  std::string scene;
  std::string out;                    // empty: runs/NAME, the first that is free
  double until = 0.0;                 // [s]; 0: the scene's end time
  int ranks = 0;                      // LIGGGHTS processes; 0: the scene's
  std::vector<std::string> settings;  // --set key=value
  std::string scheme, integrator;     // empty: the scene's
  bool force = false;                 // into a folder with an earlier run, whose files are removed first
  bool trust_script = false;          // the script may run programs and write anywhere
  bool quiet = false;
  bool audit = false;              // both programs count what they exchange, into RUN/audit
  double keep_every = kKeepEvery;  // a checkpoint so often on the clock, where the scene asks for none [s]; 0: none
  bool resume = false;             // go on with the run in `out`; empty: the one last kept in runs
};

// Of a resumed run only `until`, `keep_every` and `quiet` may be said anew. Returns the exit code. Throws InputError, PartnerError.
int run_command(const RunArguments& arguments);

}  // namespace footfall
