#pragma once
// What the runs of an experiment say: the figures of every run; mean, spread and error of every case; whether the
// statements came out.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/errors.h"
#include "mbd_solver/cli/experiments/run_store.h"
#include "mbd_solver/cli/experiments/runs.h"

namespace footfall {

struct RunResult {
  RunEnd end;
  std::vector<double> figures;  // as ExperimentSpec::figures; NaN: not there
};

struct CaseResult {
  PlannedCase plan;
  int code = 0;                   // the largest of its runs
  std::string message;            // of the run that failed
  std::vector<std::size_t> done;  // numbers of its runs that are done
  RunCost cost;                   // mean [s]
  double steps = 0.0, windows = 0.0;
  std::vector<SampledFigure> figures;  // as ExperimentSpec::figures; errors only when all runs are done
  bool within_limits = true;
};

struct Results {
  std::vector<RunResult> runs;    // as Plan::runs
  std::vector<CaseResult> cases;  // as Plan::cases

  bool all_done() const;
};

// `numbers`: of the plan's runs in the store. Throws NumericalError when a reference was not done.
Results results_of(const ExperimentSpec& spec, const Plan& plan, const RunStore& store,
                   const std::vector<std::size_t>& numbers);
// The cases of known runs, without errors.
std::vector<CaseResult> cases_of(const ExperimentSpec& spec, const Plan& plan, const std::vector<RunResult>& runs);

// The cases within the limits, best first; empty when nothing is minimised.
std::vector<std::size_t> ranking(const ExperimentSpec& spec, const std::vector<CaseResult>& cases);

// (x, error) of one figure of the curve, where both are positive.
std::vector<std::pair<double, double>> error_line(const std::vector<CaseResult>& cases, int curve, std::size_t figure);

struct Outcome {
  double value = 0.0, reference = 0.0;  // of the case; of the one it is compared with. NaN: none
  double judged = 0.0;                  // what the bounds are of; NaN: not run
  bool came_out = false;
};
// As ExperimentSpec::statements.
std::vector<Outcome> outcomes_of(const ExperimentSpec& spec, const std::vector<CaseResult>& cases);

}  // namespace footfall
