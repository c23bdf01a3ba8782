#include "mbd_solver/model/controllers/skyhook_controller.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"

namespace footfall {

SkyhookController::SkyhookController(const SkyhookControllerParameters& p) : parameters_(p) {
  constexpr std::string_view kWho = "controller skyhook";
  require_positive(kWho, "outputs", p.outputs, "");
  require_positive(kWho, "period", p.period, "s");
  require_within(kWho, "on", p.on, 0.0, 1.0, "");
  require_within(kWho, "off", p.off, 0.0, p.on, "");
  require_not_negative(kWho, "deadband", p.deadband, "m/s");
  held_ = Eigen::VectorXd::Constant(p.outputs, p.off);
}

void SkyhookController::sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) {
  FOOTFALL_DEMAND(m.strut_rate.size() == held_.size());
  for (Eigen::Index i = 0; i < held_.size(); ++i) {
    const double rate = m.strut_rate[i];
    // Written so that a rate or velocity that is not a number keeps the held value too.
    if (!(std::abs(rate) > parameters_.deadband && std::abs(m.velocity) > parameters_.deadband)) continue;
    held_[i] = m.velocity * rate < 0.0 ? parameters_.on : parameters_.off;
  }
  voltages = held_;
}

void SkyhookController::restore(const Eigen::Ref<const Eigen::VectorXd>& memory) {
  FOOTFALL_DEMAND(memory.size() == held_.size());
  held_ = memory;
}

}  // namespace footfall
