#pragma once
// One number out of a run: of its summary, or a reduction of its history.

#include <string>
#include <vector>

namespace footfall {

enum class Reduction {
  kMax,
  kMin,
  // of the absolute values
  kFinal,
  kLargest,
  kDrop,       // first value minus the least
  kPeaks,      // maxima that stand out: their prominence is at least `prominence` times the largest value
  kVariation,  // sum of |x_i+1 - x_i|: how much a curve goes up and down
};

struct SweepFigure {
  std::string name;
  std::string key;                   // of summary.json; else
  std::vector<std::string> columns;  // of history.csv: the reduction of all of them
  Reduction reduction = Reduction::kMax;
  bool average = false;     // the mean of the columns' reductions, not the extreme of them
  double prominence = 0.3;  // of kPeaks
  std::string over;         // a key of summary.json that the figure is divided by; empty: none
};

// Of the finished run in `folder`; NaN when its history is empty. Throws InputError, beginning with `file`, when the
// run has no such figure.
std::vector<double> figures_of_run(const std::vector<SweepFigure>& figures, const std::string& folder,
                                   const std::string& file);

// Number of maxima whose prominence (height over the higher of the two lowest points that part it from higher ground,
// or from the ends) is at least `least`. A plateau counts once.
int count_peaks(const std::vector<double>& values, double least);

}  // namespace footfall
