#pragma once
// Constant voltages: the passive strut that every comparison needs.

#include "mbd_solver/model/controllers/controller.h"

namespace footfall {

struct ConstantControllerParameters {
  Eigen::VectorXd voltages;                  // one per controlled strut, each in [0, 1] [-]; at least one
  double period = kDefaultControllerPeriod;  // > 0 [s]
};

class ConstantController final : public Controller {
 public:
  explicit ConstantController(const ConstantControllerParameters& parameters);  // throws InputError

  std::string_view kind() const override { return "constant"; }
  int output_count() const override { return static_cast<int>(parameters_.voltages.size()); }
  double period() const override { return parameters_.period; }
  void sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) override;
  Eigen::VectorXd memory() const override { return {}; }
  void restore(const Eigen::Ref<const Eigen::VectorXd>& memory) override;

 private:
  ConstantControllerParameters parameters_;
};

}  // namespace footfall
