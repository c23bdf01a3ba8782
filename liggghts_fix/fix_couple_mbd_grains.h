#pragma once
// Whether LIGGGHTS' grains are numbers at all.

#include <string>

namespace LAMMPS_NS {

class LAMMPS;

// Radius and mass of every grain positive, place and velocity finite. Collective; throws InputError on all ranks, which
// names the grain. A grain without a radius touches nothing, in silence. `where`: beginning of the message.
void check_grains(LAMMPS* lmp, const std::string& where);

}  // namespace LAMMPS_NS
