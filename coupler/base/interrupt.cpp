// Signal handlers that set flags and an alarm. SIGCONT has two meanings: a suspended job resumes, or mpirun warns that it
// will kill. After a suspension the last promise of progress is overdue.

#include "coupler/base/interrupt.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

// Longest waits for the partner after the signal, all below kEndingTime [s].
constexpr double kResponding = 7.0;  // a partner that responds
constexpr double kSilent = 5.0;      // a silent one: it is stopped or hangs
constexpr double kWarned = 4.5;      // either, when mpirun has warned and will kill
constexpr double kUnwarned = 1.5;    // either, when the warning was taken for the end of a stop
constexpr double kFromParent = 0.2;  // either, when mpirun requested the end without a warning

// One per process, as signals are. Handlers use only these and async-signal-safe functions.
volatile std::sig_atomic_t g_interrupted = 0;
volatile std::sig_atomic_t g_by_parent = 0;
volatile std::sig_atomic_t g_first_signal = 0;
volatile std::sig_atomic_t g_under_way = 0;
volatile std::sig_atomic_t g_exit_code = kExitInterrupted;
timespec g_when{};
const char* g_program = "footfall";
bool g_parent_warns = false;
std::atomic<std::int64_t> g_promised_until{0};  // CLOCK_MONOTONIC [ns]; 0: no promise yet
std::atomic<std::int64_t> g_resumed{0};         // time of the last end of a stop [ns]; 0: never
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler reads it");

std::int64_t now_in_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

// Does this SIGCONT end a stop, or did mpirun send it soon after a SIGCONT that did?
bool ends_stop(std::int64_t now) {
  constexpr std::int64_t kSoon = 10'000'000'000;  // [ns]
  if (g_promised_until != 0 && now > g_promised_until) g_resumed = now;
  return g_resumed != 0 && now - g_resumed < kSoon;
}

double seconds(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool from_parent(const siginfo_t& info) { return info.si_code <= 0 && info.si_pid == getppid(); }

void print_error(const char* what) {
  (void)!write(STDERR_FILENO, g_program, std::strlen(g_program));
  (void)!write(STDERR_FILENO, what, std::strlen(what));
}

void on_signal(int signal, siginfo_t* info, void*) {
  if (signal == SIGCONT && (ends_stop(now_in_ns()) || !from_parent(*info))) return;
  if (!g_under_way) {
    if (!from_parent(*info)) print_error(": interrupted before there was anything to save\n");
    _exit(kExitInterrupted);
  }
  if (from_parent(*info)) g_by_parent = 1;
  if (g_interrupted) return;
  g_first_signal = signal;
  const int saved_errno = errno;
  clock_gettime(CLOCK_MONOTONIC, &g_when);
  g_interrupted = 1;
  alarm(kEndingTime);
  errno = saved_errno;
}

void end_now(int) {
  print_error(": could not end in order in time, because it waits for a process that does not respond; ends at once\n");
  _exit(g_exit_code);
}

void handle_alarm() {
  struct sigaction action {};
  action.sa_handler = end_now;
  sigaction(SIGALRM, &action, nullptr);
}

}  // namespace

void end_on_signals(const char* program) {
  g_program = program;
  handle_alarm();
  struct sigaction action {};
  action.sa_sigaction = on_signal;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1})
    if (signal != SIGHUP || !is_ignored(signal)) sigaction(signal, &action, nullptr);
  g_parent_warns = std::getenv(kLauncherWarns) != nullptr;
  if (g_parent_warns) sigaction(SIGCONT, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void promise_progress(double seconds) { g_promised_until = now_in_ns() + static_cast<std::int64_t>(1e9 * seconds); }

void work_is_under_way() { g_under_way = 1; }

const volatile std::sig_atomic_t& interrupted() { return g_interrupted; }

bool must_stop_waiting(double waited) {
  if (!g_interrupted) return false;
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const double since = seconds(now) - seconds(g_when);
  if (g_by_parent) return since > (!g_parent_warns ? kFromParent : g_first_signal == SIGTERM ? kUnwarned : kWarned);
  return since > kResponding || std::min(since, waited) > kSilent;
}

void end_within(unsigned seconds, int exit_code) {
  if (g_interrupted) return;
  g_exit_code = exit_code;
  handle_alarm();
  alarm(seconds);
}

}  // namespace footfall
