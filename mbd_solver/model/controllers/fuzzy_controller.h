#pragma once
// The fuzzy controller in the controller slot: filters the measured acceleration, forms the jerk, turns
// everything into the units of the .fll file (fuzzy.h) and evaluates it, exactly or by its table.

#include <memory>
#include <optional>

#include "mbd_solver/model/controllers/acceleration_filter.h"
#include "mbd_solver/model/controllers/controller.h"
#include "mbd_solver/model/controllers/fuzzy_table.h"

namespace footfall {

struct FuzzyControllerParameters {
  std::filesystem::path file;                         // the .fll file
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

  // Largest difference of the table to the exact controller, found when it was built; nothing if not
  // tabulated.
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
