#pragma once
// The bed of grains: a LIGGGHTS script settles it once, the cache stores it, and later runs find it by what it was made
// from. Sizes and checksums of its files are stored with it: LIGGGHTS reads a damaged restart file without end.

#include <map>
#include <string>
#include <utility>

#include "mbd_solver/scene/scene.h"

namespace footfall {

// Files of a bed in its folder.
inline constexpr const char* kBedRestart = "bed.restart";
inline constexpr const char* kBedGrains = "bed.restart.grains";  // text dump x y z radius; some scripts write none
inline constexpr const char* kBedCost = "bed_cost.json";         // cpu_s: processor time that it took to make [s]

struct Bed {
  std::string restart;  // LIGGGHTS restart file
  std::string grains;   // text dump x y z radius; empty when the script writes none
};

// Finds the bed in the cache, or makes it there with `ranks` LIGGGHTS processes (with a progress line unless quiet).
// Throws InputError with LIGGGHTS' own message when the script fails, PartnerError when LIGGGHTS dies or is suspended,
// Interrupted when a signal asks for the end. trusted: the script may run programs and write anywhere. limit [s]: how long
// LIGGGHTS may make no step.
Bed prepare_bed(const BedSpec& spec, int ranks, bool quiet, bool trusted = false, double limit = 300.0);

// The folder of the bed, whether it exists or not: named by bed_key.
std::string bed_folder(const BedSpec& spec);
// Throws InputError for a bed that is a link or belongs to another user (except root).
void require_own_bed(const std::string& folder);
// True when the folder holds an undamaged bed. Throws as require_own_bed.
bool bed_is_made(const std::string& folder);

// $FOOTFALL_CACHE, else $XDG_CACHE_HOME/footfall, else ~/.cache/footfall.
std::string cache_folder();
// Fingerprint of the script with all files it includes, all variables, and the version of LIGGGHTS.
std::string bed_key(const BedSpec& spec, const std::string& liggghts_version);

// Stores sizes and checksums of the bed's files next to them, in bed.seal. Throws InputError when it cannot be written.
void seal_bed(const std::string& folder);
// What is wrong with the bed in this folder; empty when its files are those that were sealed.
std::string damage_of_bed(const std::string& folder);

// Was the bed made of the material that the run has? Variables that LIGGGHTS computes and files that it finds may hide
// it in the scripts; the logs hold every command as it was executed.

// By property: the words after the last `fix ID all property/global PROPERTY`, of youngsModulus and poissonsRatio, as
// LIGGGHTS executed them. Empty for a log that cannot be read.
std::map<std::string, std::string> elastic_constants(const std::string& log);
// "youngsModulus: the bed was made with ..., the run has ..."; empty when both agree in the constants that both have.
std::string different_material(const std::string& bed_log, const std::string& run_log);

// A tick of run_child: warns once on standard error if the materials differ, as soon as the run is set up.
class BedMaterialCheck {
 public:
  // bed_log empty: there is nothing to compare.
  BedMaterialCheck(std::string bed_log, std::string run_log)
      : bed_log_(std::move(bed_log)), run_log_(std::move(run_log)) {}
  void operator()();

 private:
  std::string bed_log_, run_log_;
};

}  // namespace footfall
