#pragma once
// A file that one process at a time holds (flock). Programs that the holder starts hold it with it: the lock goes when
// the last of them has ended, however it ended.

#include <functional>
#include <string>

namespace footfall {

class FileLock {
 public:
  FileLock() = default;  // holds nothing
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  // Holds nothing when somebody else does. Where files cannot be locked (some network disks) it holds an open file,
  // and nobody is kept out. Throws InputError when the file cannot be made.
  static FileLock try_lock(const std::string& path);
  // Waits until nobody else holds it; `told` is called once before. Throws as try_lock.
  static FileLock wait_for(const std::string& path, const std::function<void()>& told);

  bool held() const { return file_ >= 0; }

 private:
  int file_ = -1;
};

// The process that took the lock last, as it wrote into the file; 0 when nobody did.
int owner_of(const std::string& lock_file);
bool is_alive(int process);

}  // namespace footfall
