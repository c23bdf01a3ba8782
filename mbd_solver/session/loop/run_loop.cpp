// A window ends with its sample, the collisions that it shows, and the events that it leads to.

#include "mbd_solver/session/loop/run_loop.h"

#include "coupler/base/clock.h"

namespace footfall {

bool RunLoop::begin() {
  begun_ = wall_clock() - moving_.times().total;
  if (run_.resumed) {
    moving_.update_sample();
  } else {
    moving_.renew();
  }
  run_.surfaces.begin();
  if (!run_.resumed) {
    run_.events.apply();
    run_.inputs.sample_at_start();
  } else if (SignalLoop* const signals = run_.inputs.signals()) {
    signals->triggered(moving_.sample(), moving_.inputs().values);  // is read
  }
  return !run_.resumed;
}

void RunLoop::count_time() { moving_.times().total = wall_clock() - begun_; }

bool RunLoop::save(bool undisturbed) {
  count_time();
  return run_.checkpoints.save(undisturbed);
}

void RunLoop::finish_window() {
  moving_.count_window(1);
  moving_.update_sample();
  run_.foresight.end_window();
  run_.surfaces.check();
  run_.events.take_effect();
}

bool RunLoop::watch_step(StepView& step, double window_end) {
  if (!(step.end() < window_end)) return true;  // finish_window() follows
  step.at(step.end(), moving_.state(), moving_.rates());
  if (moving_.scene().output.reactions || !moving_.mechanism().gears.empty()) {
    Equations& equations = moving_.equations();
    equations.saddle().smallest_multipliers(moving_.state(), moving_.rates().tail(equations.layout().row_count));
  }
  moving_.update_sample();
  const bool goes_on = moving_.coupled() || !run_.events.ends_window();
  if (goes_on && run_.observe_step) run_.observe_step(moving_.sample());
  return goes_on;
}

}  // namespace footfall
