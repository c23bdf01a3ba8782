#pragma once
// Whether LIGGGHTS' grains are numbers at all.

#include <string>

#include "coupler/messages.h"

namespace LAMMPS_NS {

class LAMMPS;

// Radius and mass of every grain positive, place and velocity finite. Collective; throws InputError on all ranks, which
// names the grain. A grain without a radius touches nothing, in silence. `where`: beginning of the message.
void check_grains(LAMMPS* lmp, const std::string& where);

// A warning when the script or the command line says `radius` and no grain has it: the bed was poured under another one.
// Collective.
void warn_of_radius(LAMMPS* lmp, footfall::Start& script);

}  // namespace LAMMPS_NS
