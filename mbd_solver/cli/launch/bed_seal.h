#pragma once
// Whether a kept bed is whole: LIGGGHTS that reads a damaged restart file waits or counts for ever, without a word.

#include <string>

namespace footfall {

inline constexpr const char* kBedRestart = "bed.restart";
inline constexpr const char* kBedCost = "bed_cost.json";         // cpu_s: processor time that it took to make
inline constexpr const char* kBedGrains = "bed.restart.grains";  // text dump x y z radius; some scripts write none

// Keeps sizes and checksums of the bed's files beside them, in bed.seal. Throws InputError when it cannot be written.
void seal_bed(const std::string& folder);

// What is wrong with the bed in this folder; empty when it is what was sealed. One without a seal, as earlier versions
// kept them, is looked at from outside (damage_of_restart, damage_of_dump).
std::string damage_of_bed(const std::string& folder);

// What can be told of a restart file by its shape: LIGGGHTS' header, and behind everything else the grains of each
// process with their counts, all of them, at finite places. Empty when nothing is wrong, or when the file is not one
// that is known well enough to judge (other atom styles).
std::string damage_of_restart(const std::string& path);

// Likewise of a text dump: as many lines as it says, finite numbers.
std::string damage_of_dump(const std::string& path);

}  // namespace footfall
