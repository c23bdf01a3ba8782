#include "mbd_solver/base/made_files.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/lock.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr const char* kHead =
    "# Files that footfall has made in this folder. Another run into it (--force) removes these and no others.\n";
// Lines of a run that has not ended; each begins with a mark and a blank.
constexpr const char* kUnderWay =
    "# A run is under way, or was killed: what came to the folder while it lived is its own, too. =: its start,\n"
    "# *: tells how long it lived, -: was there before it, +: may have come last.\n";
constexpr const char *kBegun = "#=", *kLived = "#*", *kBefore = "#-", *kLast = "#+";
constexpr std::int64_t kLate = 60'000'000'000;  // ns

struct MadeList {
  std::vector<std::string> names;
  // Of a run that has not ended, else empty; its start in ns of the clock.
  std::vector<std::string> begun, lived, before, patterns;

  std::vector<std::string>* marked(const std::string& line) {
    const std::string mark = line.substr(0, 2);
    return mark == kBegun    ? &begun
           : mark == kLived  ? &lived
           : mark == kBefore ? &before
           : mark == kLast   ? &patterns
                             : nullptr;
  }
};

// Every file below the folder, as paths from it. What cannot be looked into is left out.
std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> files;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && it != end; it.increment(error)) {
    std::error_code gone;
    if (it->is_directory(gone) && !it->is_symlink(gone)) continue;
    const std::string name = it->path().lexically_relative(folder).generic_string();
    if (name == kLockFile || name == kMadeList || name.find('\n') != std::string::npos) continue;
    files.insert(name);
  }
  return files;
}

// A list may come from somebody else: only what lies in the folder itself, by name and by links, is ours.
bool stays_inside(const fs::path& folder, const std::string& name) {
  const fs::path path(name);
  if (name.empty() || path.is_absolute() || path.lexically_normal() != path) return false;
  if (std::find(path.begin(), path.end(), "..") != path.end()) return false;
  std::error_code error;
  const fs::path home = fs::canonical(folder, error), parent = fs::weakly_canonical(folder / path.parent_path(), error);
  return !error && std::mismatch(home.begin(), home.end(), parent.begin(), parent.end()).first == home.end();
}

MadeList read_list(const std::string& folder) {
  MadeList list;
  std::istringstream lines(read_whole_file((fs::path(folder) / kMadeList).string()).value_or(""));
  for (std::string line; std::getline(lines, line);) {
    if (std::vector<std::string>* marked = list.marked(line); marked && line.size() > 3)
      marked->push_back(line.substr(3));
    else if (!line.empty() && line[0] != '#' && stays_inside(folder, line))
      list.names.push_back(line);
  }
  return list;
}

// A list may be damaged: what is no expression fits nothing.
std::vector<std::regex> expressions(const std::vector<std::string>& patterns) {
  std::vector<std::regex> all;
  for (const std::string& pattern : patterns) {
    try {
      all.emplace_back(pattern);
    } catch (const std::regex_error&) {
    }
  }
  return all;
}

void add_lines(const char* mark, const std::vector<std::string>& names, std::string& text) {
  for (const std::string& name : names) text += std::string(mark) + " " + name + "\n";
}

void write_list(const std::string& folder, const std::set<std::string>& names, const MadeList& run) {
  std::string text = kHead;
  if (!run.begun.empty()) {
    text += kUnderWay;
    add_lines(kBegun, run.begun, text);
    add_lines(kLived, run.lived, text);
    add_lines(kBefore, run.before, text);
    add_lines(kLast, run.patterns, text);
  }
  for (const std::string& name : names) text += name + "\n";
  write_whole_file((fs::path(folder) / kMadeList).string(), text);
}

}  // namespace

std::vector<std::string> made_files(const std::string& folder) {
  MadeList list = read_list(folder);
  if (list.begun.empty()) return list.names;
  std::int64_t end = std::strtoll(list.begun.front().c_str(), nullptr, 10);
  for (const std::string& name : list.lived) end = std::max(end, file_changed((fs::path(folder) / name).string()));
  const std::vector<std::regex> patterns = expressions(list.patterns);
  const auto fits_one = [&](const std::string& name) {
    return std::any_of(patterns.begin(), patterns.end(),
                       [&](const std::regex& pattern) { return std::regex_match(name, pattern); });
  };
  std::set<std::string> names(list.names.begin(), list.names.end());
  for (const std::string& name : files_in(folder)) {
    if (std::find(list.before.begin(), list.before.end(), name) != list.before.end()) continue;
    const std::int64_t after = file_changed((fs::path(folder) / name).string()) - end;
    if (after <= 0 || (after <= kLate && fits_one(name))) names.insert(name);
  }
  return {names.begin(), names.end()};
}

void remove_made_files(const std::string& folder, const std::string& start) {
  std::set<fs::path> parents;
  for (const std::string& name : made_files(folder)) {
    if (name.compare(0, start.size(), start) != 0) continue;
    const fs::path path = fs::path(folder) / name;
    std::error_code error;
    if (fs::is_directory(fs::symlink_status(path, error))) continue;
    error.clear();
    fs::remove(path, error);
    if (error) throw InputError(code::kFileNotRemoved, path.string() + ": cannot be removed: " + error.message());
    for (fs::path parent = fs::path(name).parent_path(); !parent.empty(); parent = parent.parent_path())
      parents.insert(parent);
  }
  std::error_code not_empty;
  for (auto parent = parents.rbegin(); parent != parents.rend(); ++parent)  // the deepest first
    fs::remove(fs::path(folder) / *parent, not_empty);
  if (start.empty()) fs::remove(fs::path(folder) / kMadeList, not_empty);
}

MadeFiles::MadeFiles(const std::string& folder) : folder_(folder), before_(files_in(folder)) {
  for (const std::string& name : made_files(folder)) before_.erase(name);
}

MadeFiles::~MadeFiles() {
  try {
    note();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "footfall: warning: %s\n", error.what());
  }
}

void MadeFiles::begin(const std::vector<std::string>& names, const std::vector<std::string>& patterns) {
  runs_ = true;
  MadeList run;
  run.begun = {std::to_string(std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count())};
  run.patterns = patterns;
  run.before.assign(before_.begin(), before_.end());
  std::set<std::string> made = files_in(folder_);
  for (const std::string& name : before_) made.erase(name);
  for (const std::string& name : names) {
    if (is_foreign(name)) continue;
    made.insert(name);
    run.lived.push_back(name);
  }
  write_list(folder_, made, run);
}

void MadeFiles::note() const {
  std::set<std::string> made = files_in(folder_);
  for (const std::string& name : before_) made.erase(name);
  // Another command looks at a run that goes on, or was killed: the run stays what it is.
  const MadeList run = runs_ ? MadeList{} : read_list(folder_);
  if (!run.begun.empty()) made.insert(run.names.begin(), run.names.end());
  if (!made.empty()) write_list(folder_, made, run);
}

}  // namespace footfall
