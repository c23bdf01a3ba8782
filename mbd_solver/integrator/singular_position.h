#pragma once
// Singular positions of a mechanism (theory 2.4): when the next one comes, from the determinant of its saddle matrix at three
// times, and steps that pass over it. Before such a position an error d in the position causes an error of the rates of d over
// the square of the remaining time, however smooth the motion is: a step over it must be placed by its time.

#include <array>
#include <limits>

#include "mbd_solver/dynamics/saddle_system.h"
#include "mbd_solver/integrator/tableau.h"

namespace footfall {

struct Nearness {
  double time = 0.0;             // [s]
  double log_determinant = 0.0;  // of the saddle matrix, up to a constant
};

// Time of the singular position [s]; infinity if none is expected within kAhead spans after the newest. Oldest first.
double singular_time(const std::array<Nearness, 3>& seen);

// Knowledge of a one-step method about the next singular position: repeated failures start the search, and the step
// over the position is long, without a stage near it.
class SingularCrossing {
 public:
  void forget() { *this = {}; }

  // Failed steps, in a row or alternating with others, indicate a position: true after several of them.
  bool count_failure();
  void count_success();
  // Steps that follow start without drift.
  bool careful() const { return careful_ > 0; }
  void begin_careful_steps();
  void finish_careful_step() { --careful_; }
  // A step over the position has failed: the next attempt places it between other stages.
  void count_failed_crossing() { ++failed_crossings_; }
  void finish_step() { failed_crossings_ = 0; }

  // Finds the position from the saddle matrices at three states in a row. possible: else none is expected.
  void look_ahead(SaddleSystem& saddle, const State& before, const State& start, const State& now, bool possible);
  void look_again() { looked_time_ = std::numeric_limits<double>::quiet_NaN(); }
  bool in_sight(double t, double h) const;
  double time() const { return time_; }  // [s]; infinity: none
  // h, or a step without stages near the position; largest: max_step [s], 0: no limit.
  double planned_step(const Tableau& tableau, double t, double h, double largest) const;

 private:
  int failures_ = 0, careful_ = 0, failed_crossings_ = 0;
  double time_ = std::numeric_limits<double>::infinity();
  double looked_time_ = std::numeric_limits<double>::quiet_NaN();  // time of the last search; NaN: none
};

}  // namespace footfall
