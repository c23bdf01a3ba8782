#pragma once
// grains_energy.txt of a run that is resumed: LIGGGHTS begins the file anew, so the rows before the checkpoint are set
// aside and joined with the new ones afterwards.

#include <string>

namespace footfall {

// What LIGGGHTS' part of a checkpoint says of itself.
struct GrainsKept {
  long step = 0;  // LIGGGHTS' step number there
};
// Throws InputError when the file is not there.
GrainsKept read_grains_kept(const std::string& checkpoint);

// Rows up to `step` go to grains_energy.before.txt; those that an earlier resumed part has left there are joined first.
// Returns the energy of gravity that the rows count from, as the file's first line states it; empty when it does not.
std::string set_rows_aside(const std::string& run, long step);
// One file again: the rows set aside, then those of later steps.
void join_rows(const std::string& run);

}  // namespace footfall
