#pragma once
// Was a bed poured of the material that the run has? The texts of the two scripts may hide it: in variables that LIGGGHTS
// computes, in files that it finds. Its logs hold every command as it was executed.

#include <map>
#include <string>
#include <utility>

namespace footfall {

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
