#pragma once
// What an experiment runs: its cases, the runs of each, and the run that each of them is compared with.

#include <string>
#include <vector>

#include "mbd_solver/studies/experiment.h"

namespace footfall {

struct RunRequest {
  std::string name;  // of its folder
  std::string scene;
  std::vector<std::string> settings;
  double until = 0.0;               // [s]; 0: the scene's end time
  int time_limit = 0;               // [s]; 0: none
  int repeats = 1;                  // the shortest of the run times counts
  bool may_be_refused = false;      // a scene that cannot be read is no mistake of the experiment
  std::vector<std::string> values;  // names of its choices, one per parameter
};

// One value of a curve, or one combination of parameters, over the ensemble.
struct PlannedCase {
  std::string name;
  int curve = -1;      // of ExperimentSpec::curves; -1: none, or the reference of all
  std::string value;   // of the curve; "reference" of a reference
  double x = 0.0;      // scale * value; 0 when the value is no number
  int reference = -1;  // the case that this one is compared with, member by member of the ensemble; -1: none
  bool is_reference = false;
  std::vector<std::size_t> runs;  // one per member of the ensemble
};

struct Plan {
  std::vector<RunRequest> runs;    // in the order of their numbers
  std::vector<PlannedCase> cases;  // references before those that are compared with them
  std::size_t members = 1;         // of the ensemble
};

// The whole form, or that of --short. Throws InputError when two runs have the same name.
Plan plan_of(const ExperimentSpec& spec, bool short_form);

}  // namespace footfall
