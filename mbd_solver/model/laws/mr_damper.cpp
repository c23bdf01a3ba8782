// A smooth Bingham model, its coil lag, and the formulas that give its two forces from the geometry of the damper.

#include "mbd_solver/model/laws/mr_damper.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

double clamp_voltage(double u) { return std::clamp(u, 0.0, 1.0); }

MonotoneCurve checked_table(const std::vector<Eigen::Vector2d>& table) {
  std::vector<double> u, f;
  for (const Eigen::Vector2d& p : table) {
    u.push_back(p.x());
    f.push_back(p.y());
  }
  MonotoneCurve curve("mr_damper: yield_table", u, f);
  if (u.front() != 0.0 || u.back() != 1.0)
    throw InputError(code::kTableShape, "mr_damper: yield_table covers U from " + number_text(u.front()) + " to " +
                                            number_text(u.back()) + "; expected 0 to 1.");
  require_not_negative("mr_damper", "the first force of yield_table", f.front(), "N");
  for (std::size_t i = 1; i < f.size(); ++i)
    if (f[i] < f[i - 1])
      throw InputError(code::kCurveNotRising, "mr_damper: yield_table falls from " + number_text(f[i - 1]) +
                                                  " N at U = " + number_text(u[i - 1]) + " to " + number_text(f[i]) +
                                                  " N at U = " + number_text(u[i]) +
                                                  "; expected a force that never falls with U.");
  return curve;
}

}  // namespace

MrDamper::MrDamper(const MrDamperParameters& parameters) : parameters_(parameters) {
  require_not_negative(kind(), "yield_force", parameters.yield_force, "N");
  require_not_negative(kind(), "viscous_coefficient", parameters.viscous_coefficient, "N s/m");
  require_positive(kind(), "regularisation_speed", parameters.regularisation_speed, "m/s");
  require_not_negative(kind(), "coil_lag", parameters.coil_lag, "s");
  require_within(kind(), "initial_voltage", parameters.initial_voltage.value_or(0.0), 0.0, 1.0, "");
  if (!parameters.yield_table.empty()) table_ = checked_table(parameters.yield_table);
}

Eigen::VectorXd MrDamper::initial_state() const {
  return Eigen::VectorXd::Constant(state_count(), parameters_.initial_voltage.value_or(0.0));
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

MrDamperParameters mr_damper_from_geometry(const MrGeometry& g, MrDamperParameters law) {
  constexpr std::string_view kWho = "mr_damper geometry";
  require_positive(kWho, "D1", g.D1, "m");
  require_positive(kWho, "d1", g.d1, "m");
  require_positive(kWho, "D2", g.D2, "m");
  require_positive(kWho, "D3", g.D3, "m");
  require_positive(kWho, "L1", g.L1, "m");
  require_not_negative(kWho, "L2", g.L2, "m");
  require_positive(kWho, "L3", g.L3, "m");
  require_not_negative(kWho, "L4", g.L4, "m");
  require_positive(kWho, "eta", g.eta, "Pa s");
  if (g.d1 >= g.D1)
    throw InputError(code::kParametersDisagree, "mr_damper geometry: core diameter d1 = " + number_text(g.d1) +
                                                    " m does not fit into the bypass cylinder D1 = " +
                                                    number_text(g.D1) + " m; expected d1 < D1.");
  const double D4 = g.D4.value_or(g.D2), d = g.d.value_or(0.5 * (g.D1 - g.d1));
  require_positive(kWho, "D4", D4, "m");
  require_positive(kWho, "d", d, "m");
  if (g.tau_y.empty())
    throw InputError(
        code::kTableShape,
        "mr_damper geometry: the table tau_y is empty; expected pairs of U and yield stress, U from 0 to 1.");

  law.yield_table.clear();
  for (const Eigen::Vector2d& p : g.tau_y)
    law.yield_table.emplace_back(p.x(), 3.0 * kPi * g.L1 * p.y() * 0.5 * (g.D1 + g.d1));  // [Lin25 14]
  law.yield_force = law.yield_table.back().y();
  law.viscous_coefficient = (12.0 * g.eta * g.L1 / (d * d) +
                             32.0 * g.eta * (g.L2 / (g.D2 * g.D2) + g.L3 / (g.D3 * g.D3) + g.L4 / (D4 * D4))) *
                            0.25 * kPi * g.D3 * g.D3;  // [Lin25 15]
  MrDamper check(law);                                 // the constructor checks the table and the rest of the law
  return law;
}

}  // namespace footfall
