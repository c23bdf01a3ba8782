#pragma once
// Everything that an experiment writes when its runs are done.

#include <string>

#include "mbd_solver/cli/experiments/results.h"

namespace footfall {

struct OutputPlace {
  std::string folder, name;  // of the files
  std::string table;         // also write the table for a page to this file; empty: no
  std::string command;       // that makes it
  bool short_form = false;   // without fits, which need all runs
};

// Prints and writes it into the folder. True when all that the file expects came out; of [[parameters]], when every run
// is done as well.
bool write_output(const ExperimentSpec& spec, const Plan& plan, const Results& results, const OutputPlace& place);

// What the figures and plots of the file take from a run, of a finished one in `folder`. Throws InputError for what it
// does not have: told when the first run is done, not after the last.
void demand_results(const ExperimentSpec& spec, const std::string& folder);

}  // namespace footfall
