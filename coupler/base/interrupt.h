#pragma once
// Signals that request the end of a program: from the user, the batch system or mpirun. The program checks a flag
// where its work can stop; a time limit ends it if it does not get there.

#include <csignal>

namespace footfall {

// From here on SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGUSR1 end this program with kExitInterrupted: at once while there
// is no work to save, and after work_is_under_way() in order, through the flag interrupted(). The first signal then
// starts a time limit: kEndingTime later the program ends with a line on standard error only.
// program: its name for messages; must outlive the program. An ignored SIGHUP (nohup) remains ignored. With
// kLauncherWarns in the environment, a SIGCONT of the parent process counts as such a signal too, unless it ends a stop
// (promise_progress).
void end_on_signals(const char* program);
void work_is_under_way();
inline constexpr unsigned kEndingTime = 8;  // [s]
// In the environment of programs under an mpirun that first sends SIGCONT, and kills later, when it ends a job.
inline constexpr const char* kLauncherWarns = "FOOTFALL_LAUNCHER_WARNS";

// Announces the next such call within this time [s]. mpirun passes on the SIGCONT that resumes a suspended job: a
// SIGCONT that finds this call overdue ends a stop and does not request an end. An mpirun that does end the job sends
// SIGTERM soon after.
void promise_progress(double seconds);

bool is_ignored(int signal);

// Not 0 once a signal has requested the end.
const volatile std::sig_atomic_t& interrupted();
// Must a wait for the partner that has lasted so long [s] end, because this program has to? A partner that still
// responds gets the time for a window and a checkpoint, on a busy machine as well; a silent one gets less. Both get
// little when the parent process requested the end, unless it warns early: mpirun kills soon after its request.
bool must_stop_waiting(double waited);

// The same time limit for an orderly end that may wait for others: ends the program `seconds` from now with this exit
// code unless it has ended before. A limit that is already running stays.
void end_within(unsigned seconds, int exit_code);

}  // namespace footfall
