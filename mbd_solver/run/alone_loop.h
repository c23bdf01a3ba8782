#pragma once
// The loop of a run without grains. A window ends only where an input changes: rows and samples are
// read on the way. While every sample changes an input, windows end at samples, so that no step is
// cut.

#include "mbd_solver/run/event_watch.h"
#include "mbd_solver/run/run_loop.h"
#include "mbd_solver/run/step_middles.h"

namespace footfall {

class AloneLoop : private RunLoop {
 public:
  using RunLoop::RunLoop;
  void run();

 private:
  bool begin_window();  // checkpoints, and what is instructed; false: an interruption ends the run here
  double window_end();  // [s]
  void run_window();
  bool read_row(const State& state, const Eigen::VectorXd& rates);  // false: it ends the window
  bool read_step(StepView& step, double window_end);                // likewise
  bool apply_instructions();                                        // false: there were none
  void cross_jump();  // from the last time before a jump of a given function to the first time after it
  void save_here(bool undisturbed);
  [[noreturn]] void give_up_short_windows(double moved);  // [s], over all that were watched

  double last_row_ = 0.0;  // [s]
  bool given_ = false;     // at the last stop of a leading program: windows end as where samples change inputs
  StepMiddles middles_;
};

}  // namespace footfall
