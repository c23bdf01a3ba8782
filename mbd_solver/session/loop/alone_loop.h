#pragma once
// A run without grains, from sample to sample. A window ends only where an input changes: rows and
// samples are read on the way. While every sample changes an input, windows end at samples, so that
// no step is cut.

#include <algorithm>
#include <cmath>

#include "mbd_solver/session/loop/advance.h"
#include "mbd_solver/session/loop/run_loop.h"

namespace footfall {

// The middles of steps without grains, where a peak may exceed the values at the ends: a rate that comes
// near its largest so far is beyond both of its ends, by more than kBeyond of it.
class StepMiddles {
 public:
  bool are_peaks(StepView& step) {
    step.at(step.end(), state_, end_);
    step.at(0.5 * (step.begin() + step.end()), state_, rates_);
    if (largest_.size() == 0) largest_ = Eigen::VectorXd::Zero(end_.size());
    largest_ = largest_.cwiseMax(end_.cwiseAbs()).cwiseMax(rates_.cwiseAbs());
    const bool known = time_ == step.begin();
    bool peaks = !known;
    const double round_off = kRoundOff * largest_.maxCoeff();
    for (Eigen::Index i = 0; i < rates_.size() && !peaks; ++i) {
      const double low = std::min(begin_[i], end_[i]), high = std::max(begin_[i], end_[i]);
      peaks = std::max(rates_[i] - high, low - rates_[i]) > kBeyond * largest_[i] + round_off &&
              std::abs(rates_[i]) > kNear * largest_[i];
    }
    begin_.swap(end_);
    time_ = step.end();
    return peaks;
  }
  const State& state() const { return state_; }  // in the middle of the last step
  const Eigen::VectorXd& rates() const { return rates_; }

 private:
  static constexpr double kBeyond = 1e-3, kNear = 0.5;  // [-]
  static constexpr double kRoundOff = 1e-10;            // of the largest rate of all [-]

  State state_;
  Eigen::VectorXd rates_, begin_, end_, largest_;
  double time_ = -1.0;  // of the last end [s]
};

// Detects windows so short that the run would never end: the time does not change at all, or too little.
class WindowWatch {
 public:
  static constexpr long kWatched = 20000;       // windows
  static constexpr double kMostWindows = 1e12;  // that may remain at the present rate
  explicit WindowWatch(double time) : since_(time) {}
  // At the begin of each window of a run to t_end [s].
  bool is_stuck(double time, double t_end) {
    if (++windows_ < kWatched) return false;
    windows_ = 0;
    moved_ = time - since_;
    since_ = time;
    return t_end - time > kMostWindows / kWatched * moved_;
  }
  double moved() const { return moved_; }  // over the windows that were watched last [s]

 private:
  double since_, moved_ = 0.0;  // [s]
  long windows_ = 0;
};

// Where a run pauses.
enum class Reached {
  kSample,      // the present sample is to be observed; what is instructed now acts from here on
  kCheckpoint,  // one has been written; the state of the run may be saved
  kEnd          // of the scene, or because of an interruption
};

class AloneLoop : private RunLoop {
 public:
  AloneLoop(RunParts& run, const volatile std::sig_atomic_t& interrupted);
  // To the next sample, checkpoint or the end. Throws NumericalError.
  Reached next();

 private:
  enum class Phase { kStart, kStarted, kBetweenWindows, kBeforeWindow, kInWindow, kAtRow, kEnded };
  bool saves_checkpoint();                                          // between two windows
  void begin_window();                                              // with what is instructed
  double window_end();                                              // [s]
  bool continue_window();                                           // true: its end is to be observed, or a row in it
  bool end_window();                                                // true: its end is to be observed
  bool read_row(const State& state, const Eigen::VectorXd& rates);  // false: it ends the window
  void read_step(StepView& step);
  void leave_row();
  void heed_end();            // the run is over at the next row, if that is instructed
  bool apply_instructions();  // false: there were none
  void cross_jump();          // from the last time before a jump of a given function to the first time after it
  void save_here(bool undisturbed);
  [[noreturn]] void give_up_short_windows();

  Phase phase_ = Phase::kStart;
  Advance advance_;
  std::function<double(double)> next_row_;
  double end_ = 0.0;       // of the window [s]
  double last_row_ = 0.0;  // [s]
  bool stops_ = false;     // interrupted, before this window
  bool given_ = false;     // at the last stop of a leading program: windows end as where samples change inputs
  WindowWatch watch_{0.0};
  StepMiddles middles_;
};

}  // namespace footfall
