// Which files in a folder belong to a run is decided by their names alone: those that the programs and commands write, and
// the numbered files that scripts dump.
#include "mbd_solver/app/run_folder.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/run/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr const char* kOfRun =
    R"((history|peaks|ledger)\.csv|(run|summary)\.json|liggghts.*\.log|grains_energy.*\.txt|failed|audit\.txt|paraview\.py)"
    R"(|.*\.pvd|.*\.vtk\.series|.*_[0-9]+\.(vtk|vtu|vtp|txt|stl)(\.part)?|(view|report|watch)\.html)"
    R"(|(pictures|plots)/[^/]*\.(dat|gp|png|rgb|svg)|(audit|checkpoint|compare|motion|script)/.*)";

bool has_results(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / "history.csv", error) || fs::exists(folder / "checkpoint", error);
}

bool is_run(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / kRunNote, error);
}

void require_replaceable(const std::string& folder, bool force) {
  if (is_run(folder)) {
    if (has_results(folder) && !force)
      throw InputError(code::kFolderHasRun, folder +
                                                ": holds an earlier run; choose another folder with --out, or add "
                                                "--force to replace that run");
    return;
  }
  if (const std::vector<std::string> files = files_of_run(folder); !files.empty())
    throw InputError(code::kFileInTheWay, (fs::path(folder) / files.front()).string() +
                                              ": the run would overwrite this file, and the folder holds no run "
                                              "(no run.json); move the file, or choose another folder with --out");
}

void remove_files(const std::string& folder) {
  std::set<fs::path> parents;
  for (const std::string& name : files_of_run(folder)) {
    std::error_code error;
    fs::remove(fs::path(folder) / name, error);
    if (error)
      throw InputError(code::kFileNotRemoved,
                       (fs::path(folder) / name).string() + ": cannot be removed: " + error.message());
    for (fs::path parent = fs::path(name).parent_path(); !parent.empty(); parent = parent.parent_path())
      parents.insert(parent);
  }
  std::error_code not_empty;
  for (auto parent = parents.rbegin(); parent != parents.rend(); ++parent)  // the deepest first
    fs::remove(fs::path(folder) / *parent, not_empty);
}

}  // namespace

std::vector<std::string> files_of_run(const std::string& folder) {
  static const std::regex of_run(kOfRun);
  std::vector<std::string> names;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && it != end; it.increment(error)) {
    std::error_code gone;
    if (it->is_directory(gone) && !it->is_symlink(gone)) continue;
    const std::string name = it->path().lexically_relative(folder).generic_string();
    if (std::regex_match(name, of_run)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

RunFolder::RunFolder(const std::string& folder, bool force) {
  // A folder that is refused stays as it is; a folder in use is the better reason.
  if (std::error_code error; !fs::exists(fs::path(folder) / kLockFile, error)) require_replaceable(folder, force);
  lock_ = lock_folder(folder);
  require_replaceable(folder, force);
  remove_files(folder);
}

RunFolder::RunFolder(const std::string& folder) {
  if (std::error_code error; !fs::is_directory(folder, error))
    throw InputError(code::kNoRun, folder + ": no such folder, and so no run to resume");
  lock_ = lock_folder(folder);
}

std::string new_run_folder(const std::string& name) {
  make_folder("runs");
  fs::path folder = fs::path("runs") / name;
  std::error_code error;
  // Creating it takes it: two runs that start together take two folders.
  for (int k = 2; !fs::create_directory(folder, error) && !error; ++k)
    folder = fs::path("runs") / (name + "-" + std::to_string(k));
  if (error)
    throw InputError(code::kFileInTheWay, folder.string() + ": cannot be created: " + error.message() +
                                              "; choose another folder with --out");
  return folder.string();
}

}  // namespace footfall
