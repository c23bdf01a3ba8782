#pragma once
// Events of the scene without a period: their condition is true or false, and may depend on
// anything in a sample. Without grains the instant at which it becomes true is located by
// bisection, also where it holds only between two steps; with grains an event takes effect at the
// end of the window (event_foresight.h). Events with a period take effect at their samples.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "mbd_solver/session/loop/event_foresight.h"
#include "mbd_solver/session/loop/moving_mechanism.h"
#include "mbd_solver/session/signal_loop.h"

namespace footfall {

// Detects events that follow each other faster than the motion can change: without hysteresis the conditions of two states may
// become true in turn at once, and the run would never end.
class EventWatch {
 public:
  // After an event without a period, at `time` of a run to t_end [s]. Throws NumericalError that names the events.
  void count(const std::string& event, double time, double t_end);

 private:
  static constexpr std::size_t kWatched = 300;  // events
  static constexpr double kMostEvents = 1e6;    // that may remain at the present rate
  static constexpr double kShortest = 1e-5;     // mean interval of events that are no chatter [s]

  std::array<std::string, kWatched> names_;
  std::size_t count_ = 0;
  double since_ = 0.0;  // time of the first that is watched [s]
};

class EventFinder {
 public:
  // signals: null without events. All must outlive this.
  EventFinder(MovingMechanism& moving, SignalLoop* signals, EventForesight& foresight)
      : moving_(moving), signals_(signals), foresight_(foresight) {}

  // The present sample belongs to the start, or to a checkpoint.
  void begin() { stand_without_event(); }
  bool has_unsampled() const { return signals_ && signals_->has_unsampled_events(); }
  // An event is due now, or perhaps between now and the last state without one. False: this is that
  // state from now on.
  bool is_due();
  // is_due() at a row or step, which therefore ends the window.
  bool ends_window() {
    const bool due = is_due();
    in_window_ = in_window_ || due;
    return due;
  }
  bool has_ended_window() const { return in_window_; }
  // At the end of a window or behind a jump: returns to the instant of an event that is due, and
  // applies it.
  void take_effect() {
    if (in_window_ || is_due()) locate();
  }
  // All whose condition holds now, one at a time in the order of the scene: conditions are
  // evaluated in the state that the previous event leads to. Throws NumericalError where this does
  // not end.
  void apply();

 private:
  void stand_without_event();
  bool find_between();  // false: the condition held nowhere, and the state is as it was
  void locate();        // the instant is in (without_event_.time, state().time]
  void bisect();        // likewise; sets the state there
  bool holds_now() { return signals_->triggered(moving_.sample(), moving_.inputs().values).event >= 0; }

  MovingMechanism& moving_;
  SignalLoop* signals_;
  EventForesight& foresight_;
  EventWatch watch_;
  bool in_window_ = false;  // a row or step ended the window because a condition holds there,
  bool between_ = false;    // or because it may have held before
  State without_event_;     // the last state in which no condition held; for events without a period
};

// The time in (begin, end) at which a condition holds, between two samples at which none does;
// signals remember the first, and the second is the present one. The comparisons of conditions
// change at instants that bisection finds to this precision, each by itself; between two of them
// the condition is tried. Nothing: it holds nowhere, and the sample belongs to the end. All times
// in [s].
std::optional<double> holds_between(SignalLoop& signals, MovingMechanism& moving, double begin, double end,
                                    double precision, const std::function<bool(double)>& holds_at);

}  // namespace footfall
