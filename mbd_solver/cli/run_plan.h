#pragma once
// What `footfall run` starts, and where it leaves its results: a run from the start, or one that goes on from a
// checkpoint.

#include <string>

#include "mbd_solver/cli/launch/child.h"
#include "mbd_solver/cli/launch/own_folder.h"
#include "mbd_solver/cli/run_command.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

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
