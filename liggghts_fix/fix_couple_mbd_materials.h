#pragma once
// What a LIGGGHTS script says about the contact of its grains with a wall.

#include <vector>

#include "liggghts_fix/wall_contact.h"

namespace LAMMPS_NS {

class Modify;

// By grain type, from 1, against walls of this type; empty where the script gives no elastic constants. `style` of the
// fix that asks, for LIGGGHTS' own messages.
std::vector<footfall::WallContact> wall_contacts(Modify& modify, int types, int wall_type, const char* style);

}  // namespace LAMMPS_NS
