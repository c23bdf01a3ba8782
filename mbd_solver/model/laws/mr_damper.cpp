#include "mbd_solver/model/laws/mr_damper.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

double clamp_voltage(double u) { return std::clamp(u, 0.0, 1.0); }

MonotoneCurve checked_table(const std::vector<YieldPoint>& table) {
  std::vector<double> u, f;
  for (const YieldPoint& p : table) {
    u.push_back(p.voltage);
    f.push_back(p.force);
  }
  MonotoneCurve curve("mr_damper: yield_table", u, f);
  if (u.front() != 0.0 || u.back() != 1.0)
    throw InputError("mr_damper: yield_table covers U from " + number_text(u.front()) + " to " + number_text(u.back()) +
                     "; expected from 0 to 1 exactly.");
  require_not_negative("mr_damper", "the first force of yield_table", f.front(), "N");
  for (std::size_t i = 1; i < f.size(); ++i)
    if (f[i] < f[i - 1])
      throw InputError("mr_damper: yield_table falls from " + number_text(f[i - 1]) +
                       " N at U = " + number_text(u[i - 1]) + " to " + number_text(f[i]) +
                       " N at U = " + number_text(u[i]) + "; expected a force that never falls with U.");
  return curve;
}

}  // namespace

MrDamper::MrDamper(const MrDamperParameters& parameters) : parameters_(parameters) {
  require_not_negative(kind(), "yield_force", parameters.yield_force, "N");
  require_not_negative(kind(), "viscous_coefficient", parameters.viscous_coefficient, "N s/m");
  require_positive(kind(), "regularisation_speed", parameters.regularisation_speed, "m/s");
  require_not_negative(kind(), "coil_lag", parameters.coil_lag, "s");
  require_within(kind(), "initial_voltage", parameters.initial_voltage, 0.0, 1.0, "");
  if (!parameters.yield_table.empty()) table_ = checked_table(parameters.yield_table);
}

Eigen::VectorXd MrDamper::initial_state() const {
  return Eigen::VectorXd::Constant(state_count(), parameters_.initial_voltage);
}

double MrDamper::effective_voltage(const StrutInput& in) const {
  return clamp_voltage(state_count() == 1 ? in.z[0] : in.voltage);
}

double MrDamper::yield_force(double voltage) const {
  return table_ ? table_->value(clamp_voltage(voltage)) : clamp_voltage(voltage) * parameters_.yield_force;
}

double MrDamper::yield_slope(double voltage) const {
  if (voltage < 0.0 || voltage > 1.0) return 0.0;
  return table_ ? table_->slope(voltage) : parameters_.yield_force;
}

void MrDamper::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  const double c = parameters_.viscous_coefficient, v_s = parameters_.regularisation_speed;
  const double s = std::tanh(in.rate / v_s);
  const double f_y = yield_force(effective_voltage(in));
  out.force = f_y * s + c * in.rate;
  out.dforce_drate = f_y * (1.0 - s * s) / v_s + c;
  if (state_count() == 1) {
    out.dforce_dz[0] = yield_slope(in.z[0]) * s;
    out.dz[0] = (clamp_voltage(in.voltage) - in.z[0]) / parameters_.coil_lag;
    out.ddz_dz(0, 0) = -1.0 / parameters_.coil_lag;
  }
}

void MrDamper::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  const double v = in.rate;
  out.push_back({Dissipation::kMrViscous, parameters_.viscous_coefficient * v * v});
  out.push_back({Dissipation::kMrYield,
                 yield_force(effective_voltage(in)) * std::tanh(v / parameters_.regularisation_speed) * v});
}

}  // namespace footfall
