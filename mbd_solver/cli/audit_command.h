#pragma once
// footfall audit: a short coupled run in which both programs count what they exchange, and a table of what agrees.

#include "mbd_solver/cli/run_command.h"

namespace footfall {

struct AuditArguments {
  RunArguments run;   // `until` 0: `windows` of them
  int windows = 200;  // of the coupling, from the start
};

// Exit code 0 when every quantity holds, 1 when one does not; otherwise that of the run. Throws InputError.
int audit_command(const AuditArguments& arguments);

}  // namespace footfall
