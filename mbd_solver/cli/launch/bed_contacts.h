#pragma once
// How the grains of a bed touch each other, from their places alone.

#include <vector>

#include "mbd_solver/build/grain_dump.h"

namespace footfall {

struct BedContacts {
  // Contacts of a grain with others (two clumps may have several), on the average over those in the middle half of the depth, three radii and more from
  // the outermost grains along x and y; 0 where there are none.
  double coordination = 0.0;
  double largest_overlap = 0.0;  // of two grains, of the smaller radius [-]
};

// Cost grows with the number of grains. Contacts across a period are not seen.
BedContacts bed_contacts(const std::vector<GrainPlace>& grains);

}  // namespace footfall
