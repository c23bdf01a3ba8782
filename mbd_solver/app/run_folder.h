#pragma once
// The folder that one run writes to: locked while the run lives. A folder with run.json is a run; --force replaces it.

#include <string>
#include <vector>

#include "mbd_solver/base/lock.h"

namespace footfall {

class RunFolder {
 public:
  // A new run. Refuses a folder that another run holds; one with the results of an earlier run, unless `force`; and one
  // without run.json that has files with names that a run writes. Removes the files of the earlier run. Throws InputError.
  RunFolder(const std::string& folder, bool force);
  // A resumed run: nothing is removed. Refuses a folder that another run holds. Throws InputError.
  explicit RunFolder(const std::string& folder);

 private:
  FileLock lock_;
};

// The files in the folder that runs and the commands on them write, by their names; the user's files have others.
std::vector<std::string> files_of_run(const std::string& folder);

// "FOLDER: " and why it cannot be read: a run that has not ended, or what was expected.
std::string without_summary(const std::string& folder, const std::string& expected);

// Creates runs/NAME, runs/NAME-2, ...: the first that is free. Throws InputError.
std::string new_run_folder(const std::string& name);

}  // namespace footfall
