#pragma once
// When a run whose scene asks for no checkpoints is kept all the same: by the clock on the wall.

#include <algorithm>

#include "coupler/base/clock.h"

namespace footfall {

class SafetyClock {
 public:
  // interval [s] on the wall; 0: never. rest: a set is followed by at least so many times of its own duration without
  // one.
  SafetyClock(double interval, double rest) : interval_(interval), rest_(rest), next_(wall_clock() + interval) {}

  bool runs() const { return interval_ > 0.0; }
  bool overdue() const { return runs() && wall_clock() >= next_; }
  void begin() { begun_ = wall_clock(); }  // a set is being written
  void finish() {                          // it is written
    const double now = wall_clock();
    next_ = now + std::max(interval_, rest_ * (now - begun_));
  }
  // It could not be written now.
  void try_again() { next_ = wall_clock() + std::min(interval_, 0.1); }

 private:
  double interval_;     // [s]
  double rest_;         // [-]
  double next_;         // on the clock [s]
  double begun_ = 0.0;  // on the clock [s]
};

}  // namespace footfall
