#pragma once
// Dry friction and brakes of one coordinate, with true stick. A displacement is assumed in the units; for an angle read
// rad for m and N m for N.

#include <optional>

#include "mbd_solver/model/laws/strut_law.h"
#include "mbd_solver/model/laws/time_function.h"

namespace footfall {

// Dry friction as an elastic-plastic bristle (Dupont, Hayward, Armstrong, Altpeter 2002). The inner state is its
// deflection z; at rest the bristle is a spring and holds without creep.
//   F  = k z + d(v) (1 - a) + c v,   k = F_c / delta
//   dz = v (1 - a z / z_s),          z_s(v) = sign(v) g(v) / k,   g(v) = F_c + (F_b - F_c) exp(-(v / v_s)^2)
//   a(z, v) = 0 while |z| < z_0 or z and v have different signs, then rises to 1 at |z_s| (sliding: F = +-g(v) + c v)
//   d(v) = 0.3 F_c u / sqrt(1 + u^2), u = v / v_s: damps the spring during stick;  z_0 = 0.7 delta
// Stored: k z^2 / 2. Dissipated: k z (v - dz) + (1 - a) d(v) v + c v^2, none of which is negative. theory 3.6.
struct JointFrictionParameters {
  double coulomb = 0.0;                // F_c: friction of fast sliding > 0 [N]
  std::optional<double> breakaway;     // F_b: friction at rest >= F_c; default F_c [N]
  double stribeck_speed = 0.01;        // v_s: speed over which F_b falls towards F_c > 0 [m/s]
  double viscous = 0.0;                // c >= 0 [N s/m]
  double stick_displacement = 1.0e-4;  // delta: deflection under F_c > 0 [m]
};

class JointFriction final : public StrutLaw {
 public:
  explicit JointFriction(const JointFrictionParameters& parameters);  // throws InputError for a value out of range

  std::string_view kind() const override { return "joint_friction"; }
  int state_count() const override { return 1; }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(1); }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override { return 0.5 * stiffness_ * in.z[0] * in.z[0]; }
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kFriction >= 0

 private:
  struct Sliding;
  JointFrictionParameters parameters_;
  double stiffness_;  // k [N/m]
};

// A brake: the dry friction above, multiplied by the engagement U in [0, 1].
//   F = U F_f(z, v),   U' = (c - U) / tau,   c = c(t) + StrutInput::command within [0, 1]
// F_f slides at the largest torque of the brake. The bristle z returns to 0 with time constant tau while the brake is
// released (c = 0). U = 1 locks the joint up to the elastic stick displacement.
// Stored: U k z^2 / 2. Dissipated: U times that of the friction, and U k z^2 / tau while released.
// Supplied by the actuator: U' k z^2 / 2. theory 3.7.
struct BrakeParameters {
  TimeFunctionPtr command;             // c(t) [-]
  double largest_force = 0.0;          // > 0 [N]
  double lag = 1.0e-3;                 // tau > 0 [s]
  double stick_displacement = 1.0e-4;  // > 0 [m]
};

class Brake final : public StrutLaw {
 public:
  explicit Brake(const BrakeParameters& parameters);  // throws InputError for a value out of range

  std::string_view kind() const override { return "brake"; }
  int state_count() const override { return 2; }   // [U, z]
  Eigen::VectorXd initial_state() const override;  // U = c(0)
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override;
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kFriction >= 0
  double supplied_power(const StrutInput& in) const override;

 private:
  double engagement_command(const StrutInput& in) const;  // c
  StrutInput of_friction(const StrutInput& in) const;

  BrakeParameters parameters_;
  JointFriction friction_;
  mutable StrutOutput out_;
  mutable std::vector<StrutPower> power_;
};

}  // namespace footfall
