#include "mbd_solver/model/controllers/fuzzy_controller.h"

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"

namespace footfall {

FuzzyController::FuzzyController(const FuzzyControllerParameters& parameters)
    : parameters_(parameters),
      system_(parameters.file),
      filter_("controller fuzzy", parameters.filter_frequency, parameters.period) {
  if (!parameters.tabulated) return;
  table_.emplace(system_, parameters.grid);
  table_difference_ = table_->largest_difference(system_);
}

void FuzzyController::sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) {
  constexpr double kDegree = 180.0 / kPi;
  filter_.sample(m.acceleration);
  const FuzzyInput input = {filter_.acceleration() / kStandardGravity, filter_.jerk() * kJerkTime / kStandardGravity,
                            m.pitch * kDegree, m.roll * kDegree};
  if (table_)
    table_->evaluate(input, voltages);
  else
    system_.evaluate(input, voltages);
}

Eigen::VectorXd FuzzyController::memory() const {
  Eigen::VectorXd memory(AccelerationFilter::kMemory);
  filter_.save(memory);
  return memory;
}

void FuzzyController::restore(const Eigen::Ref<const Eigen::VectorXd>& memory) { filter_.restore(memory); }

}  // namespace footfall
