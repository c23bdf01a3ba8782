#pragma once
// The bed of grains: settled once by a LIGGGHTS script, kept, and found again by what it was made from.

#include <map>
#include <string>
#include <utility>

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

// Whether a kept bed is whole: LIGGGHTS that reads a damaged restart file waits or counts for ever, without a word.

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

// Was a bed poured of the material that the run has? The texts of the two scripts may hide it: in variables that LIGGGHTS
// computes, in files that it finds. Its logs hold every command as it was executed.

// By property: the words behind the last `fix ID all property/global PROPERTY`, of youngsModulus and poissonsRatio, as
// LIGGGHTS took them. Lines that were not yet filled in, or that the script commented out, do not count. An unreadable
// log has none.
std::map<std::string, std::string> elastic_constants(const std::string& log);

// What to tell the user, empty when they agree where both have them: "youngsModulus: the bed ..., the run ...".
std::string different_material(const std::string& bed_log, const std::string& run_log);

// A tick of run_child: tells it once on standard error, when the log of the run says that it is set up.
class BedWatch {
 public:
  // bed_log empty: there is nothing to compare.
  BedWatch(std::string bed_log, std::string run_log) : bed_log_(std::move(bed_log)), run_log_(std::move(run_log)) {}
  void operator()();

 private:
  std::string bed_log_, run_log_;
};

}  // namespace footfall
