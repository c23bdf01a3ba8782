#pragma once
// Errors of one run against another, and observed orders.

#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/cli/experiments/study.h"
#include "mbd_solver/cli/experiments/study_run.h"

namespace footfall {

// Root mean square over the columns of the difference to the reference (straight between its rows) over the run's rows,
// or at the run's last row only; rows up to the time `until` [s], 0: all; of the reference's own swing (largest minus
// smallest value) [-].
double history_error(const History& run, const History& reference, const std::vector<std::string>& columns, bool at_end,
                     double until = 0.0);

// What the measure says [-]. Throws InputError for unknown columns and keys.
double error_of(const MeasureSpec& measure, const StudyRun& run, const StudyRun& reference);

// Of a measure of the kind "figure". Throws InputError for unknown columns and keys.
double figure_of(const MeasureSpec& measure, const StudyRun& run);

// A figure over the members of an ensemble, and the same members with the reference's settings.
struct SampledFigure {
  double mean = 0.0;    // of the figure, in its unit
  double spread = 0.0;  // standard deviation over the members, likewise
  double error = 0.0;   // |mean - mean of the reference|, of the latter [-]
  // of that difference, member by member: deviation / sqrt(members), of the reference's mean [-]
  double standard_error = 0.0;
};
SampledFigure sampled_figure(const std::vector<double>& figures, const std::vector<double>& reference);

// Slope of log error over log x by least squares; 0 for fewer than two points with positive values.
double observed_order(const std::vector<std::pair<double, double>>& points);

}  // namespace footfall
