#include "mbd_solver/cli/launch/own_folder.h"

#include <algorithm>
#include <filesystem>
#include <regex>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// What every run makes, whatever becomes of it: noted at its start.
const std::vector<std::string> kEvery = {"history.csv",  "summary.json",      "ledger.csv", "bodies.pvd",
                                         "liggghts.log", "grains_energy.txt", "run.json",   "paraview.py"};
// What a run may write besides.
constexpr const char* kSome[] = {R"(bodies_[0-9].*\.vtu)",  R"(.*\.vtk\.series)",
                                 R"(.*_[0-9].*\.vtp)",      R"(.*\.pvd)",
                                 R"(motion/.*\.(csv|stl))", R"(plots/.*\.(gp|csv|png|svg))",
                                 R"(plots/gnuplot\.log)",   R"(script/.*)"};

bool is_written_by_runs(const std::string& name) {
  if (std::find(kEvery.begin(), kEvery.end(), name) != kEvery.end()) return true;
  return std::any_of(std::begin(kSome), std::end(kSome),
                     [&](const char* pattern) { return std::regex_match(name, std::regex(pattern)); });
}

// A start that was refused or stopped before the mechanism moved has logs at most: nothing of it is missed.
bool has_results(const std::string& folder) {
  std::error_code error;
  return fs::exists(fs::path(folder) / "history.csv", error) || fs::exists(fs::path(folder) / "checkpoint", error);
}

void refuse(const std::string& folder, bool force) {
  if (!has_results(folder)) return;
  const std::vector<std::string> made = made_files(folder);
  const auto count = std::count_if(made.begin(), made.end(), [&](const std::string& name) {
    std::error_code error;
    return fs::exists(fs::symlink_status(fs::path(folder) / name, error));
  });
  if (count > 0 && !force)
    throw InputError(
        folder + ": holds an earlier run (" + std::to_string(count) + (count == 1 ? " file" : " files") +
        "); choose another folder with --out, or say --force: then the files of that run are removed first");
}

// Written over, a file of the user would be lost.
void refuse_foreign(const std::string& folder, const std::set<std::string>& foreign) {
  for (const std::string& name : foreign)
    if (is_written_by_runs(name))
      throw InputError(
          (fs::path(folder) / name).string() +
          ": is there, no run is known to have made it, and this run would write over it; move it away, or "
          "choose another folder with --out");
}

}  // namespace

OwnFolder::OwnFolder(const std::string& folder, bool force) {
  // A folder that is refused stays as it is; one with a lock may be in use, which is the better reason.
  if (std::error_code error; !fs::exists(fs::path(folder) / kLockFile, error)) refuse(folder, force);
  lock_ = lock_folder(folder);
  refuse(folder, force);
  files_ = std::make_unique<MadeFiles>(folder);
  refuse_foreign(folder, files_->foreign());
  remove_made_files(folder);
  begin();
}

OwnFolder::OwnFolder(const std::string& folder) {
  if (std::error_code error; !fs::is_directory(folder, error))
    throw InputError(folder + ": there is no such folder, and so no run to go on with");
  lock_ = lock_folder(folder);
  files_ = std::make_unique<MadeFiles>(folder);
  begin();
}

void OwnFolder::begin() {
  std::vector<std::string> patterns(std::begin(kSome), std::end(kSome));
  patterns.emplace_back("checkpoint/.*");
  files_->begin(kEvery, patterns);
}

std::string new_run_folder(const std::string& name) {
  make_folder("runs");
  fs::path folder = fs::path("runs") / name;
  std::error_code error;
  // Who makes it has it: two runs that start together take two folders.
  for (int k = 2; !fs::create_directory(folder, error) && !error; ++k)
    folder = fs::path("runs") / (name + "-" + std::to_string(k));
  if (error) throw InputError(folder.string() + ": cannot be made: " + error.message() + "; choose one with --out");
  return folder.string();
}

}  // namespace footfall
