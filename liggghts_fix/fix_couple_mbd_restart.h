#pragma once
// The files that the grains' side writes into a checkpoint. All ranks call these together; what cannot be written is a
// FileError on each of them.

#include <string>

namespace LAMMPS_NS {

class LAMMPS;

// Both files hold the forces and moments on the grains too. LIGGGHTS evaluates them anew when a run is set up, but not
// as a step does: contacts that slide count as sticking there, because their history stands still, and brake by their
// whole damping for half a step (an impact's kinetic energy: -2 % at a step of 10 % of Rayleigh's time). Clumps keep
// what LIGGGHTS evaluates.

// LIGGGHTS' command `write_restart`: brings the grains into their boxes and into a new order before.
void keep_grains(LAMMPS* lmp, std::string file);

// Writes what LIGGGHTS holds, as it stands, and changes nothing. False, and no file: a grain has left the box since the
// last re-neighbouring, and LIGGGHTS would not find it a place when it reads the file.
bool keep_grains_quietly(LAMMPS* lmp, std::string file);

// Of a run that is resumed, when its grains have been read: the forces of the file wait until the run is set up.
void expect_held_forces(LAMMPS* lmp);
// At the end of a set-up: grains whose forces wait get them back. Without any, nothing.
void return_held_forces(LAMMPS* lmp);

void keep_text(LAMMPS* lmp, const std::string& file, const std::string& text);  // by one rank

}  // namespace LAMMPS_NS
