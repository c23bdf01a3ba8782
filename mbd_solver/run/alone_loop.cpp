// The integrator calls back at rows and steps within a window; each of them may end the window.

#include "mbd_solver/run/alone_loop.h"

#include <algorithm>
#include <string>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/run/codes.h"

namespace footfall {

void AloneLoop::run() {
  begin();
  last_row_ = moving_.state().time;
  WindowWatch watch(last_row_);
  while (!moving_.finished()) {
    if (watch.is_stuck(moving_.state().time, moving_.t_end())) give_up_short_windows(watch.moved());
    if (!begin_window()) break;
    run_window();
  }
}

bool AloneLoop::begin_window() {
  const bool end_requested = interrupted();
  Checkpointer& checkpoints = run_.checkpoints;
  const bool saves = checkpoints.writes() && (checkpoints.is_due(moving_.state().time) || end_requested);
  if (saves) save_here(false);
  run_.instructions.checkpoint_answered();
  if (end_requested && (saves || !checkpoints.writes())) return false;
  given_ = apply_instructions() || (given_ && run_.instructions.has_stop_behind(moving_.state().time));
  cross_jump();
  run_.inputs.sample_due();
  return true;
}

double AloneLoop::window_end() {
  const double now = moving_.state().time, t_end = moving_.t_end();
  return std::min({run_.inputs.change() ? run_.inputs.next_sample() : t_end, t_end,
                   given_ ? run_.instructions.stop_after(now) : t_end, run_.checkpoints.next(),
                   moving_.corners().next(now, moving_.inputs().values).before});
}

void AloneLoop::run_window() {
  const double end = window_end();
  Rows rows;
  rows.next = [&](double t) { return run_.instructions.next(t, std::min(run_.inputs.next_sample(), moving_.t_end())); };
  rows.on_row = [&](const State& state, const Eigen::VectorXd& rates) { return read_row(state, rates); };
  if (run_.observe_step || run_.events.has_unsampled())
    rows.on_step = [&](StepView& step) { return read_step(step, end); };
  moving_.advance(moving_.state(), end, rows, &run_.instructions);
  const double now = moving_.state().time;
  const bool ended_at_row = !run_.events.has_ended_window() && now < end && now == last_row_;
  if (ended_at_row) return;  // observed already
  finish_window();
  cross_jump();
  observe(wall_clock());
}

bool AloneLoop::read_row(const State& state, const Eigen::VectorXd& rates) {
  const double started = wall_clock();
  moving_.state() = state;
  moving_.rates() = rates;
  moving_.check_finite();
  moving_.count_window(1);
  moving_.update_sample();
  run_.surfaces.check();
  if (run_.events.ends_window()) {
    moving_.count_window(-1);
    return false;
  }
  observe(started);
  if (run_.checkpoints.overdue()) save_here(true);
  last_row_ = moving_.state().time;
  const bool led = run_.instructions.waiting();
  if (!led) run_.inputs.sample_due();
  moving_.times().mbd -= wall_clock() - started;  // advance() counts it
  return !interrupted() && !run_.inputs.change() && !led && !given_;
}

bool AloneLoop::read_step(StepView& step, double window_end) {
  const bool peaks = run_.observe_step && middles_.are_peaks(step);
  if (!watch_step(step, window_end)) return false;
  if (!peaks) return true;
  const double started = wall_clock();
  moving_.show(middles_.state(), middles_.rates());
  run_.observe_step(moving_.sample());
  moving_.times().mbd -= wall_clock() - started;
  return true;
}

bool AloneLoop::apply_instructions() {
  if (!run_.instructions.apply_inputs(moving_.inputs().values)) return false;
  if (!run_.inputs.signals()) return true;
  moving_.renew();
  run_.events.apply();
  return true;
}

void AloneLoop::cross_jump() {
  const Corner corner = moving_.corners().next(moving_.state().time, moving_.inputs().values);
  if (!(corner.before <= moving_.state().time)) return;
  moving_.state().time = corner.after;
  moving_.renew();
  run_.events.take_effect();
}

void AloneLoop::save_here(bool undisturbed) {
  save(undisturbed);
  if (!undisturbed) middles_ = {};  // as a resumed run begins
}

void AloneLoop::give_up_short_windows(double moved) {
  Corners& corners = moving_.corners();
  const double now = moving_.state().time;
  const Eigen::VectorXd& values = moving_.inputs().values;
  const bool samples = run_.inputs.next_sample() < corners.next_time(now, values);
  throw NumericalError(code::kWindowsTooShort,
                       "t = " + plain_text(now) + " s: " + std::to_string(WindowWatch::kWatched) +
                           " windows advanced the time by only " + number_text(moved, 2) + " s of " +
                           number_text(moving_.t_end()) + " s. They end at " +
                           (samples ? "samples of signals or controllers: lengthen their period"
                                    : "corners of " + corners.name_of_next(now, values) +
                                          ": remove points of tables that are so near to each other"));
}

}  // namespace footfall
