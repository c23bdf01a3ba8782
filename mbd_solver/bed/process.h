#pragma once
// One child program of the front door, with everything it starts itself: nothing of it survives the front door.

#include <signal.h>
#include <sys/resource.h>
#include <sys/types.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace footfall {

struct Command {
  std::vector<std::string> words;                  // program and arguments
  std::map<std::string, std::string> environment;  // added to ours
  std::string output;  // file that takes standard output and error; empty: they go where ours go
  std::string folder;  // to start in; empty: where we are
};

struct ChildEnd {
  int code = 0;              // exit code; 128 + signal when a signal ended it
  double cpu = 0.0;          // processor time of all its programs [s]
  bool crashed = false;      // it was ended by a fault of its own (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT)
  bool interrupted = false;  // the user asked for the end (SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1)
  std::string given_up;      // why we ended it ourselves; empty: we did not
};

// Runs a command to its end. `tick` is called about five times a second; what it returns, unless empty, is why the
// command is to be ended now. A signal that asks for the end is forwarded as SIGINT to every descendant whose program is
// `graceful` (the one that ends the others in order), or as SIGTERM to all when there is none. Who is still there some
// seconds later is killed. More signals change nothing (terminals and batch systems send several at once), but for
// another SIGINT later: who types it twice does not want to wait. Returns with no descendant left, ten seconds after
// the first signal at the latest. Throws InputError when the program cannot be started.
ChildEnd run_child(const Command& command, const std::string& graceful = "",
                   const std::function<std::string()>& tick = {});

// Watches for descendants that are stopped (SIGSTOP) and stay so for this long [s]: such a one answers nobody, and
// nobody else may wait for it. A tick of run_child: says which one it is.
class StoppedWatch {
 public:
  explicit StoppedWatch(double limit) : limit_(limit) {}
  std::string operator()();

 private:
  double limit_;                   // [s]
  double next_look_ = 0.0;         // wall clock [s]
  std::map<pid_t, double> since_;  // wall clock [s] from which on each one was seen stopped
};

// What all processes below this one have of their own now [bytes]: without files and libraries that they share.
double memory_of_descendants();

// Of a program that was asked to end: it says so, or died of a signal that asks for the end.
bool was_asked_to_end(int exit_code);

// As a shell would take it, environment first.
std::string shell_line(const Command& command);

// Starting processes, and taking the signals that come while they run one by one.

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

// Several commands at once, each with its output in a file.

// Runs all commands, at most `jobs` at once, in their order. `ended(index, exit code, processor time)` is called after
// each; the code is 128 + signal when a signal ended it, the time [s] is that of the command and of all it waited for.
// At SIGINT or SIGTERM, or when `ended` throws, no new one is started, those at work get SIGINT and are waited for; true
// says so, or what was thrown is thrown on.
bool run_pool(const std::vector<Command>& commands, int jobs, const std::function<void(int, int, double)>& ended);

}  // namespace footfall
