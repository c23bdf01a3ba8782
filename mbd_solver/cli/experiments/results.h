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

  bool is_of(int curve) const { return plan.curve == curve && !plan.is_reference; }
  // Run time that the scheme and the mechanism answer for: everything but the grains' own steps [s].
  double own_time() const { return cost.mbd + cost.exchange; }
};

struct Results {
  std::vector<RunResult> runs;    // as Plan::runs
  std::vector<CaseResult> cases;  // as Plan::cases
  std::size_t members = 1;        // of the ensemble

  bool all_done() const;
  bool grains() const;  // in any case but references
};

// Throws NumericalError when a reference was not done.
Results results_of(const ExperimentSpec& spec, const Plan& plan, const RunStore& store);
// The cases of known runs, without errors.
std::vector<CaseResult> cases_of(const ExperimentSpec& spec, const Plan& plan, const std::vector<RunResult>& runs);

// The cases within the limits, best first; empty when nothing is minimised.
std::vector<std::size_t> ranking(const ExperimentSpec& spec, const std::vector<CaseResult>& cases);

// Observed order of one figure of the curve; 0: it has none.
double order_of(const std::vector<CaseResult>& cases, int curve, std::size_t figure);

struct Outcome {
  double value = SampledFigure::kNone, reference = SampledFigure::kNone;  // of the case; of the one it is compared with
  double judged = SampledFigure::kNone;                                   // what the bounds are of; NaN: not run
  bool came_out = false;
};
// As ExperimentSpec::statements.
std::vector<Outcome> outcomes_of(const ExperimentSpec& spec, const std::vector<CaseResult>& cases);

}  // namespace footfall
