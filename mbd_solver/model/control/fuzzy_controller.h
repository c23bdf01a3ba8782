#pragma once
// The fuzzy controller, and control surfaces of its rules.

#include <optional>
#include <string_view>

#include "mbd_solver/model/control/controllers.h"
#include "mbd_solver/model/control/fuzzy.h"
#include "mbd_solver/model/control/fuzzy_table.h"

namespace footfall {

// A control surface: one output of a fuzzy system over two of its inputs, the other two held, as in [Lin25 Figure 4].
struct ControlSurface {
  Eigen::VectorXd first;    // values of the first input, in its unit (fuzzy.h)
  Eigen::VectorXd second;   // values of the second input
  Eigen::MatrixXd voltage;  // first x second [-]
};

// output: 0 for U1. first, second: names of two different inputs ("a", "da", "alpha", "beta"), each over its whole range on
// `points` points. held: the values of the other two inputs. Throws InputError for an unknown name or output.
ControlSurface control_surface(const FuzzySystem& system, int output, std::string_view first, std::string_view second,
                               int points = 41, const FuzzyInput& held = {0.0, 0.0, 0.0, 0.0});

// Filters the measured acceleration, forms the jerk, converts to the units of the .fll file (fuzzy.h) and evaluates the
// rules, exactly or by a table.
struct FuzzyControllerParameters {
  FllText rules;
  double period = kDefaultControllerPeriod;           // > 0 [s]
  double filter_frequency = kDefaultFilterFrequency;  // corner of the acceleration filter, 0 = none [Hz]
  bool tabulated = false;                             // true: compute on `grid` at the start, then interpolate
  FuzzyGrid grid = kDefaultFuzzyGrid;                 // used when tabulated
};

class FuzzyController final : public Controller {
 public:
  explicit FuzzyController(const FuzzyControllerParameters& parameters);  // throws InputError

  std::string_view kind() const override { return "fuzzy"; }
  int output_count() const override { return system_.output_count(); }
  double period() const override { return parameters_.period; }
  void sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) override;
  Eigen::VectorXd memory() const override;
  void restore(const Eigen::Ref<const Eigen::VectorXd>& memory) override;

  // Largest difference between the table and the exact rules, at construction; empty if not tabulated.
  std::optional<double> table_difference() const { return table_difference_; }
  const FuzzySystem& system() const { return system_; }

 private:
  FuzzyControllerParameters parameters_;
  FuzzySystem system_;
  AccelerationFilter filter_;
  std::optional<FuzzyTable> table_;
  std::optional<double> table_difference_;
};

}  // namespace footfall
