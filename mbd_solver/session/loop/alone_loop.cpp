// The loop is a list of phases: each call continues where the last one has paused.

#include "mbd_solver/session/loop/alone_loop.h"

#include <algorithm>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/session/codes.h"

namespace footfall {

AloneLoop::AloneLoop(RunParts& run, const volatile std::sig_atomic_t& interrupted)
    : RunLoop(run, interrupted), advance_(run.moving), next_row_([this](double t) {
        return run_.instructions.next(t, std::min(run_.inputs.next_sample(), moving_.t_end()));
      }) {}

Reached AloneLoop::next() {
  for (;;) switch (phase_) {
      case Phase::kStart:
        phase_ = Phase::kStarted;
        if (begin()) return Reached::kSample;
        break;
      case Phase::kStarted:
        finish_start();
        last_row_ = moving_.state().time;
        watch_ = WindowWatch(last_row_);
        phase_ = Phase::kBetweenWindows;
        break;
      case Phase::kBetweenWindows:
        phase_ = Phase::kBeforeWindow;
        heed_end();
        if (moving_.finished()) {
          phase_ = Phase::kEnded;
        } else if (saves_checkpoint()) {
          return Reached::kCheckpoint;
        }
        break;
      case Phase::kBeforeWindow:
        phase_ = Phase::kInWindow;
        if (stops_) {
          phase_ = Phase::kEnded;
        } else {
          begin_window();
        }
        break;
      case Phase::kInWindow:
        if (continue_window()) return Reached::kSample;
        break;
      case Phase::kAtRow:
        leave_row();
        phase_ = Phase::kInWindow;
        break;
      case Phase::kEnded: return Reached::kEnd;
    }
}

bool AloneLoop::saves_checkpoint() {
  const double now = moving_.state().time;
  if (watch_.is_stuck(now, moving_.t_end())) give_up_short_windows();
  const bool end_requested = interrupted();
  Checkpointer& checkpoints = run_.checkpoints;
  const bool saves = checkpoints.writes() && (checkpoints.is_due(now) || end_requested);
  if (saves) save_here(false);
  run_.instructions.checkpoint_answered();
  stops_ = end_requested && (saves || !checkpoints.writes());
  return saves;
}

void AloneLoop::begin_window() {
  given_ = apply_instructions() || (given_ && run_.instructions.has_stop_behind(moving_.state().time));
  cross_jump();
  run_.inputs.sample_due();
  end_ = window_end();
  advance_.begin(moving_.state(), end_, {&next_row_, run_.observe_step || run_.events.has_unsampled()},
                 &run_.instructions);
}

double AloneLoop::window_end() {
  const double now = moving_.state().time, t_end = moving_.t_end();
  return std::min({run_.inputs.change() ? run_.inputs.next_sample() : t_end, t_end,
                   given_ ? run_.instructions.stop_after(now) : t_end, run_.checkpoints.next(),
                   moving_.corners().next(now, moving_.inputs().values).before});
}

bool AloneLoop::continue_window() {
  const WindowStop stop = advance_.next();
  switch (stop.kind) {
    case WindowStop::kEnd: return end_window();
    case WindowStop::kStep: read_step(*stop.step); return false;
    case WindowStop::kRow: break;
  }
  if (read_row(*stop.state, *stop.rates)) {
    phase_ = Phase::kAtRow;
    return true;
  }
  advance_.end_window();
  return false;
}

bool AloneLoop::end_window() {
  phase_ = Phase::kBetweenWindows;
  const double now = moving_.state().time;
  const bool ended_at_row = !run_.events.has_ended_window() && now < end_ && now == last_row_;
  if (ended_at_row) return false;  // observed already
  finish_window();
  cross_jump();
  count_time();
  return true;
}

bool AloneLoop::read_row(const State& state, const Eigen::VectorXd& rates) {
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
  count_time();
  return true;
}

void AloneLoop::leave_row() {
  if (run_.checkpoints.overdue()) save_here(true);
  last_row_ = moving_.state().time;
  heed_end();
  const bool led = run_.instructions.waiting();
  if (!led) run_.inputs.sample_due();
  if (interrupted() || run_.inputs.change() || led || given_ || moving_.finished()) advance_.end_window();
}

void AloneLoop::heed_end() {
  const Instructions& instructions = run_.instructions;
  if (!instructions.end_requested()) return;
  moving_.end_at(std::min(moving_.t_end(), instructions.rows().after(moving_.state().time)));
}

void AloneLoop::read_step(StepView& step) {
  const bool peaks = run_.observe_step && middles_.are_peaks(step);
  if (!watch_step(step, end_)) {
    advance_.end_window();
  } else if (peaks) {
    moving_.show(middles_.state(), middles_.rates());
    run_.observe_step(moving_.sample());
  }
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

void AloneLoop::give_up_short_windows() {
  Corners& corners = moving_.corners();
  const double now = moving_.state().time;
  const Eigen::VectorXd& values = moving_.inputs().values;
  const bool samples = run_.inputs.next_sample() < corners.next_time(now, values);
  throw NumericalError(code::kWindowsTooShort,
                       "t = " + plain_text(now) + " s: " + std::to_string(WindowWatch::kWatched) +
                           " windows advanced the time by only " + number_text(watch_.moved(), 2) + " s of " +
                           number_text(moving_.t_end()) + " s. They end at " +
                           (samples ? "samples of signals or controllers: lengthen their period"
                                    : "corners of " + corners.name_of_next(now, values) +
                                          ": remove points of tables that are so near to each other"));
}

}  // namespace footfall
