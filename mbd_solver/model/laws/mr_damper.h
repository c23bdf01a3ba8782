#pragma once
// Magnetorheological damper [Lin25 14, 15; names of the two forces as in Table 3]:
//
//   F = F_y(U) s(v) + c v,   s(v) = tanh(v / v_s)
//
// The yield force is F_y(U) = U yield_force, or a table over U (from geometry and fluid data, below). The gas spring is
// its own law.
//
// Voltage: U is clamped to [0, 1]. With coil_lag = 0 it acts at once, without a state. With coil_lag > 0 (coil and
// driver, first order) the effective voltage is the inner state:
//
//   dU_eff/dt = (clamp(U) - U_eff) / coil_lag
//
// Regularisation: below v_s the yield force is viscous, F_y / v_s. 0.02 m/s is 0.5 % of a landing speed of 3.8 m/s;
// s reaches 0.96 at 2 v_s. A strut at rest under a load below F_y therefore creeps instead of locking.

#include <optional>
#include <vector>

#include "mbd_solver/model/laws/curves.h"
#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

struct MrDamperParameters {
  double yield_force = 8278.72;           // F_y at U = 1, >= 0 [N] [Lin25 Table 3]; unused when yield_table is given
  double viscous_coefficient = 3651.19;   // c >= 0 [N s/m] [Lin25 Table 3]
  double regularisation_speed = 0.02;     // v_s > 0 [m/s]
  double coil_lag = 0.0;                  // tau >= 0, 0 = none [s]
  std::optional<double> initial_voltage;  // U_eff at the start, in [0, 1], with a coil lag; not given: 0 [-]
  // (U [-], F_y [N]), interpolated by a monotone cubic: U rising strictly from 0 to 1, F_y >= 0 and never falling.
  // Empty: F_y = U yield_force.
  std::vector<Eigen::Vector2d> yield_table;
};

class MrDamper final : public StrutLaw {
 public:
  explicit MrDamper(const MrDamperParameters& parameters);  // throws InputError for a value out of range

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

// Parameters of the law from dimensions and fluid of a bypass MR damper [Lin25 14, 15, Figure 2]:
//   F_y(U) = 3 pi L1 tau_y(U) (D1 + d1) / 2
//   c      = (12 eta L1 / d^2 + 32 eta (L2/D2^2 + L3/D3^2 + L4/D4^2)) pi D3^2 / 4
// No defaults: these values are not given in [Lin25]. All > 0 except L2, L4 >= 0.
struct MrGeometry {
  double D1 = 0.0;           // inner diameter of the bypass cylinder [m]
  double d1 = 0.0;           // diameter of the magnetic core, < D1 [m]
  double D2 = 0.0;           // inner diameter of the first connecting cylinder [m]
  double D3 = 0.0;           // inner diameter of the main cylinder [m]
  std::optional<double> D4;  // inner diameter of the second connecting cylinder; default D2 [m]
  std::optional<double> d;   // gap between core and bypass cylinder; default (D1 - d1) / 2 [m]
  double L1 = 0.0;           // length of the wound section of the core [m]
  double L2 = 0.0;           // length of the first connecting cylinder [m]
  double L3 = 0.0;           // length of the main cylinder [m]
  double L4 = 0.0;           // length of the second connecting cylinder [m]
  double eta = 0.0;          // viscosity of the fluid without field [Pa s]
  // (U [-], shear yield strength of the fluid in the field of this U [Pa]); U rises strictly from 0 to 1, tau_y >= 0
  // never falls
  std::vector<Eigen::Vector2d> tau_y;
};

// `law` gives the values that do not follow from geometry (v_s, coil lag, initial voltage); yield_table, yield_force
// (at U = 1) and viscous_coefficient are replaced. Throws InputError for a value out of range.
MrDamperParameters mr_damper_from_geometry(const MrGeometry& geometry, MrDamperParameters law = {});

}  // namespace footfall
