#pragma once
// Turns that come once per interval: rows, pictures, checkpoints.

#include <cmath>
#include <limits>

#include "coupler/archive.h"

namespace footfall {

class IntervalClock {
 public:
  // interval [s]; 0: never. first: time of the first turn [s].
  IntervalClock(double interval, double first)
      : interval_(interval), next_(interval > 0.0 ? first : std::numeric_limits<double>::infinity()) {}

  double next() const { return next_; }  // [s]
  bool is_due(double time) const { return time >= next_ - 1e-9 * interval_; }
  // True at the first call at or after each multiple of the interval; moves on.
  bool take_turn(double time) {
    if (!is_due(time)) return false;
    next_ = (std::floor(time / interval_ + 1e-9) + 1.0) * interval_;
    return true;
  }

  void visit(Archive& archive) { archive("next", next_); }

 private:
  double interval_;  // [s]
  double next_;      // [s]
};

}  // namespace footfall
