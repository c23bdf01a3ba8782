// Signals are received one by one with sigtimedwait; all descendants are found in /proc and ended in order.
#include "mbd_solver/base/child_watch.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "coupler/base/clock.h"
#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "coupler/base/interrupt.h"
#include "mbd_solver/base/codes.h"

namespace footfall {
namespace {

constexpr std::chrono::nanoseconds kTick = std::chrono::milliseconds(200);

using Clock = std::chrono::steady_clock;
// Ten seconds in all, from a signal to the last process.
constexpr std::chrono::seconds kGrace(kEndingTime + 1);  // to write a checkpoint and end in order, before SIGKILL
constexpr std::chrono::seconds kAfterEnd(1);             // from the end of the child to SIGTERM for its descendants
constexpr std::chrono::seconds kAfterTerm(1);            // from SIGTERM to SIGKILL
constexpr std::chrono::milliseconds kTypedAgain(500);    // least time from the first signal to a SIGINT typed again

// Every process below this one; on request only the suspended ones.
std::vector<pid_t> descendants(bool only_suspended = false) {
  std::map<pid_t, std::vector<pid_t>> children;
  std::set<pid_t> suspended;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream stat(entry.path() / "stat");
    std::string line;
    std::getline(stat, line);
    const std::size_t end = line.rfind(')');  // the program's name may contain anything
    char state = '?';
    int parent = 0;
    if (end == std::string::npos || std::sscanf(line.c_str() + end + 1, " %c %d", &state, &parent) != 2 || state == 'Z')
      continue;
    children[parent].push_back(std::stoi(name));
    if (state == 'T') suspended.insert(std::stoi(name));
  }
  std::vector<pid_t> found = children[getpid()];
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::vector<pid_t> next = children[found[i]];
    found.insert(found.end(), next.begin(), next.end());
  }
  const auto left_out = [&](pid_t pid) { return only_suspended && suspended.count(pid) == 0; };
  found.erase(std::remove_if(found.begin(), found.end(), left_out), found.end());
  return found;
}

// Wakes a launcher whose programs have all ended: after mpirun has requested their end, it looks again only seconds
// later. SIGCHLD wakes it and is harmless to other programs.
void wake_launcher_without_children(pid_t launcher) {
  const std::string folder = concat("/proc/", launcher);
  std::ifstream children(concat(folder, "/task/", launcher, "/children"));
  for (pid_t child = 0; children >> child;) {
    std::ifstream stat(concat("/proc/", child, "/stat"));
    std::string line;
    std::getline(stat, line);
    const std::size_t end = line.rfind(')');
    if (end != std::string::npos && line.compare(end, 3, ") Z") != 0) return;
  }
  kill(launcher, SIGCHLD);
}

std::string program_of(pid_t pid) {
  std::error_code gone;
  return std::filesystem::read_symlink(concat("/proc/", pid, "/exe"), gone).filename();
}

void send_all(const std::vector<pid_t>& pids, int signal) {
  for (pid_t pid : pids) kill(pid, signal);
}

// Requests an orderly end; false when no descendant is `graceful`. Suspended descendants are continued, so that they can end.
bool ask_gracefully(const std::string& graceful) {
  bool asked = false;
  send_all(descendants(true), SIGCONT);
  for (pid_t pid : descendants()) {
    if (graceful.empty() || program_of(pid) != graceful) continue;
    kill(pid, SIGINT);
    asked = true;
  }
  return asked;
}

bool is_fault(int signal) {
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    if (signal == fault) return true;
  return false;
}

// Waits for every child that has ended (orphans of the child become ours). True when `pid` is among them; `status` is
// then its status, `cpu` its processor time [s].
bool reap(pid_t pid, int& status, double& cpu) {
  bool ended = false;
  int s = 0;
  rusage usage{};
  for (pid_t child = wait4(-1, &s, WNOHANG, &usage); child > 0; child = wait4(-1, &s, WNOHANG, &usage)) {
    if (child != pid) continue;
    status = s;
    cpu = processor_time(usage);
    ended = true;
  }
  return ended;
}

}  // namespace

double processor_time(const rusage& usage) {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

SignalsHeld::SignalsHeld() {
  sigemptyset(&held_);
  for (int signal : {SIGINT, SIGTERM, SIGQUIT, SIGUSR1, SIGCHLD}) sigaddset(&held_, signal);
  if (!is_ignored(SIGHUP)) sigaddset(&held_, SIGHUP);  // nohup
  sigprocmask(SIG_BLOCK, &held_, &old_);
}

SignalsHeld::~SignalsHeld() { sigprocmask(SIG_SETMASK, &old_, nullptr); }

int SignalsHeld::wait() const {
  const timespec tick{0, kTick.count()};
  const int signal = sigtimedwait(&held_, nullptr, &tick);
  return signal > 0 && signal != SIGCHLD ? signal : 0;
}

void SignalsHeld::ignore() const {
  for (const int signal : {SIGINT, SIGTERM, SIGQUIT, SIGUSR1, SIGHUP}) std::signal(signal, SIG_IGN);
}

int count_descendants(bool only_suspended) { return static_cast<int>(descendants(only_suspended).size()); }

std::string SuspendedWatch::operator()() {
  const double now = wall_clock();
  if (now < next_look_) return "";
  next_look_ = now + 1.0;
  std::map<pid_t, double> since;
  for (const pid_t pid : descendants(true)) since[pid] = since_.count(pid) ? since_[pid] : now;
  since_ = since;
  for (const auto& [pid, start] : since_)
    if (now - start > limit_)
      return with_code(code::kProgramSuspended, program_of(pid), " (process ", pid,
                       ") has been suspended (SIGSTOP) for ", limit_, " s, and the other programs wait for it");
  return "";
}

ChildEnd run_child(const Command& command, const std::string& graceful, const std::function<std::string()>& tick) {
  const SignalsHeld signals;
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const pid_t pid = start_program(command);

  ChildEnd end;
  int status = 0;
  bool ended = false, terminated = false;
  Clock::time_point deadline = Clock::time_point::max(), asked = deadline;
  const auto terminate = [&] {
    send_all(descendants(), terminated ? SIGKILL : SIGTERM);
    terminated = true;
    deadline = Clock::now() + kAfterTerm;
  };
  while (!ended || !descendants().empty()) {
    const int signal = signals.wait();
    if (signal != 0 && !end.interrupted) {
      end.interrupted = true;
      asked = Clock::now();
      if (ask_gracefully(graceful)) {
        deadline = asked + kGrace;
        terminated = true;  // the end was requested; the next step is SIGKILL
      } else {
        terminate();
      }
    } else if (signal == SIGINT && Clock::now() > asked + kTypedAgain) {
      terminate();
    }
    if (reap(pid, status, end.cpu)) {
      ended = true;
      if (deadline == Clock::time_point::max()) {
        // Open MPI ends the programs of a launcher that a signal has ended only a second later.
        terminated = was_asked_to_end(exit_code_of(status)) && ask_gracefully(graceful);
        deadline = Clock::now() + (terminated ? kGrace : kAfterEnd);
      }
    }
    if (!ended) wake_launcher_without_children(pid);
    if (Clock::now() > deadline) terminate();
    if (!tick || ended || end.interrupted || !end.given_up.empty()) continue;
    end.given_up = tick();
    if (!end.given_up.empty()) terminate();
  }
  reap(pid, status, end.cpu);  // orphans killed last
  end.code = exit_code_of(status);
  end.crashed = WIFSIGNALED(status) && is_fault(WTERMSIG(status));
  if (end.code == kCannotStart)
    throw InputError(code::kProgramNotStarted, "cannot start ", command.words[0], "; is it installed?");
  return end;
}

double memory_of_descendants() {
  double sum = 0.0;
  for (const pid_t pid : descendants()) {
    std::ifstream status(concat("/proc/", pid, "/status"));
    for (std::string word; status >> word;)
      if (double kilobytes = 0.0; word == "RssAnon:" && status >> kilobytes) sum += 1024.0 * kilobytes;
  }
  return sum;
}

bool was_asked_to_end(int exit_code) {
  if (exit_code == kExitInterrupted) return true;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1})
    if (exit_code == 128 + signal) return true;
  return false;
}

bool run_pool(const std::vector<Command>& commands, int jobs, const std::function<void(int, int, double)>& ended) {
  const SignalsHeld signals;
  std::map<pid_t, int> running;  // number of each process
  std::size_t next = 0;
  bool interrupted = false;
  std::exception_ptr failure;
  const auto interrupt = [&] {
    interrupted = true;
    for (const auto& [pid, number] : running) kill(pid, SIGINT);
  };
  while (!running.empty() || (next < commands.size() && !interrupted)) {
    while (next < commands.size() && !interrupted && static_cast<int>(running.size()) < jobs) {
      running[start_program(commands[next])] = static_cast<int>(next);
      ++next;
    }
    if (signals.wait() != 0) interrupt();
    for (auto it = running.begin(); it != running.end();) {
      int status = 0;
      rusage usage{};
      if (wait4(it->first, &status, WNOHANG, &usage) != it->first) {
        ++it;
        continue;
      }
      const int number = it->second;
      it = running.erase(it);
      try {
        ended(number, exit_code_of(status), processor_time(usage));
      } catch (...) {
        if (!failure) failure = std::current_exception();
        interrupt();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
  return interrupted;
}

}  // namespace footfall
