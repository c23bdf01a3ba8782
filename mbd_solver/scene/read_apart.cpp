// A fork with limits of time and memory; the result comes back through a pipe.
#include "mbd_solver/scene/read_apart.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>

#include "mbd_solver/scene/codes.h"

namespace footfall {

using namespace code;

namespace {

constexpr rlim_t kSeconds = 5;                    // of processor time, and one more for each
constexpr std::size_t kBytesPerSecond = 1000000;  // of the file (a slow machine reads ten times as many)
constexpr rlim_t kMemory = rlim_t{1} << 30;       // [bytes], and
constexpr rlim_t kMemoryPerByte = 200;            // for each byte of the file
constexpr char kGood = '+', kWrong = '-';         // first character of an answer
constexpr int kCrashes[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};

// Address space in use [bytes].
[[maybe_unused]] rlim_t memory_now() {
  std::ifstream file("/proc/self/statm");
  rlim_t pages = 0;
  file >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

rlim_t seconds_for(std::size_t bytes) { return kSeconds + static_cast<rlim_t>(bytes / kBytesPerSecond); }

void limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(resource, &both);
}

void send(int pipe, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t n = ::write(pipe, text.data() + sent, text.size() - sent);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) _exit(1);
    sent += static_cast<std::size_t>(n);
  }
}

[[noreturn]] void answer(int pipe, const std::string& file, std::size_t bytes,
                         const std::function<std::string()>& read) {
  for (const int crash : kCrashes) signal(crash, SIG_DFL);  // no crash report
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds_for(bytes));
#if !defined(__SANITIZE_ADDRESS__) && !defined(FOOTFALL_SANITIZED)  // sanitizers reserve terabytes
  limit(RLIMIT_AS, memory_now() + kMemory + kMemoryPerByte * static_cast<rlim_t>(bytes));
#endif
  std::string text;
  try {
    text = kGood + read();
  } catch (const std::bad_alloc&) {
    text = kWrong + with_code(kMeshDamaged, file + ": needs more memory than a file of its size can; export it again");
  } catch (const std::exception& error) {
    text = kWrong + std::string(error.what());
  }
  send(pipe, text);
  _exit(0);
}

std::string received(int pipe) {
  std::string text;
  char buffer[65536];
  for (;;) {
    const ssize_t n = ::read(pipe, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

}  // namespace

std::string read_apart(const std::string& file, std::size_t bytes, const std::function<std::string()>& read) {
  int ends[2];
  const auto failed = [&] { return InputError(kFileNotReadable, file + ": cannot be read: " + std::strerror(errno)); };
  if (pipe(ends) != 0) throw failed();
  const pid_t child = fork();
  if (child < 0) {
    const InputError error = failed();
    close(ends[0]);
    close(ends[1]);
    throw error;
  }
  if (child == 0) {
    close(ends[0]);
    answer(ends[1], file, bytes, read);
  }
  close(ends[1]);
  const std::string text = received(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  std::string problem;
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
    problem = "was not read within " + std::to_string(seconds_for(bytes)) + " s";
  } else if (WIFSIGNALED(status)) {
    problem = std::string("crashed its reader (") + strsignal(WTERMSIG(status)) + ")";
  } else if (text.empty()) {
    problem = "ended its reader without a result";
  }
  if (!problem.empty())
    throw InputError(kMeshDamaged, file + ": " + problem + "; the file is damaged, export it again");
  if (text.front() == kWrong) throw InputError(text.substr(1));
  return text.substr(1);
}

}  // namespace footfall
