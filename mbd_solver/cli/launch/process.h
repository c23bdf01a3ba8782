#pragma once
// Starting processes, and taking the signals that come while they run one by one.

#include <signal.h>
#include <sys/resource.h>
#include <sys/types.h>

#include "mbd_solver/cli/launch/child.h"

namespace footfall {

// While one of these lives, SIGCHLD and the signals that ask for the end (SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1)
// are taken one by one instead of interrupting us. They may be held within each other.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

  const sigset_t& held() const { return held_; }
  // Waits for at most one tick (a fifth of a second). The signal that asks for the end; 0 when none has come.
  int wait() const;
  // From here on they change nothing any more, nor do those that have come and were not waited for.
  void ignore() const;

 private:
  sigset_t held_, old_;
};

constexpr int kCannotStart = 127;  // exit code of a process whose program could not be started

// Starts a command in a process group of its own, with SIGTERM for it when we die. Throws InputError when there can be
// no process; a program that is not there ends with kCannotStart.
pid_t start_process(const Command& command, const SignalsHeld& signals);

// Of what waitpid() has said of a process that has ended: a signal counts as 128 + its number, as in a shell.
int exit_code_of(int status);

// Of what wait4() has said of one: its own time and that of all whose end it has seen [s].
double processor_time(const rusage& usage);

}  // namespace footfall
