#pragma once
// The plan of a sweep: its cases, the runs of each, and the case with which it is compared.

#include <string>
#include <vector>

#include "mbd_solver/studies/sweep_file.h"

namespace footfall {

struct RunRequest {
  std::string name;  // of its folder
  std::string scene;
  std::vector<std::string> settings;
  double until = 0.0;               // [s]; 0: the scene's end time
  int time_limit = 0;               // [s]; 0: none
  int repeats = 1;                  // the shortest run time counts
  bool trusted = false;             // --trust-script
  bool may_be_refused = false;      // a scene that cannot be read is no fault of the sweep
  std::vector<std::string> values;  // names of its choices, one per parameter
};

// One value of a curve, or one combination of parameters, over the ensemble.
struct PlannedCase {
  std::string name;
  int curve = -1;      // of SweepSpec::curves; -1: none, or the reference of all
  std::string value;   // of the curve; "reference" of a reference
  double x = 0.0;      // scale * value; 0 when the value is no number
  int reference = -1;  // the case with which this one is compared, member by member of the ensemble; -1: none
  bool is_reference = false;
  std::vector<std::size_t> runs;  // one per member of the ensemble
};

struct Plan {
  std::vector<RunRequest> runs;    // in the order of their numbers
  std::vector<PlannedCase> cases;  // references before the cases compared with them
  std::size_t members = 1;         // of the ensemble
};

// short_form: of --short. Throws InputError for too many runs, or runs with the same name.
Plan plan_of(const SweepSpec& spec, bool short_form);

}  // namespace footfall
