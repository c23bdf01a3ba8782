// Signals, states and events.
#include "coupler/base/text.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;
namespace {

// "signal.pitch" with the prefix "signal.": "pitch".
bool cut_prefix(const std::string& text, const std::string& prefix, std::string& rest) {
  if (text.rfind(prefix, 0) != 0) return false;
  rest = text.substr(prefix.size());
  return true;
}

void check_state_name(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& name) {
  check_known(at, kUnknownState, key, "state", "states", name, names_in(scene.states));
}

// It can be read, and the signals and states that it names exist. Columns are known when the mechanism is built.
void check_expression(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& text) {
  if (text.empty()) return;
  try {
    for (const std::string& name : Expression::names_in(text)) {
      std::string rest;
      if (cut_prefix(name, "signal.", rest)) check_signal_name(scene, at, key, rest);
      if (name == "state.since") {
        at.error_if(scene.states.empty(), kUnknownState, key,
                    "uses state.since, but there are no [[states]]; add them");
      } else if (cut_prefix(name, "state.", rest)) {
        check_state_name(scene, at, key, rest);
      }
    }
  } catch (const InputError& error) {
    at.all().coded_error(at.source(), key, error.what());
  }
}

bool is_filter(SignalKind kind) {
  return kind == SignalKind::kLowpass || kind == SignalKind::kLowpass2 || kind == SignalKind::kNotch;
}

void check_rising(const EntryFindings& at, const std::string& key, const std::vector<double>& x) {
  at.error_if(x.size() < 2, kWrongCount, key, "has fewer than two values, expected at least two, rising");
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] > x[i - 1]) continue;
    at.error(kNotRising, key,
             "has " + number_text(x[i]) + " after " + number_text(x[i - 1]) + ", expected rising values");
    return;
  }
}

void check_limits_of(const SignalSpec& s, const EntryFindings& at) {
  if (s.min && s.max) check_min_below_max(at, "", *s.min, *s.max, Unit::kNone);
  at.error_if(s.kind == SignalKind::kSaturation && !s.min && !s.max, kEmptyEntry, "",
              "limits nothing; give min, max or both");
  if (s.kind != SignalKind::kPid) return;
  at.missing_if(s.kp == 0.0 && s.ki == 0.0 && s.kd == 0.0, "kp", "give at least one of kp, ki, kd");
  at.error_if((s.min || s.max) && s.ki > 0.0 && s.kp == 0.0, kNeedsOtherKey, "kp",
              "is missing; a limited pid with ki needs kp > 0, which scales the correction of its integral");
  at.error_if(s.kd > 0.0 && s.rate.empty() && s.derivative_frequency == 0.0 && s.period == 0.0, kNeedsOtherKey,
              "derivative_frequency",
              "is missing; a continuous pid with kd needs it (Hz), or rate = \"...\", the input's derivative");
  at.error_if(!s.rate.empty() && s.kd == 0.0, kNeedsOtherKey, "rate", "has no effect without kd; add kd");
}

void check_table(const SignalSpec& s, const EntryFindings& at) {
  const auto refused = [&](const char* key) { return s.source.refused.count(key) > 0; };
  if (s.kind == SignalKind::kTable && !refused("points")) {
    std::vector<double> x;
    for (const Eigen::Vector2d& point : s.points) x.push_back(point.x());
    check_rising(at, "points", x);
  }
  if (s.kind != SignalKind::kTable2 || refused("x") || refused("x2") || refused("input2") || refused("values")) return;
  check_rising(at, "x", s.x);
  check_rising(at, "x2", s.x2);
  at.missing_if(s.input2.empty(), "input2", "this kind of signal has two inputs");
  at.error_if(s.values.size() != s.x.size() * s.x2.size(), kWrongCount, "values",
              "contains " + std::to_string(s.values.size()) + " numbers, expected one for each pair of x and x2 (" +
                  std::to_string(s.x.size() * s.x2.size()) + ")");
}

void check_signal(const Scene& scene, const SignalSpec& s, const EntryFindings& at) {
  check_kind_keys(at, s.kind, "signal");
  for (const auto& [key, text] : {std::pair("input", &s.input), {"input2", &s.input2}, {"rate", &s.rate}})
    check_expression(scene, at, key, *text);
  for (const std::string& input : s.inputs) check_expression(scene, at, "inputs", input);
  for (const std::string& state : s.states) check_state_name(scene, at, "states", state);
  check_limits_of(s, at);
  check_table(s, at);
  // needs(condition, key, why): a key that this kind cannot do without; refused values are reported already.
  const auto needs = [&](bool missing, const std::string& key, const std::string& why) {
    if (missing && s.source.refused.count(key) == 0)
      at.error(kMissingKey, key, (at.given(key) ? "is 0; " : "is missing; ") + why);
  };
  const bool fuzzy = s.kind == SignalKind::kFuzzy, rate_limit = s.kind == SignalKind::kRateLimit;
  needs(!fuzzy && s.input.empty(), "input", "expected an expression such as \"0.3 - knee.angle\"");
  needs(is_filter(s.kind) && !(s.frequency > 0.0), "frequency", "a filter needs it (Hz), expected more than 0");
  needs(rate_limit && !(s.max_rate > 0.0), "max_rate", "expected more than 0, per second");
  needs(rate_limit && s.period == 0.0, "period", "a rate limit is sampled, for example period_ms = 1");
  needs(fuzzy && s.file.empty(), "file", "a fuzzy signal is read from an .fll file");
  needs(fuzzy && s.inputs.empty(), "inputs", "expected one expression per input variable of the file");
}

void check_states(const Scene& scene, Findings& findings) {
  check_unique_names(scene.states, "state", findings);
  check_unique_names(scene.events, "event", findings);
  for (const StateSpec& state : scene.states)
    if (state.name == "since")
      findings.error(kReservedName, state.source, "name",
                     "\"since\" is the time in the present state; choose another name");
  if (scene.states.size() == 1)
    findings.error(kWrongCount, scene.states[0].source, "",
                   "is the only state, expected another one that an event changes to");
  for (const EventSpec& event : scene.events) {
    const EntryFindings at(findings, event.source);
    check_expression(scene, at, "when", event.when);
    if (!event.to.empty() && scene.states.empty()) {
      at.error(kUnknownState, "to", "names a state, but there are no [[states]]; list them, the initial one first");
      continue;
    }
    check_state_name(scene, at, "to", event.to);
    for (const std::string& state : event.from) check_state_name(scene, at, "from", state);
    at.error_if(is_in(event.from, event.to), kListedTwice, "from",
                "contains \"" + event.to + "\", to which the event changes; remove it");
  }
}

}  // namespace

void check_signals(const Scene& scene, Findings& findings) {
  check_unique_names(scene.signals, "signal", findings);
  for (const SignalSpec& signal : scene.signals)
    if (signal.source.good("kind")) check_signal(scene, signal, {findings, signal.source});
  check_states(scene, findings);
}

}  // namespace footfall
