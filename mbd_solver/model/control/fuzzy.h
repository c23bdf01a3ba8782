#pragma once

#include <Eigen/Dense>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace footfall {

// The lines of a FuzzyLite (.fll) file, without comments.
struct FllLine {
  int number;         // in the file, from 1
  std::string key;    // left of the colon
  std::string value;  // right of it
};
struct FllBlock {
  FllLine head;  // InputVariable: name, OutputVariable: name, RuleBlock: name or Engine: name
  std::vector<FllLine> lines;
};
struct FllText {
  std::string file;  // its name, for messages
  std::vector<FllBlock> blocks;
};

// The fuzzy system of a controller: described by a FuzzyLite (.fll) file and evaluated by FuzzyLite [Lin25 section 2.2.2]. It
// has no time, filter or memory.
//
// Required content of the file, else InputError "file:line: ...":
//
//   inputs   a      upward acceleration of the body          [g, 9.80665 m/s2]   range [0, a_max]
//            da     its rate, change per 0.1 s (kJerkTime)   [g]                 range [-r, r]
//            alpha  pitch, positive when the +x legs sink    [degree]            range [-r, r]
//            beta   roll, positive when the +y legs sink     [degree]            range [-r, r]
//   outputs  U1 ... Un, range [0, 1], lock-previous false (its hidden memory cannot be saved)
//   rules    with known variables and terms, which cover the whole input box
//
// Coverage is checked at construction, at all corners of the terms and half way between them, which is complete for
// terms with corners (triangle, trapezoid, ramp, rectangle). Inputs outside their range are clamped. If no rule fires
// although the check passed (terms of other shapes), or an input is NaN, the output is kNoRuleVoltage.

constexpr double kStandardGravity = 9.80665;  // [m/s2]
constexpr double kJerkTime = 0.1;             // the jerk input is the change of a in this time [s]
constexpr double kNoRuleVoltage = 0.5;        // [-]

constexpr int kFuzzyInputs = 4;
using FuzzyInput = std::array<double, kFuzzyInputs>;  // a [g], da [g per kJerkTime], alpha [deg], beta [deg]
constexpr std::array<const char*, kFuzzyInputs> kFuzzyInputNames = {"a", "da", "alpha", "beta"};

class FuzzySystem {
 public:
  explicit FuzzySystem(const FllText& text);  // throws InputError
  ~FuzzySystem();
  FuzzySystem(FuzzySystem&&) noexcept;
  FuzzySystem& operator=(FuzzySystem&&) noexcept;

  int output_count() const;
  const FuzzyInput& lower() const;  // of the input ranges, units as FuzzyInput
  const FuzzyInput& upper() const;
  // The ends of an input's range and the corners of its terms, rising: there the outputs have kinks.
  std::vector<double> breakpoints(int input) const;
  // FuzzyLite's own evaluation: output_count() damper inputs in [0, 1].
  void evaluate(const FuzzyInput& input, Eigen::Ref<Eigen::VectorXd> voltages) const;
  // The same at all points of a grid, to round-off: [a][da][alpha][beta][output]. Fast for plain min/max/centroid systems
  // (fuzzy_table.h), point by point for all others.
  std::vector<double> evaluate_on_grid(const std::array<Eigen::VectorXd, kFuzzyInputs>& nodes) const;

 private:
  struct Engine;  // FuzzyLite's, which stores its last values: one thread at a time
  std::unique_ptr<Engine> engine_;
};

// One output of a FuzzyLite file (.fll) over any inputs, in the units of the file. Inputs outside their range are clamped.
// No memory: lock-previous must be false.
class FuzzyFunction {
 public:
  // inputs: their number, in the order of the file's input variables. output: name of an output variable; empty: the only
  // one. Throws InputError "file:line: ...".
  FuzzyFunction(const FllText& text, std::size_t inputs, const std::string& output);
  FuzzyFunction(const FuzzyFunction& other);  // with its own engine
  FuzzyFunction& operator=(const FuzzyFunction&) = delete;
  ~FuzzyFunction();

  // Throws NumericalError if no rule fires.
  double value(const Eigen::Ref<const Eigen::VectorXd>& inputs) const;

 private:
  struct Parts;  // FuzzyLite's engine stores its last values: one thread at a time
  std::unique_ptr<Parts> parts_;
};

}  // namespace footfall
