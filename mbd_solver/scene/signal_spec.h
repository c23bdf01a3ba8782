#pragma once
// Signals, states and events of a scene: what is measured and computed during a run.

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/model/control/signal_blocks.h"
#include "mbd_solver/scene/source.h"

namespace footfall {

enum class SignalKind {
  kExpression,  // the input itself
  kPid,
  kLowpass,   // first order
  kLowpass2,  // second order
  kNotch,
  kRateLimit,
  kSaturation,
  kTable,   // over one input
  kTable2,  // over two
  kFuzzy    // rules of a FuzzyLite file, over any inputs
};
constexpr std::string_view name_of(SignalKind kind) {
  return name_in(kind, "expression", "pid", "lowpass", "lowpass2", "notch", "rate_limit", "saturation", "table",
                 "table2", "fuzzy");
}

// Inherited: period [s] of every kind (0: continuous); min, max of pid and saturation; the rest of pid, whose error e is the
// input. Units are those of what an expression reads; none is converted.
struct SignalSpec : PidBlockParameters {
  Source source;
  std::string name;
  SignalKind kind = SignalKind::kExpression;
  std::string input;                // expression of history columns, "signal.NAME", "state.NAME", "time"
  std::vector<std::string> states;  // outside of these it is 0, and it restarts when one begins; empty: always active
  std::optional<double> initial;    // filters, rate limit: input before the start; not given: that of the start
  std::string rate;                 // pid: expression for e'; not given: e is filtered and differentiated
  double frequency = 0.0;           // of a filter [Hz] > 0
  double damping = 0.7;             // of a filter of second order [-] > 0
  double max_rate = 0.0;            // [unit/s] > 0
  std::vector<Eigen::Vector2d> points;  // table: (input, value), inputs rising
  std::string input2;                   // table2: the second input
  std::vector<double> x, x2;            // table2: where the inputs have values, rising
  std::vector<double> values;           // table2: for x[0] at all x2, then for x[1] ...
  std::string file;                     // fuzzy: .fll
  std::vector<std::string> inputs;      // fuzzy: expressions, in the order of the file's input variables
  std::string output;                   // fuzzy: which output variable; not given: the only one
};

// The scene is in one of its states at any time, in the first of them at the start.
struct StateSpec {
  Source source;
  std::string name;
};

// The scene changes to another state when a condition holds.
struct EventSpec {
  Source source;
  std::string name;
  std::vector<std::string> from;  // states in which the condition is watched; empty: all but `to`
  std::string when;               // logical expression
  std::string to;
  double period = 0.0;  // the condition is evaluated at its multiples [s]; 0: continuously, and its instant is located
};

}  // namespace footfall
