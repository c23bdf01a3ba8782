// Writes through a draft `PATH.part` that is renamed over the target: rename() is atomic.

#include "coupler/base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/codes.h"
#include "coupler/base/errors.h"
#include "coupler/base/input_file.h"
#include "coupler/base/run_directory.h"

namespace footfall {
namespace {

bool in_place = false;  // write_all_files_in_place

// Returns 0 or errno. After a sync the content is on the disk before the file is closed.
int write_all(int file, const std::string& text, bool sync) {
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

void write_file(const std::string& path, const std::string& text, const std::string& advice, bool sync) {
  const GuardedPath draft(path + ".part"), target(path);
  int problem = 0;
  if (in_place) {
    problem = write_all(target.open(O_WRONLY | O_CREAT | O_TRUNC), text, false);
  } else {
    draft.remove();  // of a program that was killed, or a link of someone else
    problem = write_all(draft.open(O_WRONLY | O_CREAT | O_EXCL), text, sync);
    if (problem == 0) problem = draft.rename_to(target);
    if (problem != 0) draft.remove();
  }
  if (problem == 0) return;
  throw InputError(code::kFileNotWritten, path + ": cannot be written: " + reason_of(problem) + "; " + advice);
}

}  // namespace

void make_folder(const std::string& folder, const std::string& advice) {
  if (const int problem = create_folders(folder); problem != 0)
    throw InputError(code::kFolderNotCreated, folder + ": cannot be created: " + reason_of(problem) + "; " + advice);
}

std::optional<std::string> read_whole_file(const std::string& path) {
  require_regular_file(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  std::string text(unknown ? 0 : static_cast<std::size_t>(size), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (file) {  // files of /proc have no size, others grow
    std::ostringstream rest;
    rest << file.rdbuf();
    text += rest.str();
  }
  return text;
}

void write_whole_file(const std::string& path, const std::string& text, const std::string& advice) {
  write_file(path, text, advice, true);
}

void write_all_files_in_place() { in_place = true; }

void write_whole_file_unsynced(const std::string& path, const std::string& text, const std::string& advice) {
  write_file(path, text, advice, false);
}

std::int64_t file_changed(const std::string& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0) return 0;
  return static_cast<std::int64_t>(status.st_ctim.tv_sec) * 1'000'000'000 + status.st_ctim.tv_nsec;
}

}  // namespace footfall
