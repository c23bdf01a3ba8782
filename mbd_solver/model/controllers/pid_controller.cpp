#include "mbd_solver/model/controllers/pid_controller.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"

namespace footfall {
namespace {

constexpr std::string_view kWho = "controller pid";

}  // namespace

PidController::PidController(const PidControllerParameters& p)
    : parameters_(p), filter_(kWho, p.filter_frequency, p.period) {
  require_positive(kWho, "outputs", p.outputs, "");
  require_positive(kWho, "set_point", p.set_point, "m/s2");
  require_not_negative(kWho, "kp", p.kp, "s2/m");
  require_not_negative(kWho, "ki", p.ki, "s/m");
  require_not_negative(kWho, "kd", p.kd, "s3/m");
  require_within(kWho, "bias", p.bias, 0.0, 1.0, "");
}

void PidController::sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) {
  FOOTFALL_DEMAND(voltages.size() == parameters_.outputs);
  const PidControllerParameters& p = parameters_;
  filter_.sample(m.acceleration);
  const double error = p.set_point - filter_.acceleration();
  const auto wanted = [&](double integral) { return p.bias + p.kp * error + p.ki * integral - p.kd * filter_.jerk(); };
  // The integral takes this sample's error unless that only drives a saturated U further, or the body does
  // not brake.
  const double next = integral_ + error * p.period;
  const double trial = wanted(next);
  const bool winds_up = (trial > 1.0 && error > 0.0) || (trial < 0.0 && error < 0.0);
  if (!winds_up && filter_.acceleration() > 0.0) integral_ = next;
  voltages.setConstant(std::clamp(wanted(integral_), 0.0, 1.0));
}

Eigen::VectorXd PidController::memory() const {
  Eigen::VectorXd memory(AccelerationFilter::kMemory + 1);
  filter_.save(memory.head(AccelerationFilter::kMemory));
  memory[AccelerationFilter::kMemory] = integral_;
  return memory;
}

void PidController::restore(const Eigen::Ref<const Eigen::VectorXd>& memory) {
  FOOTFALL_DEMAND(memory.size() == AccelerationFilter::kMemory + 1);
  filter_.restore(memory.head(AccelerationFilter::kMemory));
  integral_ = memory[AccelerationFilter::kMemory];
}

}  // namespace footfall
