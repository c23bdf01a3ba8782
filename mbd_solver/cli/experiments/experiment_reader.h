#pragma once
// Reads the file of an experiment (experiment.h has its keys).

#include <string>

#include "mbd_solver/cli/experiments/experiment.h"

namespace footfall {

// Throws InputError "file:line: key: what is wrong, what was expected".
ExperimentSpec read_experiment(const std::string& file);

}  // namespace footfall
