#pragma once
// Somebody asks a program to end: the user, the batch system, mpirun. The program looks at a flag where its work may
// stop, and a time limit ends it where it does not get there.

#include <csignal>

#include "coupler/base/errors.h"

namespace footfall {

// The end was asked for, here or at the partner's side. Exit code 3.
class Interrupted : public PartnerError {
 public:
  using PartnerError::PartnerError;
};

// From here on SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGUSR1 end this program with kExitInterrupted: at once while there is
// nothing to keep, and after work_is_under_way() in order, by a flag. Then the first signal starts a time limit: a
// program that is still there kEnding later ends without a word to anybody but standard error. `program`: its name, for
// that word; it must outlive the program. A SIGHUP that is ignored (nohup) stays so.
void end_on_signals(const char* program);
void work_is_under_way();
inline constexpr unsigned kEnding = 5;  // [s]

bool is_ignored(int signal);

// Not 0 once such a signal has come.
const volatile std::sig_atomic_t& interrupted();
// How long ago the first one came [s]; 0 without.
double seconds_since_interrupt();
// How long a wait for the partner may still go on after the signal, so that a window can end in order [s]. Little when
// the signal came from the parent process: mpirun kills soon after it has asked.
double grace_after_interrupt();

// The same time limit for an orderly end that may wait for others: ends the program `seconds` from now with this exit
// code unless it has ended before. A limit that runs already stays.
void end_within(unsigned seconds, int exit_code);

}  // namespace footfall
