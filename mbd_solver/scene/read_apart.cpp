// A fork with limits of time and memory; the result comes back through a file in memory.
#include "mbd_solver/scene/read_apart.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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

[[noreturn]] void answer(int result, const std::string& file, std::size_t bytes,
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
  _exit(::write(result, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1);
}

}  // namespace

std::string read_apart(const std::string& file, std::size_t bytes, const std::function<std::string()>& read) {
  const auto failed = [&] {
    return InputError(code::kFileNotReadable, file + ": cannot be read: " + std::strerror(errno));
  };
  const int result = memfd_create("footfall", MFD_CLOEXEC);
  if (result < 0) throw failed();
  const pid_t child = fork();
  if (child == 0) answer(result, file, bytes, read);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  std::string text(static_cast<std::size_t>(std::max<off_t>(0, lseek(result, 0, SEEK_END))), '\0');
  const bool whole = pread(result, &text[0], text.size(), 0) == static_cast<ssize_t>(text.size());
  close(result);
  if (child < 0 || !whole) throw failed();
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
