#pragma once
// Results of a sweep: metrics of every run; mean, spread and error of every case; checks; recommended values; and the rows of
// a stability map.

#include <string>
#include <vector>

#include "mbd_solver/studies/metrics.h"
#include "mbd_solver/studies/plan.h"
#include "mbd_solver/studies/run_store.h"

namespace footfall {

struct RunResult {
  RunEnd end;
  std::vector<double> metrics;  // as SweepSpec::metrics; NaN: none
};

struct CaseResult {
  PlannedCase plan;
  int code = 0;                   // largest exit code of its runs
  std::string message;            // of the run that failed
  std::vector<std::size_t> done;  // numbers of its runs that are done
  RunCost cost;                   // mean [s]
  double steps = 0.0, windows = 0.0;
  std::vector<SampledMetric> metrics;  // as SweepSpec::metrics; errors if all runs are done
  bool within_limits = false;          // of the sweep file; never without a run that is done

  bool is_of(int curve) const { return plan.curve == curve && !plan.is_reference; }
  // Run time of the scheme and the mechanism, without DEM steps [s].
  double own_time() const { return cost.mbd + cost.exchange; }
};

struct Results {
  std::vector<RunResult> runs;    // as Plan::runs
  std::vector<CaseResult> cases;  // as Plan::cases
  std::size_t members = 1;        // of the ensemble

  bool all_done() const;
  bool grains() const;  // in any case, without references
};

// Throws NumericalError when a reference has failed.
Results results_of(const SweepSpec& spec, const Plan& plan, const RunStore& store);
// The cases of known runs, without errors.
std::vector<CaseResult> cases_of(const SweepSpec& spec, const Plan& plan, const std::vector<RunResult>& runs);

// The cases within the limits, best first; empty without `minimise`.
std::vector<std::size_t> ranking(const SweepSpec& spec, const std::vector<CaseResult>& cases);

// Observed order of one metric of the curve; 0: none.
double order_of(const std::vector<CaseResult>& cases, int curve, std::size_t metric);

struct CheckResult {
  double value = SampledMetric::kNone, reference = SampledMetric::kNone;  // of the case, of CheckSpec::against
  double judged = SampledMetric::kNone;                                   // value, or ratio; NaN: not run
  bool reproduced = false;
};
// As SweepSpec::checks.
std::vector<CheckResult> check_results_of(const SweepSpec& spec, const std::vector<CaseResult>& cases);

// The cheapest value of a curve that keeps all errors within a limit.
constexpr std::size_t kNoMetric = static_cast<std::size_t>(-1);

struct Recommendation {
  // The first case, in the file's order from coarse to fine, from which on all errors are within the limit. If there is
  // none, the case with the smallest largest error; null: no case is done. Points into the results.
  const CaseResult* point = nullptr;
  bool within = false;
  // If there is a case only without one metric, the one with the largest error at the best value: that metric.
  std::size_t excepted = kNoMetric;
  std::size_t worst = kNoMetric;  // the metric with the largest error, without that one
  bool resolved = true;           // standard errors are within the limit
  // Processor time relative to the curve's default, otherwise to its reference; 0: unknown.
  double time_ratio = 0.0;

  const SampledMetric& largest() const { return point->metrics[worst]; }
};

// One per curve.
std::vector<Recommendation> recommendations_of(const SweepSpec& spec, const Results& results, double limit);

// The errors of each curve with a default, at the default, the largest error first.
std::vector<Recommendation> errors_of_defaults(const SweepSpec& spec, const Results& results);

// A run of a stability map, stiff, extreme or unstable, and how it ended:
//   accurate   done, error within the tolerance (without a reference: no warning), no energy created
//   warned     done, energy bounded, but the error is larger, and a warning reported it
//   stopped    ended by itself with a message (exit code 1)
//   refused    not started (exit code 2)
struct MapRow {
  std::string group, name, value;
  std::string end;     // as above, or the fault: wrong without a warning, without end, or without a message
  std::string result;  // error, created energy, message
  bool fault = false;
};

// One per case, without references. Throws NumericalError when a reference has failed.
std::vector<MapRow> map_rows(const SweepSpec& spec, const Results& results);
// The table as Markdown.
std::string map_page(const SweepSpec& spec, const std::vector<MapRow>& rows);

}  // namespace footfall
