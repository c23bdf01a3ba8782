#pragma once

#include <Eigen/Dense>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace footfall {

// A fuzzy system read from a FuzzyLite (.fll) file and evaluated by FuzzyLite [Lin25 section 2.2.2];
// fuzzy_engine.h is the door to the library. No time, filter or memory here: those are the
// FuzzyController's.
//
// What the file must hold, else InputError "file:line: ...":
//
//   inputs   a      upward acceleration of the body          [g, 9.80665 m/s2]   range [0, a_max]
//            da     its rate, change per 0.1 s (kJerkTime)   [g]                 range [-r, r]
//            alpha  pitch, positive when the +x legs sink    [degree]            range [-r, r]
//            beta   roll, positive when the +y legs sink     [degree]            range [-r, r]
//   outputs  U1 ... Un, range [0, 1], lock-previous false (a hidden memory could not be resumed)
//   rules    that name known variables and terms and cover the whole input box
//
// Coverage is checked when loading, at all corners of the terms and half way between them, which is complete
// for terms with corners (triangle, trapezoid, ramp, rectangle).
// Inputs outside their range are clamped to it. Where no rule fires for an output although the check passed
// (terms of other shapes), or an input is not a number, the output is kNoRuleVoltage.

constexpr double kStandardGravity = 9.80665;  // [m/s2]
constexpr double kJerkTime = 0.1;             // the jerk input is the change of a in this time [s]
constexpr double kNoRuleVoltage = 0.5;        // [-]

constexpr int kFuzzyInputs = 4;
using FuzzyInput = std::array<double, kFuzzyInputs>;  // a [g], da [g per kJerkTime], alpha [deg], beta [deg]
constexpr std::array<const char*, kFuzzyInputs> kFuzzyInputNames = {"a", "da", "alpha", "beta"};

class FuzzySystem {
 public:
  explicit FuzzySystem(const std::filesystem::path& file);  // throws InputError
  ~FuzzySystem();
  FuzzySystem(FuzzySystem&&) noexcept;
  FuzzySystem& operator=(FuzzySystem&&) noexcept;

  int output_count() const;
  const FuzzyInput& lower() const;  // of the input ranges, units as FuzzyInput
  const FuzzyInput& upper() const;
  // The ends of an input's range and, rising between them, the corners of its terms: there the voltages have
  // kinks.
  std::vector<double> breakpoints(int input) const;
  // FuzzyLite's own evaluation: output_count() voltages in [0, 1].
  void evaluate(const FuzzyInput& input, Eigen::Ref<Eigen::VectorXd> voltages) const;
  // The same at all points of a grid: [a][da][alpha][beta][output]; to round-off. Fast for plain
  // min/max/centroid systems (mamdani_grid.h), point by point for all others.
  std::vector<double> evaluate_on_grid(const std::array<Eigen::VectorXd, kFuzzyInputs>& nodes) const;

 private:
  struct Engine;  // FuzzyLite's, which keeps its last values inside: one thread at a time
  std::unique_ptr<Engine> engine_;
};

// One output of a FuzzyLite file (.fll) over any inputs, in the units of the file. Inputs outside their range are cut to
// it. No memory: lock-previous must be false.

class FuzzyFunction {
 public:
  // inputs: how many there shall be, in the order of the file's input variables. output: name of an output variable;
  // empty: the only one. Throws InputError "file:line: ...".
  FuzzyFunction(const std::filesystem::path& file, std::size_t inputs, const std::string& output);
  ~FuzzyFunction();

  // Throws NumericalError where no rule fires.
  double value(const Eigen::Ref<const Eigen::VectorXd>& inputs) const;

 private:
  struct Parts;  // FuzzyLite's engine keeps its last values inside: one thread at a time
  std::unique_ptr<Parts> parts_;
};

}  // namespace footfall
