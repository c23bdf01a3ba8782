#pragma once
// The runs, cases and statements of an experiment as tables.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/results.h"
#include "mbd_solver/cli/experiments/table.h"

namespace footfall {

Table run_table(const ExperimentSpec& spec, const Plan& plan, const Results& results);
Table case_table(const ExperimentSpec& spec, const std::vector<CaseResult>& cases);
// The same for people, with printed figures and the command that makes it.
std::string case_page(const ExperimentSpec& spec, const std::vector<CaseResult>& cases);

Table statement_table(const ExperimentSpec& spec, const std::vector<Outcome>& outcomes);
// The same for people, with why something did not come out.
std::string statement_page(const ExperimentSpec& spec, const std::vector<Outcome>& outcomes);

}  // namespace footfall
