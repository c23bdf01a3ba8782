#pragma once
// Metrics: one number of a run, from its summary, a reduction of its history, or the slope of its bed; their errors against
// a reference, over an ensemble; and observed orders. [[figures]] of sweep and calibration files.

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

enum class Reduction {
  kMax,
  kMin,
  kFinal,
  kLargest,    // of the absolute values
  kDrop,       // first value minus the least
  kLoss,       // first value minus the last, over the first
  kPeaks,      // maxima with a prominence of `prominence` times the largest value
  kVariation,  // sum of |x_i+1 - x_i|
  kSteady      // mean of the last 40 % of the rows, as in rigs
};
constexpr std::string_view name_of(Reduction reduction) {
  return name_in(reduction, "max", "min", "final", "largest", "drop", "loss", "peaks", "variation", "steady");
}

// Against the reference.
enum class ErrorKind {
  kRelative,  // difference of the metrics over the reference's metric
  kRms,       // of whole curves: history_error
  kFinal,     // likewise at the last row
  kItself     // the metric is an error, and needs no reference
};
constexpr std::string_view name_of(ErrorKind kind) { return name_in(kind, "relative", "rms", "final", "itself"); }

struct MetricSpec {
  std::string name;
  std::string key;                   // of summary.json; else
  std::vector<std::string> columns;  // of history.csv; else
  std::vector<double> slope;         // heights of the bed's surface, low and high [m]
  Reduction reduction = Reduction::kMax;
  bool average = false;     // the mean over the columns; otherwise the largest (kMin: the least, kFinal: the last)
  double prominence = 0.3;  // of kPeaks
  std::string requirement;  // name of one of the scene's [[requirements]], whose value it is; NaN: not computed
  std::string over;         // key of summary.json that the metric is divided by; empty: none
  ErrorKind error = ErrorKind::kRelative;
  double until = 0.0;  // kRms, kFinal: rows up to this time [s]; 0: all
  Source source;

  // Whole curves are compared: one run has no number.
  bool compares_curves() const { return error == ErrorKind::kRms || error == ErrorKind::kFinal; }
};

class FieldVisitor;
void visit_fields(FieldVisitor& v, MetricSpec& metric);  // its keys
// All on which its number depends, without its unit and limits of errors.
std::string metric_recipe(const MetricSpec& metric);

// The metrics of the finished run in `folder`; NaN when its history is empty, or for metrics that compare curves.
// Throws InputError, beginning with `file`, when the run lacks a number or column.
std::vector<double> metrics_of_run(const std::vector<MetricSpec>& metrics, const std::string& folder,
                                   const std::string& file);

// Throws InputError, beginning with `file` and `who`, for a column that the history lacks.
void require_columns(const std::vector<std::string>& columns, const History& history, const std::string& folder,
                     const std::string& file, const std::string& who);

// Number of maxima with a prominence of at least `least`: height over the higher of the two lowest points between the
// maximum and higher values, or the ends. A plateau counts once.
int count_peaks(const std::vector<double>& values, double least);

// Root mean square over columns and rows of the difference to the reference (interpolated linearly), over the reference's
// range (largest minus smallest value) [-]. at_end: only at the last row. until: rows up to this time [s]; 0: all.
double history_error(const History& run, const History& reference, const std::vector<std::string>& columns, bool at_end,
                     double until = 0.0);

// Errors of the metrics that compare curves, of the run in `folder` against the run in `reference` [-]; NaN for others.
std::vector<double> curve_errors(const std::vector<MetricSpec>& metrics, const std::string& folder,
                                 const std::string& reference);

// A metric over the members of an ensemble, and its error; NaN: none.
struct SampledMetric {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double mean = kNone;            // of the metric, in its unit
  double spread = kNone;          // standard deviation over the members, in its unit; 0 for one
  double error = kNone;           // against the reference [-]
  double standard_error = kNone;  // of the error [-]
};
// Only mean and spread.
SampledMetric sampled_metric(const std::vector<double>& metrics);
// With error = |mean - mean_ref| / |mean_ref| and the standard error of the difference member by member,
// deviation / sqrt(members) / |mean_ref|.
SampledMetric sampled_metric(const std::vector<double>& metrics, const std::vector<double>& reference);

// Slope of y over x by least squares; 0 for fewer than two different x.
double slope(const std::vector<std::pair<double, double>>& points);
// Slope of log error over log x, of the points with positive values.
double observed_order(const std::vector<std::pair<double, double>>& points);

}  // namespace footfall
