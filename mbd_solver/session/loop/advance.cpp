// A sequence of windows of the integrator from corner to corner.

#include "mbd_solver/session/loop/advance.h"

#include <algorithm>

#include "coupler/base/clock.h"
#include "mbd_solver/session/loop/moving_mechanism.h"

namespace footfall {

void Advance::begin(const State& from, double time, const WindowStops& stops, const Instructions* instructions) {
  phase_ = Phase::kAtCorner;
  state_ = from;
  time_ = time;
  stops_ = stops;
  instructions_ = instructions;
  ended_ = false;
}

void Advance::end_window() {
  if (phase_ == Phase::kIntegrating) {
    moving_.integrator().end_window();
  } else {
    ended_ = true;
  }
}

WindowStop Advance::next() {
  const double started = wall_clock();
  const WindowStop stop = next_stop();
  if (stop.kind == WindowStop::kEnd) moving_.state() = state_;
  moving_.times().mbd += wall_clock() - started;
  if (stop.kind == WindowStop::kEnd) moving_.check_finite();
  return stop;
}

WindowStop Advance::next_stop() {
  for (;;) switch (phase_) {
      case Phase::kAtCorner:
        corner_ = moving_.corners().next_step_end(state_.time, moving_.inputs().values);
        corner_end_ = std::min(corner_.before, time_);
        if (state_.time < corner_end_) moving_.integrator().begin(state_, corner_end_, moving_.inputs(), stops_);
        phase_ = state_.time < corner_end_ ? Phase::kIntegrating : Phase::kBeforeJump;
        break;
      case Phase::kIntegrating: {
        const WindowStop stop = moving_.integrator().next();
        if (stop.kind != WindowStop::kEnd) return stop;
        moving_.rates() = moving_.integrator().end_rates();
        phase_ = Phase::kBeforeJump;
        break;
      }
      case Phase::kBeforeJump:
        if (corner_end_ == time_ || state_.time < corner_end_) return {};
        phase_ = Phase::kBehindRow;
        if (stops_.next_row && instructions_ && instructions_->is_stop(corner_end_))
          return {WindowStop::kRow, &state_, &moving_.rates(), nullptr};
        break;
      case Phase::kBehindRow:
        if (ended_ && instructions_->waiting()) return {};
        ended_ = false;
        state_.time = corner_.after;
        phase_ = Phase::kAtCorner;
        if (state_.time < time_) break;
        moving_.equations().saddle().accelerations(state_, moving_.inputs(), moving_.rates());
        return {};
    }
}

}  // namespace footfall
