#pragma once
// The tables of an experiment.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/results.h"

namespace footfall {

// runs.csv: one row per run. cases.csv: one row per case; cases.md the same as a table for a page, with the command
// that makes it.
void write_run_table(const std::string& path, const ExperimentSpec& spec, const Plan& plan, const Results& results);
void write_case_table(const std::string& path, const ExperimentSpec& spec, const std::vector<CaseResult>& cases);
void write_case_page(const std::string& path, const ExperimentSpec& spec, const std::vector<CaseResult>& cases);
// statements.csv and statements.md in `folder`; nothing without statements.
void write_statements(const std::string& folder, const ExperimentSpec& spec, const std::vector<Outcome>& outcomes);

}  // namespace footfall
