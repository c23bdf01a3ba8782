#pragma once
// Somebody asks a program to end: the user, the batch system, mpirun. The program looks at a flag where its work may
// stop, and a time limit ends it where it does not get there.

#include <csignal>

#include "coupler/base/errors.h"

namespace footfall {

// From here on SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGUSR1 end this program with kExitInterrupted: at once while there is
// nothing to keep, and after work_is_under_way() in order, by a flag. Then the first signal starts a time limit: a
// program that is still there kEnding later ends without a word to anybody but standard error. `program`: its name, for
// that word; it must outlive the program. A SIGHUP that is ignored (nohup) stays so. Under mpirun SIGPIPE is ignored. With kLauncherWarns in the
// environment a SIGCONT of the parent process is such a signal, too, unless it wakes us from a stop: see alive_for().
void end_on_signals(const char* program);
void work_is_under_way();
inline constexpr unsigned kEnding = 8;  // [s]
// In the environment of programs under an mpirun that is in no hurry to kill: it sends SIGCONT first when it ends a job.
inline constexpr const char* kLauncherWarns = "FOOTFALL_LAUNCHER_WARNS";

// The work goes on, and will say so again within this time [s]. mpirun hands on the SIGCONT that a suspended job gets when
// it may go on: one that finds us overdue asks for nothing. An mpirun that ends the job then sends SIGTERM soon.
void alive_for(double seconds);

bool is_ignored(int signal);

// Not 0 once such a signal has come.
const volatile std::sig_atomic_t& interrupted();
// Whether a wait for the partner that has lasted so long [s] has to end, as this program has to. A partner that goes on
// gets the time for a window and a checkpoint, also on a machine with much else to do; one that says nothing gets less.
// Both get little when the parent process has asked, unless it warns early: mpirun kills soon after it has asked.
bool waited_enough(double waited);

// The same time limit for an orderly end that may wait for others: ends the program `seconds` from now with this exit
// code unless it has ended before. A limit that runs already stays.
void end_within(unsigned seconds, int exit_code);

}  // namespace footfall
