// A window: what is due before it, the exchange, the motion under the load that it brought, and its
// end.

#include "mbd_solver/session/loop/coupled_loop.h"

#include <algorithm>

#include "coupler/base/clock.h"

namespace footfall {

void CoupledLoop::run() {
  if (begin()) observe_(moving_.sample());
  finish_start();
  while (!moving_.finished()) {
    bool saved = false;
    if (run_.checkpoints.writes() && coupled_.checkpoint_required()) {
      observe_once();
      saved = save(coupled_.checkpoint_undisturbed());
      run_.instructions.checkpoint_answered();
    }
    if (end_requested() && (saved || !run_.checkpoints.writes())) break;
    if (!run_window()) break;
  }
  observe_once();
  if (!moving_.finished()) return;
  if (moving_.scene().output.keep_grains && run_.checkpoints.writes() && coupled_.checkpoint_required()) save(false);
  coupled_.close();
}

bool CoupledLoop::run_window() {
  sample_before_window();
  const double corner = moving_.corners().next_time(moving_.state().time, moving_.inputs().values);
  const double end = exchange(corner);
  if (coupled_.script_has_ended()) return false;
  advance(end);
  coupled_.settle_work(moving_.state());
  if (corner <= end) coupled_.restart();
  finish_window();
  coupled_.end_window(moving_.state(), moving_.sample().kinematics);
  observed_ = false;
  return true;
}

void CoupledLoop::advance(double end) {
  // An interval below the step of the grains asks for a row per window.
  const bool has_rows = run_.observe_row && moving_.scene().output.interval > 0.999 * coupled_.agreement().dt;
  const std::function<double(double)> next_row = [&](double t) { return run_.instructions.rows().after(t); };
  advance_.begin(moving_.state(), end, {has_rows ? &next_row : nullptr, run_.observe_step != nullptr},
                 &run_.instructions);
  for (WindowStop stop = advance_.next(); stop.kind != WindowStop::kEnd; stop = advance_.next()) {
    if (stop.kind == WindowStop::kStep) {
      watch_step(*stop.step, end);
    } else {
      moving_.show(*stop.state, *stop.rates);
      run_.observe_row(moving_.sample());
    }
  }
}

void CoupledLoop::sample_before_window() {
  if (run_.inputs.next_sample() > moving_.state().time + 1e-6 * coupled_.agreement().dt) return;
  observe_once();
  const Eigen::VectorXd before = moving_.inputs().values;
  run_.inputs.sample_due();
  if (!run_.inputs.signals() || moving_.inputs().values == before) return;
  moving_.renew();
  coupled_.restart();
}

double CoupledLoop::exchange(double corner) {
  // Work for which the grains need not wait.
  const auto meanwhile = [&] {
    const double started = wall_clock();
    observe_once();
    run_.inputs.sample_due();
    moving_.times().overlapped += wall_clock() - started;
  };
  if (run_.instructions.end_requested())
    moving_.end_at(std::min(moving_.t_end(), coupled_.longest_window_end(moving_.state().time)));
  try {
    const double known =
        std::min({run_.inputs.next_sample(), corner, run_.instructions.stop_after(moving_.state().time)});
    const double stop = std::min(known, run_.foresight.find(known));
    run_.foresight.begin_window();
    return coupled_.exchange(
        moving_.state(), moving_.sample().kinematics, stop, moving_.t_end(),
        [&](double time) { return checkpoint_at(time); }, meanwhile, moving_.inputs());
  } catch (...) {
    observe_once();  // the last row of a run whose partner is gone
    throw;
  }
}

CheckpointRequest CoupledLoop::checkpoint_at(double time) {
  const bool last = time >= moving_.t_end() * (1.0 - 1e-12);
  if (last && !moving_.scene().output.keep_grains) return {};
  return run_.checkpoints.announce(last || run_.checkpoints.is_due(time) || end_requested());
}

void CoupledLoop::observe_once() {
  if (observed_) return;
  observed_ = true;
  count_time();
  observe_(moving_.sample());
  run_.instructions.apply_inputs(moving_.inputs().values);
}

}  // namespace footfall
