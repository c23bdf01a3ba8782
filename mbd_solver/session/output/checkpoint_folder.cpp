// A checkpoint is complete or absent: its files are synced, listed with checksums, and the folder is renamed last. Readers
// take the newest one whose checksums agree.

#include "mbd_solver/session/output/checkpoint_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <sstream>

#include "coupler/base/codes.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/run_directory.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/fingerprint.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStored = 2;  // checkpoints
constexpr const char* kPart = ".part";
constexpr const char* kChecksums = "checksums.txt";

// Numbers of the complete checkpoints, newest first.
std::vector<long> checkpoints_in(const std::string& folder) {
  std::vector<long> numbers;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename();
    if (name.empty() || name.find_first_not_of("0123456789") != std::string::npos) continue;
    numbers.push_back(std::stol(name));
  }
  std::sort(numbers.rbegin(), numbers.rend());
  return numbers;
}

void remove_tree(const std::string& folder) { GuardedPath(folder).remove_all(); }

// Not a folder that contains a checkpoint, nor a link.
void remove_empty(const std::string& folder) {
  struct stat status {};
  if (lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) GuardedPath(folder).remove();
}

std::string checksum(const fs::path& file) {
  const std::optional<std::string> bytes = read_whole_file(file.string());
  if (!bytes) throw InputError(code::kCheckpointFile, file.string() + ": cannot be read");
  return fingerprint(*bytes);
}

// Checks the lines "checksum name". Returns what is damaged; empty when nothing is.
std::string damage_of(const fs::path& checkpoint) {
  const std::optional<std::string> list = read_whole_file((checkpoint / kChecksums).string());
  if (!list) return "has no " + std::string(kChecksums);
  std::istringstream lines(*list);
  std::string sum, name;
  while (lines >> sum >> name)
    if (!is_plain_name(name) || !fs::exists(checkpoint / name) || checksum(checkpoint / name) != sum)
      return name + " is damaged or missing";
  return "";
}

}  // namespace

void sync_to_disk(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  const bool done = file >= 0 && fsync(file) == 0;
  if (file >= 0) close(file);
  if (!done) throw InputError(code::kFileNotWritten, path + ": cannot be synced to the disk: is it full?");
}

std::string CheckpointFolder::begin(long n) {
  n_ = n;
  part_ = folder_ + "/" + std::to_string(n) + kPart;
  remove_tree(part_);
  make_folder(part_);
  return fs::absolute(part_).lexically_normal().string();
}

void CheckpointFolder::finish() {
  std::string list;
  for (const auto& entry : fs::directory_iterator(part_)) {
    list += checksum(entry.path()) + " " + entry.path().filename().string() + "\n";
    sync_to_disk(entry.path().string());
  }
  const std::string checksums = part_ + "/" + kChecksums, whole = folder_ + "/" + std::to_string(n_);
  write_whole_file(checksums, list);
  sync_to_disk(checksums);
  sync_to_disk(part_);
  remove_tree(whole);  // of an earlier part of a resumed run
  if (const int problem = GuardedPath(part_).rename_to(GuardedPath(whole)); problem != 0)
    throw InputError(code::kFileNotWritten, whole + ": cannot be written: " + reason_of(problem));
  sync_to_disk(folder_);
  part_.clear();
  written_.push_back(n_);
  const std::vector<long> numbers = checkpoints_in(folder_);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (i >= kStored) remove_tree(folder_ + "/" + std::to_string(numbers[i]));
}

void CheckpointFolder::cancel() {
  if (part_.empty()) return;
  remove_tree(part_);
  remove_empty(folder_);
  part_.clear();
}

void CheckpointFolder::clear() {
  for (const long n : written_) remove_tree(folder_ + "/" + std::to_string(n));
  written_.clear();
  cancel();  // required for a window that was not reached
  remove_empty(folder_);
}

void remove_unfinished_checkpoints(const std::string& run) {
  const fs::path folder = fs::path(run) / "checkpoint";
  std::error_code ignored;
  std::vector<fs::path> unfinished;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == kPart) unfinished.push_back(entry.path());
  for (const fs::path& part : unfinished) remove_tree(part.string());
  remove_empty(folder.string());
}

std::string newest_checkpoint(const std::string& run) {
  const std::string folder = run + "/checkpoint";
  guard_folder(run);
  // A checkpoint elsewhere would be changed with this run.
  const GuardedPath inside(folder + "/start");
  if (inside.problem() == ELOOP)
    throw InputError(code::kNoValidCheckpoint, folder + ": cannot be resumed from: " + reason_of(ELOOP));
  std::string damages;
  for (const long n : checkpoints_in(folder)) {
    const std::string checkpoint = folder + "/" + std::to_string(n);
    const std::string damage = damage_of(checkpoint);
    if (damage.empty()) return fs::absolute(checkpoint).lexically_normal().string();
    damages += "\n  " + checkpoint + ": " + damage;
  }
  throw InputError(code::kNoValidCheckpoint,
                   run + ": has no checkpoint to resume from" + (damages.empty() ? "" : ":" + damages) +
                       "\nA run writes one every output.checkpoint_interval (without it: every minute), and when it is "
                       "interrupted");
}

}  // namespace footfall
