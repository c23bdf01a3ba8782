// Signals, states and events.
#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/signals/expression.h"
#include "mbd_solver/scene/kind_keys.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {
namespace {

template <class Spec>
std::vector<std::string> names_in(const std::vector<Spec>& specs) {
  std::vector<std::string> names;
  for (const Spec& spec : specs) names.push_back(spec.name);
  return names;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// "signal.pitch" with the prefix "signal.": "pitch".
bool cut_prefix(const std::string& text, const std::string& prefix, std::string& rest) {
  if (text.rfind(prefix, 0) != 0) return false;
  rest = text.substr(prefix.size());
  return true;
}

void check_state_name(const Scene& scene, const Source& source, const std::string& key, const std::string& name,
                      Findings& findings) {
  const std::vector<std::string> states = names_in(scene.states);
  if (name.empty() || holds(states, name)) return;
  findings.error(source, key, "unknown state \"" + name + "\"." + known_names("states", name, states));
}

// It can be read, and the signals and states that it names are there. Columns are known when the mechanism is built.
void check_expression(const Scene& scene, const Source& source, const std::string& key, const std::string& text,
                      Findings& findings) {
  if (text.empty()) return;
  try {
    for (const std::string& name : Expression::names_in(text)) {
      std::string rest;
      if (cut_prefix(name, "signal.", rest)) check_signal_name(scene, source, key, rest, findings);
      if (name == "state.since") {
        if (scene.states.empty()) findings.error(source, key, "asks for state.since, but there are no [[states]]");
      } else if (cut_prefix(name, "state.", rest)) {
        check_state_name(scene, source, key, rest, findings);
      }
    }
  } catch (const InputError& error) {
    findings.error(source, key, error.what());
  }
}

bool needs_input(SignalKind kind) { return kind != SignalKind::kFuzzy; }

bool is_filter(SignalKind kind) {
  return kind == SignalKind::kLowpass || kind == SignalKind::kLowpass2 || kind == SignalKind::kNotch;
}

void check_rising(const SignalSpec& s, const std::string& key, const std::vector<double>& x, Findings& findings) {
  if (x.size() < 2) {
    findings.error(s.source, key, "has fewer than two values; expected at least two, rising");
    return;
  }
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] > x[i - 1]) continue;
    findings.error(s.source, key,
                   "has " + number_text(x[i]) + " after " + number_text(x[i - 1]) + "; expected values that rise");
    return;
  }
}

void check_limits_of(const SignalSpec& s, Findings& findings) {
  if (s.min && s.max) check_min_below_max(s.source, "", *s.min, *s.max, Unit::kNone, findings);
  if (s.kind == SignalKind::kSaturation && !s.min && !s.max)
    findings.error(s.source, "", "limits nothing; give min, max or both");
  if (s.kind != SignalKind::kPid) return;
  if (s.kp == 0.0 && s.ki == 0.0 && s.kd == 0.0)
    findings.error(s.source, "kp", "is missing; give at least one of kp, ki, kd");
  if ((s.min || s.max) && s.ki > 0.0 && s.kp == 0.0)
    findings.error(s.source, "kp",
                   "is missing; with limits the integral is held back by what is cut off over kp, expected kp > 0");
  if (s.kd > 0.0 && s.rate.empty() && s.derivative_frequency == 0.0 && s.period == 0.0)
    findings.error(s.source, "derivative_frequency",
                   "is missing; a continuous pid with kd needs it (Hz), or rate = \"...\", the input's derivative");
  if (!s.rate.empty() && s.kd == 0.0) findings.error(s.source, "rate", "is given without kd, which it goes to");
}

void check_table(const SignalSpec& s, Findings& findings) {
  if (s.kind == SignalKind::kTable) {
    std::vector<double> x;
    for (const Eigen::Vector2d& point : s.points) x.push_back(point.x());
    if (s.source.refused.count("points") == 0) check_rising(s, "points", x, findings);
  }
  if (s.kind != SignalKind::kTable2) return;
  for (const char* key : {"x", "x2", "input2", "values"})
    if (s.source.refused.count(key) > 0) return;
  check_rising(s, "x", s.x, findings);
  check_rising(s, "x2", s.x2, findings);
  if (s.input2.empty()) findings.error(s.source, "input2", "is missing; this kind of signal has two inputs");
  if (s.values.size() != s.x.size() * s.x2.size())
    findings.error(s.source, "values",
                   "are " + std::to_string(s.values.size()) + " numbers, expected one for each pair of x and x2 (" +
                       std::to_string(s.x.size() * s.x2.size()) + ")");
}

void check_signal(const Scene& scene, const SignalSpec& s, Findings& findings) {
  for (const std::string& key : foreign_keys(s.kind))
    if (s.source.written_together("kind", key))
      findings.error(s.source, key, "means nothing for this kind of signal; leave it out");
  const auto refused = [&](const std::string& key) { return s.source.refused.count(key) > 0; };
  if (needs_input(s.kind) && s.input.empty() && !refused("input"))
    findings.error(s.source, "input", "is missing; expected an expression such as \"0.3 - knee.angle\"");
  check_expression(scene, s.source, "input", s.input, findings);
  check_expression(scene, s.source, "input2", s.input2, findings);
  check_expression(scene, s.source, "rate", s.rate, findings);
  for (const std::string& input : s.inputs) check_expression(scene, s.source, "inputs", input, findings);
  for (const std::string& state : s.states) check_state_name(scene, s.source, "states", state, findings);
  check_limits_of(s, findings);
  check_table(s, findings);
  const auto is_what = [&](const std::string& key) { return s.source.given(key) ? "is 0" : "is missing"; };
  if (is_filter(s.kind) && !(s.frequency > 0.0) && !refused("frequency"))
    findings.error(s.source, "frequency",
                   std::string(is_what("frequency")) + "; a filter needs it (Hz), expected more than 0");
  if (s.kind == SignalKind::kRateLimit && !(s.max_rate > 0.0) && !refused("max_rate"))
    findings.error(s.source, "max_rate", std::string(is_what("max_rate")) + "; expected more than 0, per second");
  if (s.kind == SignalKind::kRateLimit && s.period == 0.0 && !refused("period"))
    findings.error(s.source, "period", "is missing; a rate limit is sampled, for example period_ms = 1");
  if (s.kind == SignalKind::kFuzzy && s.file.empty() && !refused("file"))
    findings.error(s.source, "file", "is missing; a fuzzy signal is read from an .fll file");
  if (s.kind == SignalKind::kFuzzy && s.inputs.empty() && !refused("inputs"))
    findings.error(s.source, "inputs", "are missing; expected one expression per input variable of the file");
}

void check_states(const Scene& scene, Findings& findings) {
  check_unique_names(scene.states, "state", findings);
  check_unique_names(scene.events, "event", findings);
  for (const StateSpec& state : scene.states)
    if (state.name == "since")
      findings.error(state.source, "name", "\"since\" means the time in the present state; choose another name");
  if (scene.states.size() == 1)
    findings.error(scene.states[0].source, "", "is the only state; expected another one that an event goes to");
  for (const EventSpec& event : scene.events) {
    check_expression(scene, event.source, "when", event.when, findings);
    if (!event.to.empty() && scene.states.empty()) {
      findings.error(event.source, "to", "names a state, but there are no [[states]]; list them, the first one first");
      continue;
    }
    check_state_name(scene, event.source, "to", event.to, findings);
    for (const std::string& state : event.from) check_state_name(scene, event.source, "from", state, findings);
    if (holds(event.from, event.to))
      findings.error(event.source, "from", "holds \"" + event.to + "\", to which the event goes; leave it out");
  }
}

}  // namespace

void check_signal_name(const Scene& scene, const Source& source, const std::string& key, const std::string& name,
                       Findings& findings) {
  const std::vector<std::string> signals = names_in(scene.signals);
  if (name.empty() || holds(signals, name)) return;
  findings.error(source, key, "unknown signal \"" + name + "\"." + known_names("signals", name, signals));
}

void check_signals(const Scene& scene, Findings& findings) {
  check_unique_names(scene.signals, "signal", findings);
  for (const SignalSpec& signal : scene.signals)
    if (signal.source.good("kind")) check_signal(scene, signal, findings);
  check_states(scene, findings);
}

}  // namespace footfall
