#pragma once
// The folder that one run writes into: held while the run lives, and what it makes there is noted, so that a later run
// with --force removes that and nothing of the user's.

#include <memory>
#include <string>
#include <vector>

#include "mbd_solver/base/lock.h"
#include "mbd_solver/base/made_files.h"
#include "mbd_solver/bed/process.h"
#include "mbd_solver/run/output/checkpoint_folder.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

class OwnFolder {
 public:
  // Refuses a folder that another run holds; one that holds an earlier run, unless `force`, which removes the files of
  // that run (those of a start that never came to a first row go without a word); one where files of the user have names
  // that the run would write. Throws InputError.
  OwnFolder(const std::string& folder, bool force);
  // The folder of a run that goes on: nothing is removed. Refuses a folder that another run holds. Throws InputError.
  explicit OwnFolder(const std::string& folder);

 private:
  void begin();  // a kill from here on leaves a list, too

  FileLock lock_;
  std::unique_ptr<MadeFiles> files_;
};

// runs/NAME, runs/NAME-2, ...: the first that is free; it is there then.
std::string new_run_folder(const std::string& name);

// footfall run: check, bed, start the two programs, show what came out; or go on from a checkpoint.

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

// What `footfall run` starts, and where it leaves its results: a run from the start, or one that goes on from a
// checkpoint.

struct RunPlan {
  Scene scene;
  std::string out, log;  // folder of results; the log of LIGGGHTS
  OwnFolder folder;      // held until the run has ended
  Command command;
  std::string bed_log;  // of LIGGGHTS, when it poured the bed; empty: there is none
};

// Makes the bed where there is none. Both throw InputError, Interrupted, PartnerError.
RunPlan new_run(const RunArguments& arguments);
// The newest checkpoint of the run in arguments.out, or of the one last kept in runs. The script must begin with the
// restart file that -var bed names.
RunPlan resumed_run(const RunArguments& arguments);

}  // namespace footfall
