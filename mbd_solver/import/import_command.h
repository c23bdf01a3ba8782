#pragma once
// footfall import: a scene of a robot's file.

#include <string>

#include "mbd_solver/import/robot.h"

namespace footfall {

struct ImportArguments {
  std::string file;
  std::string out;      // empty: the name of the file, in the current folder
  bool strict = false;  // whatever is not taken is an error
  bool quiet = false;   // parts that are not converted are listed in the scene only
  ImportOptions options;
};

// Writes the folder `out` with scene.toml and meshes, or nothing. Returns an exit code; throws InputError.
int import_command(const ImportArguments& arguments);

}  // namespace footfall
