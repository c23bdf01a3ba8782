#pragma once
// One run of a study: `footfall run` as a child with a time limit, and what it left behind.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/output/history.h"

namespace footfall {

struct StudyRun {
  static constexpr int kHung = 124;  // the exit code when the time limit struck
  std::string folder;                // of its results
  int code = 0;                      // exit code of the run
  std::string message;               // its last line of error, empty when it was done
  std::vector<std::string> warnings;
  nlohmann::ordered_json summary;                           // null when there is none
  History history;                                          // empty when there is none
  double wall = 0.0, dem = 0.0, mbd = 0.0, exchange = 0.0;  // [s]
  double cpu = 0.0;   // of all its programs, which other jobs of the machine hardly change [s]
  double gain = 0.0;  // largest energy that came from nowhere, of the reference energy [-]
};

struct StudyRunRequest {
  std::string scene, out;
  std::vector<std::string> settings;
  double until = 0.0;
  int time_limit = 600;  // [s]
  int repeats = 1;       // the shortest of the run times counts
  bool resume = false;   // a run that was done with the same recipe (run_record.h) is taken as it is
};

// The same for two requests when the second need not be run (run_record.h); empty when the scene cannot be read.
std::string recipe_of(const StudyRunRequest& request);

// Throws InputError only when the program itself cannot be started.
StudyRun run_once(const StudyRunRequest& request);

}  // namespace footfall
