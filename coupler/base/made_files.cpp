#include "coupler/base/made_files.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/folder_lock.h"
#include "coupler/base/whole_file.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr const char* kHead =
    "# Files that footfall has made in this folder. Another run into it (--force) removes these and no others.\n";

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

}  // namespace

std::vector<std::string> made_files(const std::string& folder) {
  std::vector<std::string> names;
  std::istringstream lines(read_whole_file((fs::path(folder) / kMadeList).string()).value_or(""));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line[0] != '#' && stays_inside(folder, line)) names.push_back(line);
  return names;
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
    if (error) throw InputError(path.string() + ": cannot be removed: " + error.message());
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
    note({});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "footfall: warning: %s\n", error.what());
  }
}

void MadeFiles::note(const std::vector<std::string>& names) const {
  std::set<std::string> made = files_in(folder_);
  for (const std::string& name : before_) made.erase(name);
  for (const std::string& name : names)
    if (!is_foreign(name)) made.insert(name);
  if (made.empty()) return;
  std::string text = kHead;
  for (const std::string& name : made) text += name + "\n";
  write_whole_file((fs::path(folder_) / kMadeList).string(), text);
}

}  // namespace footfall
