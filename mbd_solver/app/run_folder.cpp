// Which files in a folder belong to a run is decided by their names alone: those that the programs and commands write, and
// the numbered files that scripts dump.
#include "mbd_solver/app/run_folder.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/run_directory.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/session/observe/terrain_patch.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

bool begins(const std::string& text, const std::string& start) { return text.compare(0, start.size(), start) == 0; }

// NAME_12.vtk and NAME_12.vtk.part: what scripts and programs write at a step.
bool is_numbered(std::string name) {
  if (ends_with(name, ".part")) name.erase(name.size() - 5);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return false;
  const std::string ending = name.substr(dot + 1);
  if (ending != "vtk" && ending != "vtu" && ending != "vtp" && ending != "txt" && ending != "stl") return false;
  const std::size_t digits = name.find_last_not_of("0123456789", dot - 1);
  return dot > 0 && digits != std::string::npos && digits + 1 < dot && name[digits] == '_';
}

// Folders that belong to a run with all they hold, and folders of which only pictures do.
constexpr const char* kFolders[] = {"audit", "checkpoint", "compare", "motion", "script"};
constexpr const char* kOfPictures[] = {"pictures", "plots"};

// NAME.png directly in the folder.
bool is_picture_in(const std::string& folder, const std::string& name) {
  if (!begins(name, folder + "/") || name.find('/', folder.size() + 1) != std::string::npos) return false;
  for (const char* ending : {".dat", ".gp", ".pdf", ".png", ".rgb", ".svg"})
    if (ends_with(name, ending)) return true;
  return false;
}

// Compares parts of the name only: names come from other people, and a regular expression may take for ever.
bool is_of_run(const std::string& name) {
  for (const char* file :
       {"history.csv", "peaks.csv", "ledger.csv", kTerrainFile, "end_state.json", "run.json", "summary.json", "failed",
        "audit.txt", "paraview.py", "view.html", "view_pair.html", "report.html", "difference.html", "watch.html"})
    if (name == file) return true;
  for (const char* folder : kFolders)
    if (begins(name, std::string(folder) + "/")) return true;
  for (const char* folder : kOfPictures)
    if (is_picture_in(folder, name)) return true;
  return (begins(name, "liggghts") && ends_with(name, ".log")) ||
         ((begins(name, "grains_energy") || begins(name, "walls_energy")) && ends_with(name, ".txt")) ||
         ends_with(name, ".pvd") || ends_with(name, ".vtk.series") || is_numbered(name);
}

// The name of such a folder; a link with this name is no file of the user.
bool is_folder_of_run(const std::string& name) {
  const auto is = [&](const char* folder) { return name == folder; };
  return std::any_of(std::begin(kFolders), std::end(kFolders), is) ||
         std::any_of(std::begin(kOfPictures), std::end(kOfPictures), is);
}

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
    const std::string file = (fs::path(folder) / name).string();
    if (const int problem = GuardedPath(file).remove(); problem != 0)
      throw InputError(code::kFileNotRemoved, file + ": cannot be removed: " + reason_of(problem));
    for (fs::path parent = fs::path(name).parent_path(); !parent.empty(); parent = parent.parent_path())
      parents.insert(parent);
  }
  // The deepest first; folders that hold other files stay.
  for (auto parent = parents.rbegin(); parent != parents.rend(); ++parent)
    GuardedPath((fs::path(folder) / *parent).string()).remove();
}

// What LIGGGHTS has complained of, if it has.
std::string reason_in_log(const fs::path& folder) {
  const std::string errors = liggghts_errors((folder / "liggghts.log").string());
  return errors.empty() ? "" : ". LIGGGHTS stopped: " + errors.substr(0, errors.find('\n'));
}

}  // namespace

std::vector<std::string> files_of_run(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  const bool whole = is_run(folder);
  fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && it != end; it.increment(error)) {
    std::error_code gone;
    const std::string name = it->path().lexically_relative(folder).generic_string();
    if (it->is_directory(gone) && !it->is_symlink(gone)) {
      // A run fills its own folders alone; others may be large.
      if (it.depth() == 0 && !whole && !is_folder_of_run(name)) it.disable_recursion_pending();
      continue;
    }
    if (is_of_run(name) || (it->is_symlink(gone) && is_folder_of_run(name))) names.push_back(name);
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
  // LIGGGHTS and gnuplot follow links.
  for (const std::string& name : files_of_run(folder))
    if (std::error_code none; fs::is_symlink(fs::path(folder) / name, none))
      throw InputError(code::kFileInTheWay,
                       (fs::path(folder) / name).string() + ": cannot be written: " + reason_of(ELOOP));
}

std::string without_summary(const std::string& folder, const std::string& expected) {
  const fs::path path(folder);
  if (fs::exists(path / "summary.json")) {
    const nlohmann::ordered_json summary = read_summary((path / "summary.json").string());
    if (summary.value("status", "") != "done")
      return with_summary_of(folder, [&] { return folder + ": the run has no results; it " + end_text(summary); });
  }
  if (fs::exists(path / "run.json") && !fs::exists(path / "summary.json")) {
    if (is_alive(owner_of((path / kLockFile).string())))
      return folder + ": the run has not ended and has no summary.json yet; follow it with `footfall view " + folder +
             " --follow`";
    if (!fs::exists(path / "history.csv"))
      return folder + ": the run was killed at its start and has no results; repeat it" + reason_in_log(path);
    return folder + ": the run was killed before it wrote summary.json; resume it with `footfall run --resume " +
           folder + "`, or repeat it";
  }
  return folder + ": " + expected;
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
