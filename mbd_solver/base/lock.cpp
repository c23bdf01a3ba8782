// Locks by flock(): the kernel releases them when the last process that inherited the open file has ended.

#include "mbd_solver/base/lock.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/run_directory.h"
#include "mbd_solver/base/codes.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kBetweenTries(100);
constexpr std::chrono::seconds kOrphanTime(30);  // child programs of a killed run end within this time
constexpr std::chrono::milliseconds kBetweenOrphanTries(200);

void write_owner(int file) {
  const std::string text = std::to_string(getpid()) + "\n";
  // Without this number messages name no process; the lock itself does not need it.
  if (ftruncate(file, 0) == 0 && pwrite(file, text.data(), text.size(), 0) < 0) return;
}

}  // namespace

// close() gives up our share of the lock; unlocking would take it away from the programs that we started.
FileLock::~FileLock() {
  if (file_ >= 0) close(file_);
}

FileLock::FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(file_, other.file_);
  return *this;
}

FileLock FileLock::try_lock(const std::string& path) {
  FileLock lock;
  // Child programs inherit it: no O_CLOEXEC.
  lock.file_ = open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK, 0644);
  if (lock.file_ < 0) throw InputError(code::kLockNotCreated, path + ": cannot be created: " + reason_of(errno));
  struct stat status {};
  if (fstat(lock.file_, &status) != 0 || !S_ISREG(status.st_mode))
    throw InputError(code::kLockNotCreated, path + ": is no regular file, as a lock is; remove it");
  int result = -1;
  do {
    result = flock(lock.file_, LOCK_EX | LOCK_NB);
  } while (result != 0 && errno == EINTR);
  if (result != 0 && errno == EWOULDBLOCK) return FileLock();
  write_owner(lock.file_);
  return lock;
}

FileLock FileLock::wait_for(const std::string& path, const std::function<void()>& on_wait) {
  FileLock lock = try_lock(path);
  if (!lock.held()) on_wait();
  while (!lock.held()) {
    std::this_thread::sleep_for(kBetweenTries);
    lock = try_lock(path);
  }
  return lock;
}

int owner_of(const std::string& lock_file) {
  std::ifstream file(lock_file);
  int process = 0;
  return file >> process ? process : 0;
}

bool is_alive(int process) {
  if (process <= 0 || (kill(process, 0) != 0 && errno != EPERM)) return false;
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(stat, line);
  const std::size_t end = line.rfind(')');  // the program's name may contain anything
  return end == std::string::npos || end + 2 >= line.size() || line[end + 2] != 'Z';  // Z: dead, not yet collected
}

FileLock lock_folder(const std::string& folder) {
  make_folder(folder);
  guard_folder(folder);
  const std::string file = (fs::path(folder) / kLockFile).string();
  const auto deadline = std::chrono::steady_clock::now() + kOrphanTime;
  FileLock lock = FileLock::try_lock(file);
  while (!lock.held() && !is_alive(owner_of(file)) && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(kBetweenOrphanTries);
    lock = FileLock::try_lock(file);
  }
  if (lock.held()) return lock;
  const int owner = owner_of(file);
  throw InputError(code::kFolderInUse, folder + ": another run writes to this folder" +
                                           (owner > 0 ? " (process " + std::to_string(owner) + ")" : std::string()) +
                                           "; wait until it has ended, or choose another folder with --out");
}

std::string locked_name(const std::string& folder) {
  std::error_code error;
  const fs::path full = fs::weakly_canonical(fs::absolute(folder, error), error);
  return error ? folder : (full / "").parent_path().string();
}

bool folder_is_held_for_us(const std::string& folder) {
  const char* held = std::getenv(kLockedFolder);
  return held && locked_name(folder) == held;
}

}  // namespace footfall
