#pragma once
// Constants of the contact of grains with a wall, as the LIGGGHTS script gives them.

#include <vector>

#include "liggghts_fix/link/contact_slope.h"

namespace LAMMPS_NS {

class Modify;

// By grain type, from 1, against walls of this type; empty without elastic constants in the script. style: of the calling
// fix, for LIGGGHTS' own messages.
std::vector<footfall::WallContact> wall_contacts(Modify& modify, int types, int wall_type, const char* style);

}  // namespace LAMMPS_NS
