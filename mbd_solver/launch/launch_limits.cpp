// Looks at the limits themselves: of a folder that is full mpirun reports after a minute, in words of its own, or never. The numbers
// are those below which Open MPI 4.1 with PMIx 4.2 fails, found by lowering each limit for 2, 4 and 8 processes.
#include "mbd_solver/launch/launch_limits.h"

#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/launch/codes.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kSegment = (4 << 20) + (64 << 10);  // largest file of MPI [bytes], with its header
constexpr std::uintmax_t kSegments = 2 * kSegment;  // in the temporary folder, of all processes together [bytes]
constexpr std::uintmax_t kOfProcess = 4 << 10;      // there, of each [bytes]
// In the shared memory a process makes its file where a whole one fits, and then touches 0.3 MB of it.
constexpr std::uintmax_t kTouched = 1 << 20;                // [bytes]
constexpr std::uintmax_t kEntries = 17;                     // files and folders there, and one of each process
constexpr std::uintmax_t kFiles = 40, kFilesOfProcess = 4;  // open in mpirun, and a dozen of the programs themselves

[[noreturn]] void refuse(const std::string& what) {
  throw InputError(code::kNoRoomToLaunch, "mpirun could not start the programs: " + what);
}

std::string kilobytes(std::uintmax_t bytes) { return std::to_string(bytes >> 10) + " kB"; }

// Where mpirun puts its files; it makes the folder where that is missing.
std::string temporary_folder() {
  for (const char* name : {"OMPI_MCA_orte_tmpdir_base", "PRTE_MCA_prte_tmpdir_base", "TMPDIR", "TEMP", "TMP"})
    if (const char* folder = std::getenv(name); folder != nullptr && *folder != '\0') return folder;
  return "/tmp";
}

void require_temporary_folder(std::uintmax_t processes) {
  const std::string folder = temporary_folder(), name = "the temporary folder " + folder;
  const std::string advice = "; free space there, or name another folder in the variable TMPDIR";
  std::error_code unknown;
  fs::path there = fs::absolute(folder, unknown);
  while (access(there.c_str(), F_OK) != 0 && errno == ENOENT && there.has_relative_path()) there = there.parent_path();
  if (access(there.c_str(), W_OK | X_OK) != 0)
    refuse(name + " cannot be written to (" + std::strerror(errno) + "); name another folder in the variable TMPDIR");
  struct statvfs disk {};
  if (statvfs(there.c_str(), &disk) != 0) return;
  const std::uintmax_t space = disk.f_bavail * static_cast<std::uintmax_t>(disk.f_frsize);
  const std::uintmax_t needed = kSegments + processes * kOfProcess;
  if (space < needed)
    refuse(name + " has " + kilobytes(space) + " left, and MPI needs " + kilobytes(needed) + " there" + advice);
  if (disk.f_files > 0 && disk.f_favail < kEntries + processes)  // some file systems do not count files
    refuse(name + " has room for " + std::to_string(disk.f_favail) +
           " more files and folders (inodes), and MPI needs " + std::to_string(kEntries + processes) + advice);
}

// Whether processes reach each other by shared memory: unless the user has chosen other ways.
bool is_by_memory() {
  const char* const ways = std::getenv("OMPI_MCA_btl");
  if (ways == nullptr || *ways == '\0') return true;
  const bool named = std::strstr(ways, "vader") != nullptr || std::strstr(ways, "sm") != nullptr;
  return named != (*ways == '^');
}

// Open MPI maps a file of each process there, without reserving its pages: without room they reach each other by the network, at a
// cost and only where there is one, and a page that finds no room later is a SIGBUS.
void require_shared_memory(std::uintmax_t processes) {
  const char* const chosen = std::getenv("OMPI_MCA_btl_vader_backing_directory");
  const std::string folder = chosen != nullptr && *chosen != '\0' ? chosen : "/dev/shm";
  struct statvfs disk {};
  if (processes < 2 || !is_by_memory() || access(folder.c_str(), W_OK | X_OK) != 0 ||
      statvfs(folder.c_str(), &disk) != 0)
    return;  // then MPI puts these files into the temporary folder
  const std::uintmax_t space = disk.f_bavail * static_cast<std::uintmax_t>(disk.f_frsize);
  const std::uintmax_t needed = kSegment + (processes - 1) * kTouched;
  if (space >= needed) return;
  refuse("the shared memory " + folder + " has " + kilobytes(space) + " left, and MPI needs " + kilobytes(needed) +
         " there for " + std::to_string(processes) +
         " processes; remove files that other programs have left there (ls -l " + folder +
         "), make it larger (mount -o remount,size=256m " + folder +
         "; docker run --shm-size=256m), or use fewer ranks (--ranks)");
}

rlim_t limit_of(int resource) {
  rlimit limit{};
  return getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

}  // namespace

void require_room_to_launch(int processes) {
  const auto count = static_cast<std::uintmax_t>(processes);
  require_temporary_folder(count);
  require_shared_memory(count);
  if (const rlim_t files = limit_of(RLIMIT_NOFILE); files < kFiles + kFilesOfProcess * count)
    refuse("at most " + std::to_string(files) + " files may be open (ulimit -n), and MPI needs " +
           std::to_string(kFiles + kFilesOfProcess * count) + " for " + std::to_string(processes) +
           " processes; raise the limit");
  if (const rlim_t size = limit_of(RLIMIT_FSIZE); size < kSegment)
    refuse("a file may have at most " + kilobytes(size) + " (ulimit -f), and MPI needs files of " +
           kilobytes(kSegment) + "; raise the limit");
}

}  // namespace footfall
