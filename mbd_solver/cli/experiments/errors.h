#pragma once
// Errors of one run against another, as [[figures]] asks for them, and observed orders.
//
//   error                    against the reference: "relative" (default), "rms", "final" or "itself" (ErrorKind)
//   until                    of "rms" and "final": rows up to this time [s]

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/cli/experiments/figures.h"
#include "mbd_solver/output/history.h"

namespace footfall {

// Root mean square over the columns of the difference to the reference (straight between its rows) over the run's rows,
// or at the run's last row only; rows up to the time `until` [s], 0: all; of the reference's own swing (largest minus
// smallest value) [-].
double history_error(const History& run, const History& reference, const std::vector<std::string>& columns, bool at_end,
                     double until = 0.0);

// Of every figure that compares curves, of the run in one folder against that in the other [-]; NaN for the other
// figures. Throws InputError for unknown columns.
std::vector<double> curve_errors(const std::vector<FigureSpec>& figures, const std::string& folder,
                                 const std::string& reference);

// A figure over the members of an ensemble, and its error; NaN: there is none.
struct SampledFigure {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double mean = kNone;            // of the figure, in its unit
  double spread = kNone;          // standard deviation over the members, likewise; 0 for one
  double error = kNone;           // against the reference [-]
  double standard_error = kNone;  // what the samples leave open of the error [-]
};
// Mean and spread alone.
SampledFigure sampled_figure(const std::vector<double>& figures);
// With error = |mean - mean of the reference| of the latter, and the standard error of that difference member by
// member: deviation / sqrt(members), of the reference's mean. One reference per figure.
SampledFigure sampled_figure(const std::vector<double>& figures, const std::vector<double>& reference);

// Slope of y over x by least squares; 0 for fewer than two different x.
double slope(const std::vector<std::pair<double, double>>& points);
// Slope of log error over log x, of the points with positive values.
double observed_order(const std::vector<std::pair<double, double>>& points);

}  // namespace footfall
