// Bisection moves the mechanism from the last state without an event to times before the present
// one, and compares conditions there.

#include "mbd_solver/session/loop/event_finder.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/session/codes.h"

namespace footfall {

void EventWatch::count(const std::string& event, double time, double t_end) {
  if (count_ == 0) since_ = time;
  names_[count_] = event;
  if (++count_ < kWatched) return;
  count_ = 0;
  const double interval = (time - since_) / (kWatched - 1);  // [s]
  if (interval > kShortest || t_end - time < kMostEvents * interval) return;
  std::vector<std::string> names;
  for (const std::string& name : std::set<std::string>(names_.begin(), names_.end()))
    names.push_back("\"" + name + "\"");
  throw NumericalError(code::kEventChatter,
                       "t = " + plain_text(time) + " s: the events " + joined(names) + " alternate without end, " +
                           std::to_string(kWatched) + " times within " + number_text(time - since_, 2) +
                           " s. Give their conditions a hysteresis, such as \"b.vx < -0.01\" and \"b.vx > 0.01\", or "
                           "one of them a period, such as period_ms = 1");
}

bool EventFinder::is_due() {
  if (!signals_) return false;
  if (holds_now()) return true;
  if (!signals_->has_unsampled_events()) return false;
  if (!moving_.coupled() && without_event_.time < moving_.state().time &&
      signals_->may_have_held(moving_.sample(), moving_.inputs().values)) {
    between_ = true;
    return true;
  }
  stand_without_event();
  return false;
}

void EventFinder::stand_without_event() {
  without_event_ = moving_.state();
  if (signals_) signals_->remember(moving_.sample(), moving_.inputs().values);
}

std::optional<double> holds_between(SignalLoop& signals, MovingMechanism& moving, double begin, double end,
                                    double precision, const std::function<bool(double)>& holds_at) {
  const auto changed = [&] { return signals.changed(moving.sample(), moving.inputs().values); };
  if (!signals.may_have_held(moving.sample(), moving.inputs().values)) return std::nullopt;
  std::vector<double> instants;
  for (const std::size_t one : changed()) {
    double early = begin, late = end;
    while (late - early > precision) {
      const double middle = 0.5 * (early + late);
      if (middle <= early || middle >= late) break;
      holds_at(middle);
      const std::vector<std::size_t> now = changed();
      (std::find(now.begin(), now.end(), one) != now.end() ? late : early) = middle;
    }
    instants.push_back(late);
  }
  std::sort(instants.begin(), instants.end());
  for (std::size_t i = 1; i < instants.size(); ++i)
    if (const double middle = 0.5 * (instants[i - 1] + instants[i]); middle > begin && holds_at(middle)) return middle;
  holds_at(end);
  return std::nullopt;
}

bool EventFinder::find_between() {
  const State end = moving_.state(), begin = without_event_;
  const Eigen::VectorXd end_rates = moving_.rates();
  const auto holds_at = [&](double time) {
    moving_.advance(begin, time);
    moving_.update_sample();
    return holds_now();
  };
  if (holds_between(*signals_, moving_, begin.time, end.time, kEventTime, holds_at)) return true;
  moving_.integrator().forget();
  moving_.show(end, end_rates);
  stand_without_event();
  return false;
}

void EventFinder::apply() {
  if (!signals_) return;
  State& state = moving_.state();
  Inputs& inputs = moving_.inputs();
  CoupledRun* const coupled = moving_.coupled();
  const double time = state.time;
  std::string names;
  for (std::size_t count = 0;; ++count) {
    const SignalLoop::Trigger trigger = signals_->triggered(moving_.sample(), inputs.values);
    const int event = trigger.event;
    if (event < 0) break;
    names += (names.empty() ? "\"" : ", \"") + signals_->event_name(event) + "\"";
    if (count > signals_->state_count())
      throw NumericalError(code::kEventLoop, "t = " + plain_text(time) +
                                                 " s: events trigger each other without end: " + names +
                                                 ": give each a condition that is false in the state it leads to");
    if (!coupled) watch_.count(signals_->event_name(event), time, moving_.t_end());
    const Eigen::VectorXd before = inputs.values, rates = moving_.rates();
    signals_->apply(event, time, inputs.values);
    moving_.equations().settle_signals(&before, inputs, state);
    moving_.renew();
    if (coupled) coupled->restart();
    if (coupled && !trigger.sampled)
      foresight_.tell_of_late_event(signals_->event_name(event), moving_.rates() - rates);
  }
  stand_without_event();
}

void EventFinder::locate() {
  in_window_ = false;
  if (std::exchange(between_, false) && !find_between()) return;
  const bool sampled = signals_->triggered(moving_.sample(), moving_.inputs().values).sampled;
  if (!moving_.coupled() && !sampled && without_event_.time < moving_.state().time) bisect();
  apply();
}

void EventFinder::bisect() {
  const double step = without_event_.step;
  const auto go_to = [&](double time) {
    moving_.advance(without_event_, time);
    moving_.update_sample();
  };
  double late = moving_.state().time;
  while (late - without_event_.time > kEventTime) {
    const double middle = 0.5 * (without_event_.time + late);
    if (middle <= without_event_.time || middle >= late) break;
    go_to(middle);
    if (holds_now()) {
      late = middle;
    } else {
      without_event_ = moving_.state();
    }
  }
  if (moving_.state().time != late) go_to(late);
  moving_.state().step = step;
}

}  // namespace footfall
