// Every step by openat() with O_NOFOLLOW, from the file descriptor of the guarded folder. The paths of guarded folders are
// compared as text, absolute and without "..".

#include "coupler/base/run_directory.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <locale>
#include <map>

namespace footfall {
namespace {

namespace fs = std::filesystem;

// Absolute path -> its descriptor, open until the program ends.
std::map<std::string, int>& guarded_folders() {
  static std::map<std::string, int> folders;
  return folders;
}

std::string plain_path(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error).lexically_normal();
  return (absolute.has_filename() ? absolute : absolute.parent_path()).string();
}

bool is_link(int parent, const std::string& name) {
  struct stat status {};
  return fstatat(parent, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(status.st_mode);
}

// Returns -1 and errno.
int open_step(int parent, const std::string& name) {
  const int folder = openat(parent, name.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0 && errno == ENOTDIR) errno = is_link(parent, name) ? ELOOP : ENOTDIR;
  return folder;
}

std::string path_of_descriptor(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

// A file with a second name, which may be outside, becomes one of its own: as it is, or not at all if it is to be emptied.
// 0 or errno.
int separate(int parent, const std::string& name, bool emptied) {
  struct stat status {};
  if (fstatat(parent, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(status.st_mode) ||
      status.st_nlink < 2)
    return 0;
  if (emptied) return unlinkat(parent, name.c_str(), 0) == 0 ? 0 : errno;
  const std::string copy = name + ".part";
  unlinkat(parent, copy.c_str(), 0);  // perhaps a link
  const fs::path folder = path_of_descriptor(parent);
  std::error_code error;
  fs::copy_file(folder / name, folder / copy, error);
  if (error) return error.value();
  return renameat(parent, copy.c_str(), parent, name.c_str()) == 0 ? 0 : errno;
}

}  // namespace

void guard_folder(const std::string& folder) {
  const std::string path = plain_path(folder);
  for (fs::path root = path;; root = root.parent_path()) {
    if (guarded_folders().count(root.string()) > 0) return;
    if (root == root.parent_path()) break;
  }
  const int descriptor = ::open(path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) guarded_folders()[path] = descriptor;
}

GuardedPath::GuardedPath(const std::string& path) : parent_(AT_FDCWD), name_(path) {
  const std::string whole = plain_path(path);
  for (fs::path root = fs::path(whole).parent_path();; root = root.parent_path()) {
    const auto found = guarded_folders().find(root.string());
    if (found != guarded_folders().end()) {
      struct stat status {};
      if (fstat(found->second, &status) != 0 || status.st_nlink == 0) return;  // the folder is gone
      guarded_ = true;
      const fs::path below = fs::path(whole).lexically_relative(root);
      name_ = below.filename().string();
      parent_ = fcntl(found->second, F_DUPFD_CLOEXEC, 0);
      for (const fs::path& step : below.parent_path()) {
        const int next = open_step(parent_, step.string());
        const int error = errno;
        close(parent_);
        parent_ = next;
        if (next >= 0) continue;
        problem_ = error;
        return;
      }
      return;
    }
    if (root == root.parent_path()) return;
  }
}

GuardedPath::~GuardedPath() {
  if (parent_ >= 0) close(parent_);
}

int GuardedPath::open(int flags, mode_t mode) const {
  errno = problem_;
  if (problem_ != 0) return -1;
  if (guarded_ && (flags & O_PATH) == 0 && (flags & O_ACCMODE) != O_RDONLY) {
    errno = separate(parent_, name_, (flags & O_TRUNC) != 0);
    if (errno != 0) return -1;
  }
  // A pipe without a reader would wait for ever.
  const int file = openat(parent_, name_.c_str(), flags | O_CLOEXEC | O_NONBLOCK | (guarded_ ? O_NOFOLLOW : 0), mode);
  if (file < 0 && errno == ENOTDIR && guarded_) errno = is_link(parent_, name_) ? ELOOP : ENOTDIR;
  return file;
}

int GuardedPath::make_folder() const {
  if (problem_ != 0) return problem_;
  if (mkdirat(parent_, name_.c_str(), 0777) == 0) return 0;
  if (errno != EEXIST) return errno;
  const int folder = open(O_PATH | O_DIRECTORY);
  if (folder < 0) return errno == ENOTDIR ? EEXIST : errno;
  close(folder);
  return 0;
}

int GuardedPath::remove() const {
  if (problem_ != 0) return problem_;
  if (unlinkat(parent_, name_.c_str(), 0) == 0) return 0;
  if (errno != EISDIR) return errno;
  return unlinkat(parent_, name_.c_str(), AT_REMOVEDIR) == 0 ? 0 : errno;
}

int GuardedPath::rename_to(const GuardedPath& target) const {
  if (problem_ != 0 || target.problem_ != 0) return problem_ != 0 ? problem_ : target.problem_;
  return renameat(parent_, name_.c_str(), target.parent_, target.name_.c_str()) == 0 ? 0 : errno;
}

int GuardedPath::remove_all() const {
  if (problem_ != 0) return problem_ == ENOENT ? 0 : problem_;
  std::error_code error;
  // The library follows no links either, once its start is no link.
  fs::remove_all(guarded_ ? fs::path(path_of_descriptor(parent_)) / name_ : fs::path(name_), error);
  return error.value();
}

int create_folders(const std::string& folder) {
  const std::string whole = plain_path(folder);
  if (whole == "/" || whole.empty()) return 0;
  const GuardedPath place(whole);
  if (place.problem() == 0) {
    const int error = place.make_folder();
    if (error != ENOENT) return error;
  } else if (place.problem() != ENOENT) {
    return place.problem();
  }
  const int error = create_folders(fs::path(whole).parent_path().string());
  return error != 0 ? error : GuardedPath(whole).make_folder();
}

bool open_file(std::ofstream& stream, const std::string& path, FileStart start) {
  const int file = GuardedPath(path).open(O_RDWR | (start == FileStart::kNew ? O_CREAT | O_TRUNC : 0), 0666);
  if (file < 0) return false;
  const auto mode = start == FileStart::kNew ? std::ios::out : std::ios::in | std::ios::out | std::ios::ate;
  stream.open(path_of_descriptor(file), mode);
  stream.imbue(std::locale::classic());
  close(file);
  return stream.is_open();
}

std::string reason_of(int error) {
  if (error != ELOOP) return std::strerror(error);
  return "it is, or is below, a link in the folder of a run, which footfall does not follow; remove the link";
}

}  // namespace footfall
