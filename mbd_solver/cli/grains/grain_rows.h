#pragma once
// grains_energy.txt of a run that is resumed: LIGGGHTS begins the file anew, so the rows before the checkpoint are set
// aside and joined with the new ones afterwards.

#include <string>

namespace footfall {

// LIGGGHTS' step number at a checkpoint. Throws InputError when its part of it is not there.
long step_of_checkpoint(const std::string& checkpoint);

// Rows up to `step` go to grains_energy.before.txt; those that an earlier resumed part has left there are joined first.
void set_rows_aside(const std::string& run, long step);
// The energy of gravity that the rows count from, as the script has left it in grains_energy_start.txt; empty when it has
// not.
std::string energy_at_start(const std::string& run);
// One file again: the rows set aside, then those of later steps.
void join_rows(const std::string& run);

}  // namespace footfall
