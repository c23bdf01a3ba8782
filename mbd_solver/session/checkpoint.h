#pragma once
// When to write output and checkpoints (IntervalClock, SafetyClock), and the files of a checkpoint.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "coupler/archive.h"
#include "coupler/base/clock.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Simulated time: one turn per interval, for rows, pictures and checkpoints.
class IntervalClock {
 public:
  // interval [s]; 0: no turns. first: time of the first turn [s].
  IntervalClock(double interval, double first)
      : interval_(interval), next_(interval > 0.0 ? first : std::numeric_limits<double>::infinity()) {}

  double next() const { return next_; }  // [s]
  bool is_due(double time) const { return time >= next_ - 1e-9 * interval_; }
  // True at the first call at or after each multiple of the interval.
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

// Wall-clock time: checkpoints of a run whose scene sets no checkpoint_interval.
class SafetyClock {
 public:
  // interval [s]; 0: no checkpoints. rest: the next checkpoint comes at least this many times the duration of the last
  // one later.
  SafetyClock(double interval, double rest) : interval_(interval), rest_(rest), next_(wall_clock() + interval) {}

  bool active() const { return interval_ > 0.0; }
  bool overdue() const { return active() && wall_clock() >= next_; }
  void begin() { begun_ = wall_clock(); }  // a checkpoint is being written
  void finish() {                          // it is complete
    const double now = wall_clock();
    next_ = now + std::max(interval_, rest_ * (now - begun_));
  }
  // The checkpoint could not be written now.
  void retry_soon() { next_ = wall_clock() + std::min(interval_, 0.1); }

 private:
  double interval_;     // [s]
  double rest_;         // [-]
  double next_;         // wall clock [s]
  double begun_ = 0.0;  // wall clock [s]
};

// The files of a checkpoint, RUN/checkpoint/N/ (checkpoint_folder.h):
//   start.json   how the run was started, and its scene with all defaults (summary.h)
//   run.txt      the state of the multibody side (archive.h)
// and of the DEM side grains.restart (LIGGGHTS) and grains.txt.

// until [s], ranks: as in RunStart. visit: describes the state.
void write_checkpoint(const std::string& folder, const Scene& scene, double until, int ranks,
                      const std::function<void(Archive&)>& visit);
// Throws InputError when `scene` differs from the checkpoint's, naming the first difference, and when the state
// does not fit.
void restore_checkpoint(const std::string& folder, const Scene& scene, const std::function<void(Archive&)>& visit);

}  // namespace footfall
