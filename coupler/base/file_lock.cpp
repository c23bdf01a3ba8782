#include "coupler/base/file_lock.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>
#include <utility>

#include "coupler/base/errors.h"

namespace footfall {

namespace {

constexpr std::chrono::milliseconds kBetweenTries(100);

void note_owner(int file) {
  const std::string text = std::to_string(getpid()) + "\n";
  // A number that cannot be written makes a message poorer, not the lock weaker.
  if (ftruncate(file, 0) == 0 && pwrite(file, text.data(), text.size(), 0) < 0) return;
}

}  // namespace

// Closing gives our share back; unlocking would take it from the programs that we started.
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
  lock.file_ = open(path.c_str(), O_RDWR | O_CREAT, 0644);  // programs that we start inherit it
  if (lock.file_ < 0) throw InputError(path + ": cannot be made: " + std::strerror(errno));
  int result = -1;
  do {
    result = flock(lock.file_, LOCK_EX | LOCK_NB);
  } while (result != 0 && errno == EINTR);
  if (result != 0 && errno == EWOULDBLOCK) return FileLock();
  note_owner(lock.file_);
  return lock;
}

FileLock FileLock::wait_for(const std::string& path, const std::function<void()>& told) {
  FileLock lock = try_lock(path);
  if (!lock.held()) told();
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
  const std::size_t end = line.rfind(')');  // the program's name may hold anything
  return end == std::string::npos || end + 2 >= line.size() || line[end + 2] != 'Z';  // a dead one that nobody collects
}

}  // namespace footfall
