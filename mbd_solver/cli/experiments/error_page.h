#pragma once
// Errors of the curves of an experiment: as CSV, and as a page; with an ensemble the page also says what it recommends.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/results.h"
#include "mbd_solver/cli/experiments/table.h"

namespace footfall {

// The rows of the tables: with an ensemble those of the references first. They point into the results.
std::vector<const CaseResult*> points_of(const Results& results);

// With an ensemble, every row has mean, spread and standard error (see SampledFigure) of every figure.
Table error_table(const ExperimentSpec& spec, const Results& results);

// `command`: the one that makes the page, told with an ensemble.
std::string error_page(const ExperimentSpec& spec, const Results& results, const std::string& command);

// The section "Recommended settings" for 1 and 5 %.
std::string recommendations(const ExperimentSpec& spec, const Results& results);

}  // namespace footfall
