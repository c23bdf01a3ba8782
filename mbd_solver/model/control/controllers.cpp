// The filter, and the three controllers without fuzzy rules.

#include "mbd_solver/model/control/controllers.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

constexpr std::string_view kPid = "controller pid", kSkyhook = "controller skyhook";

}  // namespace

AccelerationFilter::AccelerationFilter(std::string_view owner, double frequency, double period) : period_(period) {
  require_not_negative(owner, "filter_frequency", frequency, "Hz");
  require_positive(owner, "period", period, "s");
  gain_ = frequency > 0.0 ? -std::expm1(-2.0 * kPi * frequency * period) : 1.0;
}

void AccelerationFilter::sample(double acceleration) {
  const double before = started_ ? filtered_ : acceleration;
  filtered_ = before + gain_ * (acceleration - before);
  jerk_ = (filtered_ - before) / period_;
  started_ = true;
}

void AccelerationFilter::save(Eigen::Ref<Eigen::VectorXd> memory) const {
  FOOTFALL_DEMAND(memory.size() == kMemory);
  memory << (started_ ? 1.0 : 0.0), filtered_, jerk_;
}

void AccelerationFilter::restore(const Eigen::Ref<const Eigen::VectorXd>& memory) {
  FOOTFALL_DEMAND(memory.size() == kMemory);
  started_ = memory[0] != 0.0;
  filtered_ = memory[1];
  jerk_ = memory[2];
}

ConstantController::ConstantController(const ConstantControllerParameters& parameters) : parameters_(parameters) {
  const std::string who = "controller constant";
  require_positive(who, "period", parameters.period, "s");
  if (parameters.voltages.size() == 0)
    throw InputError(code::kParametersDisagree, who + ": no voltages; expected one for each controlled strut.");
  for (Eigen::Index i = 0; i < parameters.voltages.size(); ++i)
    require_within(who, "voltage " + std::to_string(i + 1), parameters.voltages[i], 0.0, 1.0, "");
}

void ConstantController::sample(const ControllerMeasurement&, Eigen::Ref<Eigen::VectorXd> voltages) {
  voltages = parameters_.voltages;
}

void ConstantController::restore(const Eigen::Ref<const Eigen::VectorXd>& memory) {
  FOOTFALL_DEMAND(memory.size() == 0);
}

PidController::PidController(const PidControllerParameters& p)
    : parameters_(p), filter_(kPid, p.filter_frequency, p.period) {
  require_positive(kPid, "outputs", p.outputs, "");
  require_positive(kPid, "set_point", p.set_point, "m/s2");
  require_not_negative(kPid, "kp", p.kp, "s2/m");
  require_not_negative(kPid, "ki", p.ki, "s/m");
  require_not_negative(kPid, "kd", p.kd, "s3/m");
  require_within(kPid, "bias", p.bias, 0.0, 1.0, "");
}

void PidController::sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) {
  FOOTFALL_DEMAND(voltages.size() == parameters_.outputs);
  const PidControllerParameters& p = parameters_;
  filter_.sample(m.acceleration);
  const double error = p.set_point - filter_.acceleration();
  const auto required = [&](double integral) {
    return p.bias + p.kp * error + p.ki * integral - p.kd * filter_.jerk();
  };
  // The integral adds this error unless U is saturated in its direction, or the body does not decelerate.
  const double next = integral_ + error * p.period;
  const double trial = required(next);
  const bool winds_up = (trial > 1.0 && error > 0.0) || (trial < 0.0 && error < 0.0);
  if (!winds_up && filter_.acceleration() > 0.0) integral_ = next;
  voltages.setConstant(std::clamp(required(integral_), 0.0, 1.0));
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

SkyhookController::SkyhookController(const SkyhookControllerParameters& p) : parameters_(p) {
  require_positive(kSkyhook, "outputs", p.outputs, "");
  require_positive(kSkyhook, "period", p.period, "s");
  require_within(kSkyhook, "on", p.on, 0.0, 1.0, "");
  require_within(kSkyhook, "off", p.off, 0.0, p.on, "");
  require_not_negative(kSkyhook, "deadband", p.deadband, "m/s");
  held_ = Eigen::VectorXd::Constant(p.outputs, p.off);
}

void SkyhookController::sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) {
  FOOTFALL_DEMAND(m.strut_rate.size() == held_.size());
  for (Eigen::Index i = 0; i < held_.size(); ++i) {
    const double rate = m.strut_rate[i];
    // Written so that NaN keeps the held value.
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
