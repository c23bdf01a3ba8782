#pragma once
// Locks: a file that one process at a time holds, and a folder that one run at a time writes to.

#include <functional>
#include <string>

namespace footfall {

// A lock file (flock). Child processes inherit it: the lock ends when the last of them has ended, however it ended.
class FileLock {
 public:
  FileLock() = default;  // holds nothing
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  // Holds nothing when another process has the lock. Where files cannot be locked (some network disks) it holds an open
  // file and keeps nobody out. Throws InputError when the file cannot be created.
  static FileLock try_lock(const std::string& path);
  // Waits until the lock is free; `on_wait` is called once before it waits. Throws as try_lock.
  static FileLock wait_for(const std::string& path, const std::function<void()>& on_wait);

  bool held() const { return file_ >= 0; }

 private:
  int file_ = -1;
};

// The process that took the lock last, as written in the file; 0 when none did.
int owner_of(const std::string& lock_file);
bool is_alive(int process);

inline constexpr const char* kLockFile = ".footfall.lock";  // in a run's folder

// Creates the folder and locks it. Throws InputError at once when another run holds it. Waits for some seconds where
// the run itself is dead and only programs that it started are still ending.
FileLock lock_folder(const std::string& folder);

// Environment variable NAME=VALUE: the `footfall` that started this program holds the lock of this folder.
inline constexpr const char* kLockedFolder = "FOOTFALL_LOCKED_FOLDER";
// The folder's full path, as the variable holds it.
std::string locked_name(const std::string& folder);
// True when the `footfall` that started this program holds the folder.
bool folder_is_held_for_us(const std::string& folder);

}  // namespace footfall
