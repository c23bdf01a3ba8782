#pragma once
// Tells when a window would take so many steps that it does not end within a lifetime: masses that differ by many orders
// of magnitude, a mechanism that jams. Watched over kWatched steps, so that a short hard moment passes.

#include <string>

#include "coupler/base/text.h"

namespace footfall {

class ProgressWatch {
 public:
  ProgressWatch(double t, double t_end) : t_end_(t_end), since_(t) {}
  // After each step. Empty, or what is wrong.
  std::string complaint(double t) {
    if (++steps_ < kWatched) return {};
    const double moved = t - since_;
    since_ = t;
    steps_ = 0;
    if (t_end_ - t < kMostSteps / kWatched * moved) return {};
    return std::to_string(kWatched) + " steps moved on by " + number_text(moved, 3) + " s only, and " +
           number_text(t_end_ - t, 3) +
           " s are left. Look for masses or inertias that differ by more than a factor of 1e6 between neighbours and "
           "for a "
           "position in which the mechanism jams; ";
  }

 private:
  static constexpr int kWatched = 2000;
  static constexpr double kMostSteps = 1e8;
  double t_end_, since_;  // [s]
  int steps_ = 0;
};

}  // namespace footfall
