#pragma once
// Folders of runs come from other people as well, with links in them. A file that is written, changed or removed below
// a guarded folder is reached from the folder step by step, without following a link: no file outside can be meant.

#include <sys/types.h>

#include <fstream>
#include <string>

namespace footfall {

// From here on the functions below refuse links below this folder (which itself may be reached by links).
void guard_folder(const std::string& folder);

// A file or folder by its parent, opened, and its name there. Elsewhere than below a guarded folder: by its path.
class GuardedPath {
 public:
  explicit GuardedPath(const std::string& path);
  ~GuardedPath();
  GuardedPath(const GuardedPath&) = delete;
  GuardedPath& operator=(const GuardedPath&) = delete;

  // 0, or errno: ELOOP for a link on the way.
  int problem() const { return problem_; }
  // As open(). -1 and errno where that fails; ELOOP for a link.
  int open(int flags, mode_t mode = 0644) const;
  // As mkdir(), unlink() or rmdir(), rename(). 0 or errno. Removes a link itself, not its target.
  int make_folder() const;
  int remove() const;
  int rename_to(const GuardedPath& target) const;
  // Removes the file, or the folder with all it holds, without following links. 0 or errno; 0: there is nothing.
  int remove_all() const;

 private:
  bool guarded_ = false;
  int parent_;  // AT_FDCWD: none
  std::string name_;
  int problem_ = 0;
};

// Creates the folder and its parents. 0 or errno.
int create_folders(const std::string& folder);

// Opens a file for writing; kNew empties or creates it. False and errno where that fails.
enum class FileStart { kNew, kEnd };
bool open_file(std::ofstream& stream, const std::string& path, FileStart start);

// Why a file cannot be written: strerror, and for links the remedy.
std::string reason_of(int error);

}  // namespace footfall
