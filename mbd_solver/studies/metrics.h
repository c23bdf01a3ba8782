#pragma once
// One number out of a run: of its summary, a reduction of its history, or the slope of its bed.
//
//   [[figures]]
//     name
//     key                    a number of summary.json; or
//     columns                of history.csv, with
//       reduce                 what is taken of each column: see Reduction (default: max)
//       average                true: the mean over the columns; else the largest of them, of "min" the least, of
//                              "final" the last
//       prominence             of "peaks" (default: 0.3)
//     slope                  [low, high]: angle of the bed's surface along x between these heights, of the last dump
//                            of the grains [deg] (analysis/bed_slope.h)
//     over                   a key of summary.json that the figure is divided by
//     error, until           see errors.h

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mbd_solver/run/output/history.h"
#include "mbd_solver/scene/source.h"

namespace footfall {

enum class Reduction { kMax, kMin, kFinal, kLargest, kDrop, kPeaks, kVariation, kSteady };

constexpr std::string_view name_of(Reduction reduction) {
  switch (reduction) {
    case Reduction::kMax: return "max";
    case Reduction::kMin: return "min";
    case Reduction::kFinal: return "final";
    case Reduction::kLargest: return "largest";      // of the absolute values
    case Reduction::kDrop: return "drop";            // first value minus the least
    case Reduction::kPeaks: return "peaks";          // maxima that stand out by `prominence` times the largest value
    case Reduction::kVariation: return "variation";  // sum of |x_i+1 - x_i|, how much a curve goes up and down
    case Reduction::kSteady: return "steady";        // mean of the last 40 % of the rows, as rigs take it
  }
  return "";
}

// Against the reference.
enum class ErrorKind { kRelative, kRms, kFinal, kItself };

constexpr std::string_view name_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kRelative:
      return "relative";  // difference of the figures, of the reference's figure
    // Root mean square of the columns' difference over the run, of the reference's swing; no number of one run.
    case ErrorKind::kRms: return "rms";
    case ErrorKind::kFinal: return "final";    // likewise at the last row
    case ErrorKind::kItself: return "itself";  // the figure is an error, and needs no reference
  }
  return "";
}

struct FigureSpec {
  std::string name;
  std::string key;                   // of summary.json; else
  std::vector<std::string> columns;  // of history.csv; else
  std::vector<double> slope;         // heights of the bed's surface, low and high [m]
  Reduction reduction = Reduction::kMax;
  bool average = false;
  double prominence = 0.3;
  std::string over;  // empty: none
  ErrorKind error = ErrorKind::kRelative;
  double until = 0.0;  // kRms, kFinal: rows up to this time [s]; 0: all
  Source source;

  // The whole curve is compared: there is no number of one run.
  bool compares_curves() const { return error == ErrorKind::kRms || error == ErrorKind::kFinal; }
};

struct History;
class FieldVisitor;
void visit_fields(FieldVisitor& v, FigureSpec& figure);  // its keys
// What is wrong with where its number comes from, as "key" and a text; both empty: nothing.
struct FigureFault {
  std::string key, text;
};
FigureFault fault_of(const FigureSpec& figure);

// Of the finished run in `folder`; NaN when its history is empty, or for figures that compare curves. Throws
// InputError, beginning with `file`, when the run has no such figure.
std::vector<double> figures_of_run(const std::vector<FigureSpec>& figures, const std::string& folder,
                                   const std::string& file);

// Throws InputError, beginning with `file` and `who`, for a column that the history of the finished run in `folder` does
// not have.
void demand_columns(const std::vector<std::string>& columns, const History& history, const std::string& folder,
                    const std::string& file, const std::string& who);

// Number of maxima whose prominence (height over the higher of the two lowest points that part it from higher ground,
// or from the ends) is at least `least`. A plateau counts once.
int count_peaks(const std::vector<double>& values, double least);

// Errors of one run against another, as [[figures]] asks for them, and observed orders.
//
//   error                    against the reference: "relative" (default), "rms", "final" or "itself" (ErrorKind)
//   until                    of "rms" and "final": rows up to this time [s]

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
