#include "coupler/interrupt.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>

namespace footfall {
namespace {

constexpr double kWindow = 2.0;      // for the window that is under way [s]
constexpr double kFromParent = 0.2;  // likewise, before mpirun kills [s]

// One per process, as signals are. Handlers touch nothing else, and call nothing that a handler may not call.
volatile std::sig_atomic_t g_interrupted = 0;
volatile std::sig_atomic_t g_by_parent = 0;
volatile std::sig_atomic_t g_under_way = 0;
volatile std::sig_atomic_t g_exit_code = kExitInterrupted;
timespec g_when{};
const char* g_program = "footfall";

double seconds(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool from_parent(const siginfo_t& info) { return info.si_code <= 0 && info.si_pid == getppid(); }

void tell(const char* what) {
  (void)!write(STDERR_FILENO, g_program, std::strlen(g_program));
  (void)!write(STDERR_FILENO, what, std::strlen(what));
}

void note(int, siginfo_t* info, void*) {
  if (!g_under_way) {
    if (!from_parent(*info)) tell(": interrupted before there was anything to keep\n");
    _exit(kExitInterrupted);
  }
  if (from_parent(*info)) g_by_parent = 1;
  if (g_interrupted) return;
  const int kept = errno;
  clock_gettime(CLOCK_MONOTONIC, &g_when);
  g_interrupted = 1;
  alarm(kEnding);
  errno = kept;
}

void end_now(int) {
  tell(": was to end, and waits for somebody who does not answer: ends at once\n");
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
  action.sa_sigaction = note;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1})
    if (signal != SIGHUP || !is_ignored(signal)) sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void work_is_under_way() { g_under_way = 1; }

const volatile std::sig_atomic_t& interrupted() { return g_interrupted; }

double seconds_since_interrupt() {
  if (!g_interrupted) return 0.0;
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return seconds(now) - seconds(g_when);
}

double grace_after_interrupt() { return g_by_parent ? kFromParent : kWindow; }

void end_within(unsigned seconds, int exit_code) {
  if (g_interrupted) return;
  g_exit_code = exit_code;
  handle_alarm();
  alarm(seconds);
}

}  // namespace footfall
