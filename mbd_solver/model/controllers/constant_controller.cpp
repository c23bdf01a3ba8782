#include "mbd_solver/model/controllers/constant_controller.h"

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"

namespace footfall {

ConstantController::ConstantController(const ConstantControllerParameters& parameters) : parameters_(parameters) {
  const std::string who = "controller constant";
  require_positive(who, "period", parameters.period, "s");
  if (parameters.voltages.size() == 0) throw InputError(who + ": no voltages; expected one for each controlled strut.");
  for (Eigen::Index i = 0; i < parameters.voltages.size(); ++i)
    require_within(who, "voltage " + std::to_string(i + 1), parameters.voltages[i], 0.0, 1.0, "");
}

void ConstantController::sample(const ControllerMeasurement&, Eigen::Ref<Eigen::VectorXd> voltages) {
  voltages = parameters_.voltages;
}

void ConstantController::restore(const Eigen::Ref<const Eigen::VectorXd>& memory) {
  FOOTFALL_DEMAND(memory.size() == 0);
}

}  // namespace footfall
