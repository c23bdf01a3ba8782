#include "mbd_solver/model/signals/pid_block.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"
#include "coupler/base/pi.h"

namespace footfall {

PidBlock::PidBlock(const PidBlockParameters& parameters)
    : parameters_(parameters), w_(2.0 * kPi * parameters.derivative_frequency) {
  const PidBlockParameters& p = parameters_;
  require_not_negative("pid", "kp", p.kp, "");
  require_not_negative("pid", "ki", p.ki, "");
  require_not_negative("pid", "kd", p.kd, "");
  require_not_negative("pid", "derivative_frequency", p.derivative_frequency, "Hz");
  if (p.min && p.max && !(*p.min < *p.max)) throw InputError("pid: min is not below max.");
  if ((p.min || p.max) && p.ki > 0.0 && !(p.kp > 0.0))
    throw InputError("pid: ki with limits needs kp; the integral is held back by what is cut off, over kp.");
  if (has_rate() && p.period == 0.0 && w_ == 0.0)
    throw InputError("pid: kd without derivative_frequency; a continuous pid needs it, or the rate, or a period.");
}

double PidBlock::asked_for(const BlockValues& u, const BlockValues& z) const {
  const PidBlockParameters& p = parameters_;
  double v = p.bias + p.kp * u[0];
  if (has_integral()) v += p.ki * z[0];
  if (p.kd > 0.0) {
    const double gain = w_ > 0.0 ? w_ : 1.0 / p.period;
    v += p.kd * (p.rate_is_given ? u[1] : gain * (u[0] - z[z.size() - 1]));
  }
  return v;
}

double PidBlock::limited(double v) const {
  if (parameters_.min) v = std::max(v, *parameters_.min);
  if (parameters_.max) v = std::min(v, *parameters_.max);
  return v;
}

double PidBlock::integral_rate(const BlockValues& u, const BlockValues& z) const {
  const double v = asked_for(u, z), cut = limited(v) - v;
  return cut == 0.0 ? u[0] : u[0] + cut / parameters_.kp;
}

void PidBlock::settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const {
  z.setZero();
  if (has_rate()) z[z.size() - 1] = u[0];
}

double PidBlock::value(const BlockValues& u, const BlockValues& z) const { return limited(asked_for(u, z)); }

void PidBlock::rates(const BlockValues& u, const BlockValues& z, Eigen::Ref<Eigen::VectorXd> dz) const {
  if (has_rate()) dz[dz.size() - 1] = w_ * (u[0] - z[z.size() - 1]);
  if (has_integral()) dz[0] = integral_rate(u, z);
}

void PidBlock::advance(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const {
  if (has_integral()) z[0] += period * integral_rate(u, z);
  if (!has_rate()) return;
  double& filtered = z[z.size() - 1];
  filtered = w_ > 0.0 ? filtered - std::expm1(-w_ * period) * (u[0] - filtered) : u[0];
}

}  // namespace footfall
