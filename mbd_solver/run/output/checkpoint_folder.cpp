#include "mbd_solver/run/output/checkpoint_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "mbd_solver/base/fingerprint.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKept = 2;  // sets
constexpr const char* kPart = ".part";
constexpr const char* kChecksums = "checksums.txt";

// The numbers of the whole sets, newest first.
std::vector<long> sets_in(const std::string& folder) {
  std::vector<long> sets;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename();
    if (name.empty() || name.find_first_not_of("0123456789") != std::string::npos) continue;
    sets.push_back(std::stol(name));
  }
  std::sort(sets.rbegin(), sets.rend());
  return sets;
}

std::string checksum(const fs::path& file) {
  const std::optional<std::string> bytes = read_whole_file(file.string());
  if (!bytes) throw InputError(file.string() + ": cannot be read");
  return fingerprint(*bytes);
}

// Lines "checksum name". What is wrong with the set; empty when nothing is.
std::string fault(const fs::path& set) {
  const std::optional<std::string> list = read_whole_file((set / kChecksums).string());
  if (!list) return "has no " + std::string(kChecksums);
  std::istringstream lines(*list);
  std::string sum, name;
  while (lines >> sum >> name)
    if (!fs::exists(set / name) || checksum(set / name) != sum) return name + " is damaged or missing";
  return "";
}

}  // namespace

void sync_to_disk(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  const bool done = file >= 0 && fsync(file) == 0;
  if (file >= 0) close(file);
  if (!done) throw InputError(path + ": cannot be brought to the disk; is it full?");
}

std::string CheckpointFolder::begin(long n) {
  n_ = n;
  part_ = folder_ + "/" + std::to_string(n) + kPart;
  std::error_code error;
  fs::remove_all(part_, error);
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
  std::error_code error;
  fs::remove_all(whole, error);  // of a run that was resumed before it
  fs::rename(part_, whole, error);
  if (error) throw InputError(whole + ": cannot be written: " + error.message());
  sync_to_disk(folder_);
  part_.clear();
  written_.push_back(n_);
  const std::vector<long> sets = sets_in(folder_);
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (i >= kKept) fs::remove_all(folder_ + "/" + std::to_string(sets[i]), error);
}

void CheckpointFolder::drop() {
  if (part_.empty()) return;
  std::error_code ignored;
  fs::remove_all(part_, ignored);
  fs::remove(folder_, ignored);  // unless it holds a set
  part_.clear();
}

void CheckpointFolder::clear() {
  std::error_code ignored;
  for (const long n : written_) fs::remove_all(folder_ + "/" + std::to_string(n), ignored);
  written_.clear();
  drop();  // asked for at the end of a window that never came
  fs::remove(folder_, ignored);
}

void remove_unfinished_sets(const std::string& run) {
  const fs::path folder = fs::path(run) / "checkpoint";
  std::error_code ignored;
  std::vector<fs::path> unfinished;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == kPart) unfinished.push_back(entry.path());
  for (const fs::path& part : unfinished) fs::remove_all(part, ignored);
  fs::remove(folder, ignored);  // unless it holds a set
}

std::string newest_checkpoint(const std::string& run) {
  const std::string folder = run + "/checkpoint";
  std::string faults;
  for (const long n : sets_in(folder)) {
    const std::string set = folder + "/" + std::to_string(n);
    const std::string wrong = fault(set);
    if (wrong.empty()) return fs::absolute(set).lexically_normal().string();
    faults += "\n  " + set + ": " + wrong;
  }
  throw InputError(
      run + ": has no checkpoint to go on from" + (faults.empty() ? "" : ":" + faults) +
      "\nA run writes one every output.checkpoint_interval (without: every minute), and when it is interrupted");
}

}  // namespace footfall
