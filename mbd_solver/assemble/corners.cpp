// The earliest corner of all functions and of all signals that are known beforehand.
#include "mbd_solver/assemble/corners.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "mbd_solver/assemble/codes.h"

namespace footfall {
namespace {

GivenSource source_of(const Mechanism& mechanism, const std::string& name) {
  using Kind = GivenSource::Kind;
  const std::optional<SignalSource> source = signal_source(mechanism, name);
  if (!source) return {};
  const int place = static_cast<int>(source->index);
  switch (source->kind) {
    case SignalSource::Kind::kTime: return {Kind::kTime, -1};
    case SignalSource::Kind::kSince: return {Kind::kSince, place};
    case SignalSource::Kind::kSensor: return {};
    case SignalSource::Kind::kPlace: break;
  }
  for (const PlaceEntry& state : mechanism.states)
    if (state.place == place) return {Kind::kHeld, place};
  for (const PlaceEntry& signal : mechanism.signals)
    if (signal.place == place) return {Kind::kSignal, place};
  return {};  // a controller
}

std::vector<SignalNode> continuous_conditions(const Scene& scene) {
  std::vector<SignalNode> conditions;
  for (SignalNode& node : conditions_of(scene))
    if (node.period == 0.0) conditions.push_back(std::move(node));
  return conditions;
}

GivenSignals given_signals(const Scene& scene, const Mechanism& mechanism, const std::vector<SignalNode>& conditions) {
  std::vector<GivenEntry> entries;
  const auto places = [&](const std::vector<std::string>& names) {
    std::vector<int> found;
    for (const PlaceEntry& state : mechanism.states)
      if (std::find(names.begin(), names.end(), state.name) != names.end()) found.push_back(state.place);
    return found;
  };
  if (const ContinuousSignals* const signals = mechanism.model.signals())
    for (std::size_t k = 0; k < signals->chain().size(); ++k) {
      const SignalNode& node = signals->chain().node(k);
      entries.push_back(
          {"signal \"" + node.name + "\"", node.name, node.block.get(), node.inputs, places(node.states)});
    }
  for (const SignalNode& node : conditions)
    entries.push_back({"the condition of event \"" + node.name + "\"", "", node.block.get(), node.inputs, {}});
  // A value set by the leading program is constant until it is set again.
  const auto is_host = [&](int place) {
    for (std::size_t i = 0; i < scene.signals.size(); ++i)
      if (mechanism.signals[i].place == place) return scene.signals[i].kind == SignalKind::kHost;
    return false;
  };
  const auto source = [&](const std::string& name) {
    GivenSource found = source_of(mechanism, name);
    if (found.kind == GivenSource::Kind::kSignal && is_host(found.place)) found.kind = GivenSource::Kind::kHeld;
    return found;
  };
  return {entries, source, scene.end_time};
}

}  // namespace

Corners::Corners(const Scene& scene, const Mechanism& mechanism)
    : functions_(time_functions(scene)),
      conditions_(continuous_conditions(scene)),
      signals_(given_signals(scene, mechanism, conditions_)) {}

Corner Corners::next(double t, const Eigen::VectorXd& values) {
  Corner next = signals_.next(t, values);
  for (const NamedFunction& named : functions_) next = std::min(next, named.function->next_corner(t));
  return next;
}

std::string Corners::name_of_next(double t, const Eigen::VectorXd& values) {
  const Corner first = next(t, values);
  for (const NamedFunction& named : functions_)
    if (!(first < named.function->next_corner(t))) return named.name;
  return signals_.too_fast().empty() ? "signals of time" : signals_.too_fast().front();
}

Corner Corners::next_step_end(double t, const Eigen::VectorXd& values) {
  return std::min(next(t, values), Corner(signals_.next_split(t, values)));
}

std::vector<std::string> Corners::warnings() const {
  std::vector<std::string> warnings;
  for (const std::string& label : signals_.too_fast())
    warnings.push_back(with_code(code::kVariesTooFast, label, " varies too fast in time for the grid of ",
                                 GivenSignals::kCells,
                                 " cells on which its corners are sought: steps may pass over parts of it. Divide "
                                 "end_time, or give a table of its values"));
  return warnings;
}

}  // namespace footfall
