#pragma once
// The bed of grains: settled once by a LIGGGHTS script, kept, and found again by what it was made from.

#include <string>

#include "coupler/interrupt.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

struct Bed {
  std::string restart;  // LIGGGHTS restart file
  std::string grains;   // text dump x y z radius; empty when the script writes none
};

// Finds the bed in the cache, or makes it there with `ranks` LIGGGHTS processes (a progress line unless quiet). The key
// holds the text of the script and of what it includes, all variables, and the version of LIGGGHTS; a bed that is there
// is complete.
// Throws InputError with LIGGGHTS' own message when the script fails, PartnerError when LIGGGHTS dies or is stopped,
// Interrupted when the end was asked for.
Bed prepare_bed(const BedSpec& spec, int ranks, bool quiet);

// Where the bed is, or will be; whether it is there.
std::string bed_folder(const BedSpec& spec);
bool bed_is_made(const std::string& folder);

// $FOOTFALL_CACHE, else $XDG_CACHE_HOME/footfall, else ~/.cache/footfall.
std::string cache_folder();
std::string bed_key(const BedSpec& spec, const std::string& liggghts_version);

}  // namespace footfall
