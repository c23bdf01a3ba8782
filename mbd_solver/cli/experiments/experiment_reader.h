#pragma once
// Reads the file of an experiment (experiment.h has its keys).

#include <string>

#include "mbd_solver/cli/experiments/experiment.h"

namespace footfall {

// Throws InputError "file:line: key: what is wrong, what was expected".
ExperimentSpec read_experiment(const std::string& file);

// JSON schema (draft 2020-12) of these files, made by the functions that read them: keys, types, choices. What has {}
// for a type takes a value of more than one kind; experiment.h tells of it.
std::string experiment_schema();

}  // namespace footfall
