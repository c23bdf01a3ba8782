#pragma once
// What finished runs of a calibration said, in one small file: a line of JSON for each run of a scene. Whoever has this
// file needs neither the runs' folders nor the hours: a run that stands in it is not done again, here or on another
// machine. An entry holds as long as the run would be made from the same (portable_recipe_of in
// experiments/run_store.h) and is asked the same.

#include <map>
#include <string>
#include <utility>

#include "mbd_solver/cli/calibrate/misfit.h"

namespace footfall {

class RunLedger {
 public:
  struct Entry {
    std::string run;  // name of its folder
    RunNumbers numbers;
    double wall = 0.0, cpu = 0.0;  // [s]
  };

  // Reads `file`, if it is there. Empty: nothing is read and nothing written. Throws InputError naming the line that
  // is no entry; the last one, when it is cut short, is left out.
  RunLedger(const CalibrationSpec& spec, std::string file);

  // Null when it is not there, or does not hold all that is asked.
  const Entry* find(const std::string& scene, const std::string& recipe) const;
  void note(const std::string& scene, const std::string& recipe, const Entry& entry);
  void write();  // when something is new

 private:
  std::string asked_of(const std::string& scene) const;  // a fingerprint

  const CalibrationSpec& spec_;
  std::string file_;
  std::map<std::pair<std::string, std::string>, Entry> entries_;  // by scene and recipe
  std::map<std::string, std::string> asked_;                      // by scene
  std::string other_lines_;                                       // of other questions: kept as they are
  bool changed_ = false;
};

}  // namespace footfall
