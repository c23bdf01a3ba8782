#pragma once
// footfall new: a folder of one's own with a scene that runs, copied from what comes with the program, to be edited.

#include <string>
#include <vector>

namespace footfall {

struct CaseKind {
  std::string name;    // of --from
  std::string title;   // of its scene
  std::string folder;  // under inputs/ or examples/
};

// What --from knows: every example without the number before its name, and the scenes of inputs that have a name here.
// Throws InputError when the program's files are not there.
std::vector<CaseKind> case_kinds();

// Makes `folder` with the scene of that kind, the scripts, meshes and tables that it reads, and a README; the copy needs
// no other file. Throws InputError for a folder that is there, a name that LIGGGHTS could not read, an unknown kind.
void make_case(const std::string& folder, const std::string& from);

}  // namespace footfall
