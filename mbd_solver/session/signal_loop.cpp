// Sampled signals: values in order first, then the states of blocks that read signals behind them. Events: the first whose
// condition holds in the present state, events without a period before those with one.

#include "mbd_solver/session/signal_loop.h"

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
      z_(Eigen::VectorXd::Zero(chain_.state_count())),
      margins_(margins_of_conditions()),
      margin_(margins_.size(), std::numeric_limits<double>::quiet_NaN()),
      remembered_(margin_) {
  for (const std::string& name : margins_.names())
    margin_names_.push_back(static_cast<std::size_t>(
        std::find(conditions_.names().begin(), conditions_.names().end(), name) - conditions_.names().begin()));
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

const std::string& SignalLoop::event_name(int event) const { return subject_.scene.events[event].name; }

SignalLoop::Trigger SignalLoop::triggered(const Sample& sample, const Eigen::VectorXd& values) {
  if (conditions_.size() == 0) return {};
  condition_readings_.update(sample);
  for (std::size_t i = 0; i < conditions_.names().size(); ++i)
    conditions_.set(i, condition_readings_.value(i, sample, values));
  for (const std::size_t k : order_) {
    const EventSpec& event = subject_.scene.events[events_[k]];
    if (!applies(event, values)) continue;
    if (event.period > 0.0 && !is_due(sample.state.time, event.period, condition_samples_[k])) continue;
    try {
      if (conditions_.inputs(k)[0] != 0.0) return {events_[k], event.period > 0.0};
    } catch (const NumericalError& error) {
      throw_without_value(sample.state.time, error);
    }
  }
  return {};
}

bool SignalLoop::in_state(const std::string& name, const Eigen::VectorXd& values) const {
  for (const PlaceEntry& state : subject_.mechanism.states)
    if (state.name == name) return values(state.place) != 0.0;
  return false;
}

bool SignalLoop::applies(const EventSpec& event, const Eigen::VectorXd& values) const {
  if (event.from.empty()) return !in_state(event.to, values);
  return std::any_of(event.from.begin(), event.from.end(),
                     [&](const std::string& name) { return in_state(name, values); });
}

// ---- conditions that hold for less than a step ----

SignalLoop::Test SignalLoop::test_of(const ExpressionPart& part, std::vector<std::string>& margins) {
  using Kind = ExpressionPart::Kind;
  Test test;
  if (part.kind == Kind::kLogic) {
    test.kind = part.name == "&&" ? Test::Kind::kAnd : Test::Kind::kOr;
  } else if (part.kind == Kind::kPrefix && part.name == "!") {
    test.kind = Test::Kind::kNot;
  } else if (part.kind == Kind::kCompare && part.name != "==" && part.name != "!=") {
    test.kind = Test::Kind::kCompare;
    test.margin = margins.size();
    const std::size_t less = part.name[0] == '<' ? 1 : 0;
    margins.push_back("(" + part.parts[less].text + ") - (" + part.parts[1 - less].text + ")");
    return test;
  } else {
    return test;
  }
  for (const ExpressionPart& inner : part.parts) test.parts.push_back(test_of(inner, margins));
  return test;
}

std::array<bool, 2> SignalLoop::can_be(const Test& test, const std::vector<bool>& truth) {
  if (test.kind == Test::Kind::kOther) return {true, true};
  if (test.kind == Test::Kind::kCompare) return {!truth[test.margin], truth[test.margin]};
  const std::array<bool, 2> a = can_be(test.parts[0], truth);
  if (test.kind == Test::Kind::kNot) return {a[1], a[0]};
  const std::array<bool, 2> b = can_be(test.parts[1], truth);
  return test.kind == Test::Kind::kAnd ? std::array<bool, 2>{a[0] || b[0], a[1] && b[1]}
                                       : std::array<bool, 2>{a[0] && b[0], a[1] || b[1]};
}

SignalChain SignalLoop::margins_of_conditions() {
  std::vector<SignalNode> nodes;
  std::vector<std::string> margins;
  for (std::size_t k = 0; k < conditions_.size(); ++k) {
    const SignalNode& node = conditions_.node(k);
    const std::optional<ExpressionPart> whole =
        node.period == 0.0 ? parts_of(node.inputs[0]) : std::optional<ExpressionPart>();
    if (!whole) continue;
    const std::size_t first = margins.size();
    Test test = test_of(*whole, margins);
    const std::size_t count = margins.size() - first;
    if (count < 2) {
      margins.resize(first);
      continue;
    }
    const std::vector<EventSpec>& events = subject_.scene.events;
    const auto found =
        std::find_if(events.begin(), events.end(), [&](const EventSpec& e) { return e.name == node.name; });
    compared_.push_back({static_cast<int>(found - events.begin()), first, count, std::move(test)});
  }
  for (const std::string& text : margins) {
    SignalNode node;
    node.name = "margin" + std::to_string(nodes.size());
    node.block = std::make_unique<PassBlock>();
    node.inputs = {text};
    nodes.push_back(std::move(node));
  }
  return SignalChain(std::move(nodes));
}

// Of the sample that triggered() has read last.
void SignalLoop::compute_margins(const Sample& sample, const Eigen::VectorXd& values) {
  for (std::size_t i = 0; i < margin_names_.size(); ++i)
    margins_.set(i, condition_readings_.value(margin_names_[i], sample, values));
  for (std::size_t k = 0; k < margins_.size(); ++k) {
    try {
      margin_[k] = margins_.inputs(k)[0];
    } catch (const NumericalError&) {
      margin_[k] = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

void SignalLoop::remember(const Sample& sample, const Eigen::VectorXd& values) {
  if (compared_.empty()) return;
  compute_margins(sample, values);
  remembered_ = margin_;
}

std::vector<std::size_t> SignalLoop::changed(const Sample& sample, const Eigen::VectorXd& values) {
  std::vector<std::size_t> out;
  if (compared_.empty()) return out;
  compute_margins(sample, values);
  for (const Condition& condition : compared_) {
    if (!applies(subject_.scene.events[condition.event], values)) continue;
    for (std::size_t k = condition.first; k < condition.first + condition.count; ++k)
      if (margin_[k] * remembered_[k] < 0.0) out.push_back(k);
  }
  return out;
}

bool SignalLoop::may_have_held(const Sample& sample, const Eigen::VectorXd& values) {
  constexpr std::size_t kMost = 8;  // changes in one step; of more, any order is possible
  const std::vector<std::size_t> all = changed(sample, values);
  if (all.size() < 2) return false;
  for (const Condition& condition : compared_) {
    std::vector<std::size_t> mine;
    for (const std::size_t k : all)
      if (k >= condition.first && k < condition.first + condition.count) mine.push_back(k);
    if (mine.size() < 2) continue;
    if (mine.size() > kMost) return true;
    // In which order they change is not known: each set of those that have changed is tried.
    for (std::size_t order = 0; order < (std::size_t{1} << mine.size()); ++order) {
      std::vector<bool> truth(margin_.size());
      for (std::size_t k = 0; k < margin_.size(); ++k) truth[k] = margin_[k] > 0.0;
      for (std::size_t m = 0; m < mine.size(); ++m)
        if ((order >> m & 1U) != 0) truth[mine[m]] = !truth[mine[m]];
      if (can_be(condition.test, truth)[1]) return true;
    }
  }
  return false;
}

void SignalLoop::apply(int event, double time, Eigen::VectorXd& values) {
  const std::string& to = subject_.scene.events[event].to;
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
  archive.members<&SignalLoop::samples_, &SignalLoop::condition_samples_, &SignalLoop::was_active_, &SignalLoop::z_,
                  &SignalLoop::readings_, &SignalLoop::condition_readings_>(*this);
  for (std::size_t k = 0; k < chain_.size(); ++k) archive(chain_.node(k).name.c_str(), *chain_.node(k).block);
}

}  // namespace footfall
