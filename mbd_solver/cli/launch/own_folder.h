#pragma once
// The folder that one run writes into: held while the run lives, and what it makes there is noted, so that a later run
// with --force removes that and nothing of the user's.

#include <memory>
#include <string>

#include "coupler/base/folder_lock.h"
#include "coupler/base/made_files.h"

namespace footfall {

class OwnFolder {
 public:
  // Refuses a folder that another run holds; one that holds an earlier run, unless `force`, which removes the files of
  // that run (those of a start that never came to a first row go without a word); one where files of the user have names
  // that the run would write. Throws InputError.
  OwnFolder(const std::string& folder, bool force);
  // The folder of a run that goes on: nothing is removed. Refuses a folder that another run holds. Throws InputError.
  explicit OwnFolder(const std::string& folder);

 private:
  void begin();  // a kill from here on leaves a list, too

  FileLock lock_;
  std::unique_ptr<MadeFiles> files_;
};

// runs/NAME, runs/NAME-2, ...: the first that is free; it is there then.
std::string new_run_folder(const std::string& name);

}  // namespace footfall
