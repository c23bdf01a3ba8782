#pragma once
// Magnetorheological damper [Lin25 14, 15; names of the two forces as in Table 3]:
//
//   F = F_y(U) s(v) + c v,   s(v) = tanh(v / v_s)
//
// The yield force is F_y(U) = U yield_force, or a table over U (from geometry and fluid data: mr_geometry.h).
// The gas spring is a law of its own beside it.
//
// Voltage: U is clamped to [0, 1]. With coil_lag = 0 it acts at once and there is no state. With coil_lag > 0
// (coil and driver, first order) the effective voltage is the one inner state:
//
//   dU_eff/dt = (clamp(U) - U_eff) / coil_lag
//
// Regularisation: below v_s the yield force is a viscous one of F_y / v_s; 0.02 m/s is 0.5 % of a landing
// speed of 3.8 m/s, and s reaches 0.96 at 2 v_s. A strut at rest under a load below F_y therefore creeps; it
// does not lock.

#include <optional>
#include <vector>

#include "mbd_solver/model/laws/monotone_curve.h"
#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

struct YieldPoint {
  double voltage;  // U in [0, 1] [-]
  double force;    // F_y at this U [N]
};

struct MrDamperParameters {
  double yield_force = 8278.72;          // F_y at U = 1, >= 0 [N] [Lin25 Table 3]; unused when yield_table is given
  double viscous_coefficient = 3651.19;  // c >= 0 [N s/m] [Lin25 Table 3]
  double regularisation_speed = 0.02;    // v_s > 0 [m/s]
  double coil_lag = 0.0;                 // tau >= 0, 0 = none [s]
  double initial_voltage = 0.0;          // U_eff at the start, in [0, 1]; used only with a coil lag [-]
  std::vector<YieldPoint> yield_table;   // empty: F_y = U yield_force. Else U rising strictly from 0 to 1,
                                         // force >= 0 and never falling; interpolated by a monotone cubic
};

class MrDamper final : public StrutLaw {
 public:
  explicit MrDamper(const MrDamperParameters& parameters);  // throws InputError for a value out of its range

  std::string_view kind() const override { return "mr_damper"; }
  int state_count() const override { return parameters_.coil_lag > 0.0 ? 1 : 0; }
  Eigen::VectorXd initial_state() const override;
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput&) const override { return 0.0; }
  // kMrViscous and kMrYield, both >= 0
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;

  double effective_voltage(const StrutInput& in) const;  // U_eff in [0, 1] [-]
  double yield_force(double voltage) const;              // F_y(U) [N], >= 0
  const MrDamperParameters& parameters() const { return parameters_; }

 private:
  double yield_slope(double voltage) const;  // dF_y/dU [N]

  MrDamperParameters parameters_;
  std::optional<MonotoneCurve> table_;
};

}  // namespace footfall
