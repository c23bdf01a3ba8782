// Writes through a draft `PATH.part` that is renamed over the target: rename() is atomic.

#include "coupler/base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/codes.h"

namespace footfall {
namespace {

// Returns 0 or errno. After a sync the content is on the disk before the file gets its name.
int write_all(const std::string& path, const std::string& text, bool sync) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return errno;
  int problem = 0;
  for (std::size_t done = 0; problem == 0 && done < text.size();) {
    const ssize_t n = write(file, text.data() + done, text.size() - done);
    if (n > 0) done += static_cast<std::size_t>(n);
    if (n < 0 && errno != EINTR) problem = errno;
  }
  if (sync && problem == 0 && fsync(file) != 0 && errno != EINVAL && errno != EROFS)
    problem = errno;  // EINVAL: a pipe, which cannot be synced
  if (close(file) != 0 && problem == 0) problem = errno;
  return problem;
}

void write_draft_and_rename(const std::string& path, const std::string& text, const std::string& advice, bool sync) {
  const std::string draft = path + ".part";
  int problem = write_all(draft, text, sync);
  if (problem == 0 && std::rename(draft.c_str(), path.c_str()) != 0) problem = errno;
  if (problem == 0) return;
  unlink(draft.c_str());
  throw InputError(code::kFileNotWritten, path + ": cannot be written: " + std::strerror(problem) + "; " + advice);
}

}  // namespace

void make_folder(const std::string& folder, const std::string& advice) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError(code::kFolderNotCreated, folder + ": cannot be created: " + error.message() + "; " + advice);
}

std::optional<std::string> read_whole_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_whole_file(const std::string& path, const std::string& text, const std::string& advice) {
  write_draft_and_rename(path, text, advice, true);
}

void write_whole_file_unsynced(const std::string& path, const std::string& text, const std::string& advice) {
  write_draft_and_rename(path, text, advice, false);
}

std::int64_t file_changed(const std::string& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0) return 0;
  return static_cast<std::int64_t>(status.st_ctim.tv_sec) * 1'000'000'000 + status.st_ctim.tv_nsec;
}

}  // namespace footfall
