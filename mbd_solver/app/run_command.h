#pragma once
// footfall run: check the scene, make the bed, start both programs, report the results; or resume from a checkpoint.

#include <string>
#include <vector>

#include "mbd_solver/app/run_folder.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/session/output/checkpoint_folder.h"

namespace footfall {

struct RunArguments {
  std::string scene;
  std::string out;                    // folder of results; empty: runs/NAME, the first that is free
  double until = 0.0;                 // [s]; 0: the scene's end time
  int ranks = 0;                      // LIGGGHTS processes; 0: the scene's
  std::vector<std::string> settings;  // --set key=value
  std::string scheme, integrator;     // empty: the scene's
  bool force = false;                 // replace the run in the folder
  bool trust_script = false;          // the script may run programs and write anywhere
  bool quiet = false;
  bool view = false;                     // its page is served while it runs
  bool audit = false;                    // both programs record what they exchange, in DIR/audit
  double keep_every = kCheckpointEvery;  // wall-clock checkpoint interval where the scene sets none [s]; 0: none
  bool resume = false;                   // resume the run in `out`; empty: the run in runs with the newest checkpoint
};

// A resumed run takes only `until`, `keep_every` and `quiet` anew. Returns the exit code. Throws InputError,
// PartnerError, Interrupted.
int run_command(const RunArguments& arguments);

// What a run starts, and where it leaves its results.
struct RunPlan {
  Scene scene;
  std::string out, log;  // folder of results; the log of LIGGGHTS
  RunFolder folder;      // locked until the run has ended
  Command command;
  std::string bed_log;  // LIGGGHTS' log from making the bed; empty: no bed
};

// Makes the bed if it is not in the cache. Both throw InputError, Interrupted, PartnerError.
RunPlan new_run(const RunArguments& arguments);
// From the newest checkpoint of the run in arguments.out, or of the run in runs with the newest one. The script must
// begin by reading the restart file ${bed}.
RunPlan resumed_run(const RunArguments& arguments);

// Throws InputError for a path, named `what`, that LIGGGHTS would split: it looks for the words of a line after it has replaced
// ${out}, ${bed} and ${here}.
void require_one_word(const std::string& what, const std::string& path);

}  // namespace footfall
