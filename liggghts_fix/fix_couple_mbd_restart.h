#pragma once
// The files that the grains' side writes into a checkpoint. All ranks call these together; what cannot be written is a
// FileError on each of them.

#include <string>

namespace LAMMPS_NS {

class LAMMPS;

// LIGGGHTS' command `write_restart`: brings the grains into their boxes and into a new order before.
void keep_grains(LAMMPS* lmp, std::string file);

// Writes what LIGGGHTS holds, as it stands, and changes nothing. False, and no file: a grain has left the box since the
// last re-neighbouring, and LIGGGHTS would not find it a place when it reads the file.
bool keep_grains_quietly(LAMMPS* lmp, std::string file);

void keep_text(LAMMPS* lmp, const std::string& file, const std::string& text);  // by one rank

}  // namespace LAMMPS_NS
