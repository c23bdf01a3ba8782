// Events of the scene within a run: their instant, and what changes there. mbd_solver/run/simulation.h.
#include "mbd_solver/run/simulation.h"

#include "coupler/base/errors.h"

namespace footfall {

bool Simulation::event_holds() {
  SignalLoop* const signals = control_.signals();
  if (!signals) return false;
  if (signals->held(sampler_.sample(), inputs_.values).event >= 0) return true;
  if (signals->watches()) checked_ = state_;
  return false;
}

// One at a time, in the order of the scene: each is judged in the state that the one before leads to.
void Simulation::let_events_happen() {
  SignalLoop* const signals = control_.signals();
  if (!signals) return;
  const double time = state_.time;
  std::string way;
  for (std::size_t count = 0;; ++count) {
    const int event = signals->held(sampler_.sample(), inputs_.values).event;
    if (event < 0) break;
    way += (way.empty() ? "\"" : ", \"") + signals->event_name(event) + "\"";
    if (count > signals->state_count())
      throw NumericalError("t = " + std::to_string(time) + " s: events lead in a circle without end: " + way +
                           "; expected conditions that are false in the state they lead to.");
    const Eigen::VectorXd before = inputs_.values;
    signals->happen(event, time, inputs_.values);
    equations_.settle_signals(&before, inputs_, state_);
    equations_.saddle().accelerations(state_, inputs_, rates_);
    take_sample();
  }
  checked_ = state_;
}

// Half of the interval at a time: a condition is true or false, and may hang on anything that a sample has.
void Simulation::find_event() {
  event_ahead_ = false;
  SignalLoop& signals = *control_.signals();
  const bool sampled = signals.held(sampler_.sample(), inputs_.values).sampled;
  if (!coupled_ && !sampled && checked_.time < state_.time) {
    const double step = checked_.step;
    const auto go_to = [&](double time) {
      State state = checked_;
      integrator_->advance(state, time, inputs_);
      state_ = state;
      rates_ = integrator_->end_rates();
      check_finite();
      take_sample();
    };
    double late = state_.time;
    while (late - checked_.time > kEventTime) {
      const double middle = 0.5 * (checked_.time + late);
      if (middle <= checked_.time || middle >= late) break;
      go_to(middle);
      if (signals.held(sampler_.sample(), inputs_.values).event >= 0) {
        late = middle;
      } else {
        checked_ = state_;
      }
    }
    if (state_.time != late) go_to(late);
    state_.step = step;
  }
  let_events_happen();
}

}  // namespace footfall
