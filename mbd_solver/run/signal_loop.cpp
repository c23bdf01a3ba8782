// Sampled signals: values in order first, then the states of blocks that read signals behind them. Events: the first whose
// condition holds in the present state, events without a period before those with one.

#include "mbd_solver/run/signal_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/model/control/signal_blocks.h"

namespace footfall {
namespace {

// An expression without a value is a mistake of the scene at the start, and a failure of the run later.
[[noreturn]] void throw_without_value(double time, const NumericalError& error) {
  if (time == 0.0) throw InputError(error.what());
  throw NumericalError("t = " + plain_text(time) + " s: " + error.what());
}

long samples_until(double time, double period) { return static_cast<long>(std::floor(time / period + 1e-6)) + 1; }

}  // namespace

SignalLoop::SignalLoop(std::vector<SignalNode> sampled, const Subject& subject)
    : subject_(subject),
      chain_(chain_of_signals(subject.scene, std::move(sampled))),
      conditions_(conditions_of(subject.scene)),
      readings_(chain_.names(), subject),
      condition_readings_(conditions_.names(), subject),
      samples_(chain_.size(), 0),
      condition_samples_(conditions_.size(), 0),
      was_active_(chain_.size(), false),
      z_(Eigen::VectorXd::Zero(chain_.state_count())) {
  const std::vector<EventSpec>& events = subject.scene.events;
  for (std::size_t k = 0; k < conditions_.size(); ++k) {
    const auto found = std::find_if(events.begin(), events.end(),
                                    [&](const EventSpec& e) { return e.name == conditions_.node(k).name; });
    events_.push_back(static_cast<int>(found - events.begin()));
    unsampled_events_ = unsampled_events_ || found->period == 0.0;
    order_.push_back(k);
  }
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    const bool sampled_a = conditions_.node(a).period > 0.0, sampled_b = conditions_.node(b).period > 0.0;
    return sampled_a != sampled_b ? sampled_b : events_[a] < events_[b];
  });
}

double SignalLoop::next_sample() const {
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < chain_.size(); ++k)
    next = std::min(next, static_cast<double>(samples_[k]) * chain_.node(k).period);
  for (std::size_t k = 0; k < conditions_.size(); ++k)
    if (const double period = conditions_.node(k).period; period > 0.0)
      next = std::min(next, static_cast<double>(condition_samples_[k]) * period);
  return next;
}

const std::string& SignalLoop::event_name(int event) const {
  return subject_.scene.events[static_cast<std::size_t>(event)].name;
}

SignalLoop::Trigger SignalLoop::triggered(const Sample& sample, const Eigen::VectorXd& values) {
  if (conditions_.size() == 0) return {};
  condition_readings_.update(sample);
  for (std::size_t i = 0; i < conditions_.names().size(); ++i)
    conditions_.set(i, condition_readings_.value(i, sample, values));
  const auto in_state = [&](const std::string& name) {
    for (const PlaceEntry& state : subject_.mechanism.states)
      if (state.name == name) return values(state.place) != 0.0;
    return false;
  };
  for (const std::size_t k : order_) {
    const EventSpec& event = subject_.scene.events[static_cast<std::size_t>(events_[k])];
    const bool applies =
        event.from.empty() ? !in_state(event.to) : std::any_of(event.from.begin(), event.from.end(), in_state);
    if (!applies) continue;
    if (event.period > 0.0 && !is_due(sample.state.time, event.period, condition_samples_[k])) continue;
    try {
      if (conditions_.inputs(k)[0] != 0.0) return {events_[k], event.period > 0.0};
    } catch (const NumericalError& error) {
      throw_without_value(sample.state.time, error);
    }
  }
  return {};
}

void SignalLoop::apply(int event, double time, Eigen::VectorXd& values) {
  const std::string& to = subject_.scene.events[static_cast<std::size_t>(event)].to;
  const Mechanism& mechanism = subject_.mechanism;
  for (const PlaceEntry& state : mechanism.states) values(state.place) = state.name == to ? 1.0 : 0.0;
  values(mechanism.state_since) = time;
  for (std::size_t k = 0; k < chain_.size(); ++k) {
    const std::vector<std::string>& states = chain_.node(k).states;
    if (!states.empty() && std::find(states.begin(), states.end(), to) == states.end()) {
      values(chain_.node(k).place) = 0.0;
      was_active_[k] = false;
    }
  }
}

void SignalLoop::sample_due(const Sample& sample, Eigen::VectorXd& values) {
  const double time = sample.state.time;
  for (std::size_t k = 0; k < conditions_.size(); ++k)
    if (const double period = conditions_.node(k).period; period > 0.0 && is_due(time, period, condition_samples_[k]))
      condition_samples_[k] = samples_until(time, period);
  const auto due = [&](std::size_t k) { return is_due(time, chain_.node(k).period, samples_[k]); };
  bool any = false;
  for (std::size_t k = 0; k < chain_.size(); ++k) any = any || due(k);
  if (!any) return;

  readings_.update(sample);
  for (std::size_t i = 0; i < chain_.names().size(); ++i) chain_.set(i, readings_.value(i, sample, values));
  const auto states = [&](std::size_t k) -> Eigen::Ref<Eigen::VectorXd> {
    return z_.segment(chain_.first_state(k), chain_.node(k).block->state_count());
  };
  try {
    // Values in order. Blocks whose output depends on their states alone advance them when all values are known.
    for (std::size_t k = 0; k < chain_.size(); ++k) chain_.put(k, values(chain_.node(k).place));
    for (std::size_t k = 0; k < chain_.size(); ++k) {
      if (!due(k)) continue;
      const SignalNode& node = chain_.node(k);
      double y = 0.0;
      if (chain_.active(k)) {
        if (!was_active_[k]) chain_.settle(k, states(k));
        y = node.block->passes_through() ? node.block->sample(chain_.inputs(k), node.period, states(k))
                                         : node.block->value(states(k), states(k));
      }
      chain_.put(k, y);
      values(node.place) = y;
    }
    for (std::size_t k = 0; k < chain_.size(); ++k) {
      if (!due(k)) continue;
      const SignalNode& node = chain_.node(k);
      was_active_[k] = chain_.active(k);
      if (was_active_[k] && !node.block->passes_through())
        node.block->advance(chain_.inputs(k), node.period, states(k));
      samples_[k] = samples_until(time, node.period);
    }
  } catch (const NumericalError& error) {
    throw_without_value(time, error);
  }
}

void SignalLoop::visit(Archive& archive) {
  archive("samples", samples_);
  archive("condition_samples", condition_samples_);
  archive("was_active", was_active_);
  archive("z", z_);
  archive("readings", readings_);
  archive("condition_readings", condition_readings_);
  for (std::size_t k = 0; k < chain_.size(); ++k) archive(chain_.node(k).name.c_str(), *chain_.node(k).block);
}

}  // namespace footfall
