#pragma once
// What the runs of an experiment say: the figures of every run; mean, spread and error of every case; whether the
// statements came out.

#include <string>
#include <vector>

#include "mbd_solver/studies/metrics.h"
#include "mbd_solver/studies/plan.h"
#include "mbd_solver/studies/run_store.h"

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

// What the errors of an experiment recommend: the cheapest value of each curve that keeps all errors within a limit,
// and whose error is the largest.

constexpr std::size_t kNoFigure = static_cast<std::size_t>(-1);

struct Advice {
  // The first case, in the file's order from coarse to fine, from which on all errors are within the limit: one that
  // is within while a finer one is not was lucky. Where none is, the one with the smallest largest error; null: none
  // was done. Points into the results.
  const CaseResult* point = nullptr;
  bool within = false;
  // Where none is with all figures, but one is without this one, the worst of the best value.
  std::size_t apart = kNoFigure;
  std::size_t worst = kNoFigure;  // the figure with the largest error, but for that one
  bool resolved = true;           // the standard errors of all figures but that one are within the limit
  // Processor time over that of the curve's default, or of its reference; 0: neither is known.
  double time_ratio = 0.0;

  const SampledFigure& largest() const { return point->figures[worst]; }
};

// One per curve.
std::vector<Advice> advice_of(const ExperimentSpec& spec, const Results& results, double limit);

// The largest error of each curve with a default, at that default, the largest first.
std::vector<Advice> errors_of_defaults(const ExperimentSpec& spec, const Results& results);

// How the runs of an experiment ended, against how they must: cases that are stiff, extreme or unstable.
//
//   [[curves]]
//     ends                     one for all values, or one per value:
//       "accurate"             done, error within the tolerance (without a reference: no warning), no energy gained
//       "warned"                 done, energy bounded, but the error is larger, and a warning said so
//       "stopped"                ended by itself with a message (exit code 1)
//       "refused"                not started (exit code 2)
//     group                    heading in the table
//     columns, at_end          of history.csv, compared with the reference: over the run, or where it comes to rest
//     tolerance                of that error, of the reference's swing (default: 0.02)
//     message                  regular expression that warnings or the last message must match
//     order_beyond             from this value on errors grow at most in proportion to the value

struct Verdict {
  std::string group, name, value, expected, found;  // found: accurate, warned, stopped, refused, or what is wrong
  std::string note;                                 // error, gain, message
  double error = 0.0;                               // against its reference [-]; 0 without one, or when it was not done
  bool as_expected = false;
};

// One per case, but for references. Throws NumericalError when a reference was not done.
std::vector<Verdict> verdicts_of(const ExperimentSpec& spec, const Results& results);
// The table as Markdown.
std::string verdict_page(const ExperimentSpec& spec, const std::vector<Verdict>& verdicts);

}  // namespace footfall
