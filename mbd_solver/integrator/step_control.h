#pragma once
// Step control of windows: the choice between two methods, and the detection of windows that would take too many steps.

#include <algorithm>
#include <string>
#include <utility>

#include "coupler/base/text.h"

namespace footfall {

// Which of two methods is used in a step. Steps end with windows: if one step of few stages fills a window, more stages are
// wasted; if it takes several, a step of a higher order with more stages is cheaper. Where a stiff force turns within the step each
// stage amplifies the errors that Newton left in earlier stages, by a_ij / gamma: few stages are then more accurate, and cheaper.
class MethodChoice {
 public:
  bool high() const { return high_; }
  bool stiff() const { return stiff_ > 0; }

  // After a step: whether a stiff force turned in it.
  void see(bool turns) { stiff_ = turns ? kHold : std::max(stiff_ - 1, 0); }

  // At the start of a window [s] with a planned step h [s] of the current method: the first step.
  double begin(double window, double h) {
    const bool known = std::exchange(begun_, true);  // else h is an estimate
    if (!high_ && h < kFills * window) {
      high_ = true;
      return known ? std::min(window, kLonger * h) : h;
    }
    if (high_ && h > kEasily * window) high_ = false;
    return h;
  }

 private:
  static constexpr double kFills = 1.0 - 1e-9;
  static constexpr double kLonger = 1.8;  // approximate ratio of the steps of both orders
  static constexpr double kEasily =
      2.5;  // windows that a step of the higher order fills before the lower order is used again
  static constexpr int kHold = 50;  // steps without them until the higher order is used again
  bool high_ = false, begun_ = false;
  int stiff_ = 0;  // steps left
};

// Detects a window that would take more than kMostSteps steps: masses that differ by many orders of magnitude, or a jammed
// mechanism. Measured over kWatched steps, so that short difficult moments pass.
class ProgressWatch {
 public:
  ProgressWatch(double t, double t_end) : t_end_(t_end), since_(t) {}
  // After each step; empty, or the problem.
  std::string check(double t) {
    if (++steps_ < kWatched) return {};
    const double moved = t - since_;
    since_ = t;
    steps_ = 0;
    if (t_end_ - t < kMostSteps / kWatched * moved) return {};
    return std::to_string(kWatched) + " steps advanced the time by only " + number_text(moved, 3) + " s, and " +
           number_text(t_end_ - t, 3) +
           " s remain. Check for masses or inertias that differ by more than a factor of 1e6 between neighbours, and "
           "for a "
           "position in which the mechanism jams. ";
  }

 private:
  static constexpr int kWatched = 2000;
  static constexpr double kMostSteps = 1e8;
  double t_end_, since_;  // [s]
  int steps_ = 0;
};

}  // namespace footfall
