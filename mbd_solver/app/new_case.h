#pragma once
// footfall new: a folder with a scene to edit, copied from an example or an input that comes with the program; or made of a robot.

#include <string>
#include <vector>

namespace footfall {

struct CaseKind {
  std::string name;    // for --from
  std::string title;   // of its scene
  std::string folder;  // under inputs/ or examples/
};

// Values of --from: every example, without the number before its name, and some scenes of inputs/. Throws InputError when
// the files of the program are missing.
std::vector<CaseKind> case_kinds();

// Creates `folder` with that scene, the scripts, meshes and tables that it reads, and a README; the copy needs no other
// file. Throws InputError for an existing folder, a name that LIGGGHTS cannot read, or an unknown kind.
void make_case(const std::string& folder, const std::string& from);

// A file of a robot (URDF, SDF, MJCF) by its ending, in place of an example.
bool is_robot_file(const std::string& from);

// Carries out `footfall WORDS` by footfall_import, in the place of this process. Throws InputError where that program has not
// been built; returns an exit code where it cannot be started.
int start_import(const std::vector<std::string>& words);

}  // namespace footfall
