#pragma once
// Child programs with everything they start themselves: one at a time, watched and ended in order (run_child), or
// several at once (run_pool). Nothing that they start outlives this program.

#include <signal.h>
#include <sys/resource.h>
#include <sys/types.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mbd_solver/base/child_process.h"

namespace footfall {

struct ChildEnd {
  int code = 0;              // exit code; 128 + signal when a signal ended it
  double cpu = 0.0;          // processor time of all its programs [s]
  bool crashed = false;      // ended by a fault of its own (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT)
  bool interrupted = false;  // the user requested the end (SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1)
  std::string given_up;      // why run_child ended it, with a message code; empty: it did not
};

// Runs a command to its end. `tick` is called about five times per second; a text that it returns is the reason to end
// the command now. A signal that requests the end is forwarded as SIGINT to every descendant whose program is `graceful`
// (it ends the others in order), or as SIGTERM to all when there is none. Descendants that remain some seconds later are
// killed. Further signals are ignored (terminals and batch systems send several at once), except for a SIGINT typed
// again later, which kills at once. Returns when no descendant is left, ten seconds after the first signal at the
// latest. Throws InputError when the program cannot be started.
ChildEnd run_child(const Command& command, const std::string& graceful = "",
                   const std::function<std::string()>& tick = {});

// A tick of run_child: ends it when a descendant has been suspended (SIGSTOP) for `limit` [s], as the others wait for it.
class SuspendedWatch {
 public:
  explicit SuspendedWatch(double limit) : limit_(limit) {}
  std::string operator()();

 private:
  double limit_;                   // [s]
  double next_look_ = 0.0;         // wall clock [s]
  std::map<pid_t, double> since_;  // wall clock [s] since when each one has been suspended
};

// Memory of all descendants now [bytes], without shared files and libraries.
double memory_of_descendants();

// True for the exit code of a program that ended on request, by itself or by the signal.
bool was_asked_to_end(int exit_code);

// The part of run_child and run_pool that receives signals one by one.

// While an object of this class exists, SIGCHLD and the signals that request the end (SIGINT, SIGTERM, SIGHUP,
// SIGQUIT, SIGUSR1) are received by wait() instead of interrupting this program. They may be nested.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

  const sigset_t& held() const { return held_; }
  // Waits for at most one tick (a fifth of a second). Returns the signal that requests the end; 0: none.
  int wait() const;
  // Ignores them from here on, including those that have come and were not received.
  void ignore() const;

 private:
  sigset_t held_, old_;
};

// From the usage of wait4(): processor time of the process and of all children that it has waited for [s].
double processor_time(const rusage& usage);

// Runs all commands, at most `jobs` at once, in their order. `ended(index, exit code, processor time [s])` is called
// after each, with values as exit_code_of and processor_time give them. At SIGINT or SIGTERM, or when `ended` throws, no
// further one is started and the running ones get SIGINT; when they have ended, returns true or rethrows.
bool run_pool(const std::vector<Command>& commands, int jobs, const std::function<void(int, int, double)>& ended);

}  // namespace footfall
