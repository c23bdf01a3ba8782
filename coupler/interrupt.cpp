#include "coupler/interrupt.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace footfall {
namespace {

// After the signal, all less than kEnding [s]:
constexpr double kInAll = 7.0;       // for a partner that goes on
constexpr double kSilence = 5.0;     // for one that says nothing: it is stopped, or hangs
constexpr double kWarned = 4.5;      // for either, where mpirun has warned and will kill
constexpr double kUnwarned = 1.5;    // for either, where that warning was taken for the end of a stop
constexpr double kFromParent = 0.2;  // for either, where it has not

// One per process, as signals are. Handlers touch nothing else, and call nothing that a handler may not call.
volatile std::sig_atomic_t g_interrupted = 0;
volatile std::sig_atomic_t g_by_parent = 0;
volatile std::sig_atomic_t g_first = 0;  // the signal
volatile std::sig_atomic_t g_under_way = 0;
volatile std::sig_atomic_t g_exit_code = kExitInterrupted;
timespec g_when{};
const char* g_program = "footfall";
bool g_parent_warns = false;
std::atomic<std::int64_t> g_alive_until{0};  // CLOCK_MONOTONIC [ns]; 0: nobody has said
std::atomic<std::int64_t> g_woken{0};        // likewise, from a stop [ns]; 0: never
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a handler reads it");

std::int64_t now_in_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

// A SIGCONT that wakes us from a stop, or comes through mpirun soon after one that did.
bool wakes(std::int64_t now) {
  constexpr std::int64_t kSoon = 10'000'000'000;  // [ns]
  if (g_alive_until != 0 && now > g_alive_until) g_woken = now;
  return g_woken != 0 && now - g_woken < kSoon;
}

double seconds(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool from_parent(const siginfo_t& info) { return info.si_code <= 0 && info.si_pid == getppid(); }

void tell(const char* what) {
  (void)!write(STDERR_FILENO, g_program, std::strlen(g_program));
  (void)!write(STDERR_FILENO, what, std::strlen(what));
}

void note(int signal, siginfo_t* info, void*) {
  if (signal == SIGCONT && (wakes(now_in_ns()) || !from_parent(*info))) return;
  if (!g_under_way) {
    if (!from_parent(*info)) tell(": interrupted before there was anything to keep\n");
    _exit(kExitInterrupted);
  }
  if (from_parent(*info)) g_by_parent = 1;
  if (g_interrupted) return;
  g_first = signal;
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
  // What we say goes through the launcher. When that is gone, a word to nobody must not kill us before we are kept.
  if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr) std::signal(SIGPIPE, SIG_IGN);
  g_parent_warns = std::getenv(kLauncherWarns) != nullptr;
  if (g_parent_warns) sigaction(SIGCONT, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void alive_for(double seconds) { g_alive_until = now_in_ns() + static_cast<std::int64_t>(1e9 * seconds); }

void work_is_under_way() { g_under_way = 1; }

const volatile std::sig_atomic_t& interrupted() { return g_interrupted; }

bool waited_enough(double waited) {
  if (!g_interrupted) return false;
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const double since = seconds(now) - seconds(g_when);
  if (g_by_parent) return since > (!g_parent_warns ? kFromParent : g_first == SIGTERM ? kUnwarned : kWarned);
  return since > kInAll || std::min(since, waited) > kSilence;
}

void end_within(unsigned seconds, int exit_code) {
  if (g_interrupted) return;
  g_exit_code = exit_code;
  handle_alarm();
  alarm(seconds);
}

}  // namespace footfall
