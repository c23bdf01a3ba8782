#pragma once
// Turns that come once per interval: rows, pictures, checkpoints.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "coupler/archive.h"
#include "coupler/base/clock.h"
#include "mbd_solver/scene/scene.h"

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

// When a run whose scene asks for no checkpoints is kept all the same: by the clock on the wall.

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

// A run kept so that it can be gone on with: RUN/checkpoint/N/ (checkpoint_folder.h), where
//   start.json   how the run was started, and its scene with all defaults (run_start.h)
//   run.txt      the memory of the mechanism's side (archive.h)
// and the grains' side adds its own: grains.restart of LIGGGHTS, and grains.txt.

// until [s], ranks: as in RunStart. visit: describes the memory.
void write_checkpoint(const std::string& folder, const Scene& scene, double until, int ranks,
                      const std::function<void(Archive&)>& visit);
// Throws InputError when `scene` is not the one of the checkpoint, naming the first value that differs, and when the
// memory does not fit.
void restore_checkpoint(const std::string& folder, const Scene& scene, const std::function<void(Archive&)>& visit);

}  // namespace footfall
