#pragma once
// footfall check --time: the first seconds of a run, and how long the whole of it takes.

#include "mbd_solver/cli/run_command.h"

namespace footfall {

// Runs the scene of `arguments` for so many seconds into a folder that is removed again, and prints the expected run time,
// the memory, and what the coupling has met so far. A bed that is not made yet is not made for this: then it says so.
// Returns the exit code. Throws InputError, PartnerError.
int trial_command(const RunArguments& arguments, double seconds);

}  // namespace footfall
