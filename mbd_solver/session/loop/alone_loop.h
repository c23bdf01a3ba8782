#pragma once
// A run without grains, from sample to sample. A window ends only where an input changes: rows and
// samples are read on the way. While every sample changes an input, windows end at samples, so that
// no step is cut.

#include "mbd_solver/session/event_watch.h"
#include "mbd_solver/session/loop/advance.h"
#include "mbd_solver/session/loop/run_loop.h"
#include "mbd_solver/session/loop/step_middles.h"

namespace footfall {

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
