#pragma once
// The files of the DEM side in a checkpoint. All functions are collective; a file that cannot be written is a FileError on
// every rank.

#include <string>

namespace LAMMPS_NS {

class LAMMPS;

// The restart file also holds the forces and moments on the grains ("held forces"). LIGGGHTS evaluates forces anew in the
// set-up of a run, but not as in a step: sliding contacts count as sticking, because their history does not advance, and
// are damped by their full damping for half a step (kinetic energy of an impact: -2 % at a step of 10 % of Rayleigh's
// time). Forces on clumps remain those that LIGGGHTS evaluates.

// Writes the restart file by LIGGGHTS' command `write_restart`, which first moves grains to their ranks and changes their
// order.
void write_grains(LAMMPS* lmp, std::string file);

// Writes the same without any change in LIGGGHTS. False, without a file: a grain has left the box since the last
// re-neighbouring, and LIGGGHTS could not place it when it reads the file.
bool write_grains_undisturbed(LAMMPS* lmp, std::string file);

// In a resumed run, after its grains were read: creates the fix whose values come from the restart file.
void create_held_forces(LAMMPS* lmp);
// At the end of a set-up: grains with held forces get them back. Without any it does nothing.
void return_held_forces(LAMMPS* lmp);

void write_text(LAMMPS* lmp, const std::string& file, const std::string& text);  // by one rank

}  // namespace LAMMPS_NS
