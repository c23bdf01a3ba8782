#pragma once
// Dry friction and brakes of one coordinate, with true stick. A displacement is assumed in the units; for an angle read
// rad for m and N m for N.

#include <optional>

#include "mbd_solver/model/laws/strut_law.h"
#include "mbd_solver/model/laws/time_function.h"

namespace footfall {

// Dry friction that sticks and slips, with the mode s among its states [z, s]: 0 stick, 1 or -1 slip in this direction. A mode
// changes between integration steps, at the instant at which it no longer fits (switch_value): slip begins at F_b wherever and
// however fast the load came, and ends at rest. The bristle deflection z makes stick elastic.
//   stick  F = k z + d v + c v,  z' = v                     while |k z + d v| <= F_b
//   slip   F = s g(v) + c v,     z' = (s g(v) - k z) / d    while s (k z + d v) >= g(v)
//   g(v) = F_c + (F_b - F_c) exp(-(v / v_s)^2), or F_c;  k = F_c / delta,  d = 2 zeta sqrt(k m)
// The damper d is so large that a sudden load does not overshoot (zeta of the mass at the start).
// Stored: k z^2 / 2. Dissipated: stick d v^2, slip s g (v - z') + d z'^2, and c v^2; none is negative. theory 3.6.
struct JointFrictionParameters {
  double coulomb = 0.0;                  // F_c: sliding friction > 0 [N]
  std::optional<double> breakaway;       // F_b: friction at rest >= F_c; default F_c [N]
  std::optional<double> stribeck_speed;  // v_s: speed over which F_b falls towards F_c > 0 [m/s]; not given: at once
  double viscous = 0.0;                  // c >= 0 [N s/m]
  double stick_displacement = 1.0e-5;    // delta: deflection under F_c > 0 [m]
  double mass = 1.0;                     // m: moved by the coordinate > 0 [kg]
  double damping_ratio = 4.0;            // zeta > 0; a configuration may move 16 times the mass [-]
};

class JointFriction final : public StrutLaw {
 public:
  explicit JointFriction(const JointFrictionParameters& parameters);  // throws InputError for a value out of range

  std::string_view kind() const override { return "joint_friction"; }
  int state_count() const override { return 2; }  // [z, s]
  Eigen::VectorXd initial_state() const override { return Eigen::Vector2d::Zero(); }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override { return stored_energy(in.z[0]); }
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kFriction >= 0
  bool switches() const override { return true; }
  double switch_value(const StrutInput& in) const override;
  void switch_state(const StrutInput& in, Eigen::Ref<Eigen::VectorXd> z) const override;

  // Deflection z [m], mode s, rate v [m/s].
  struct Point {
    double z, s, v;
  };
  // Force, rate of z, and their derivatives.
  struct Bristle {
    double force = 0.0, by_z = 0.0, by_rate = 0.0, dz = 0.0, dz_by_z = 0.0, dz_by_rate = 0.0;
  };
  Bristle bristle(const Point& at) const;
  double stored_energy(double z) const { return 0.5 * stiffness_ * z * z; }  // [J]
  double dissipated_power(const Point& at) const;                            // [W]
  // The mode of a law without memory (F_b = F_c) at this deflection [m] and rate [m/s].
  double mode_at(double z, double rate) const;

 private:
  struct Slip {
    double force, slope;  // g [N], dg/dv
  };
  Slip slip(double rate) const;
  double trial(double z, double rate) const { return stiffness_ * z + damping_ * rate; }

  JointFrictionParameters parameters_;
  double stiffness_;  // k [N/m]
  double damping_;    // d [N s/m]
  double breakaway_;  // F_b [N]
};

// A brake: the dry friction above, multiplied by the engagement U in [0, 1].
//   F = U F_f(z, v),   U' = (c - U) / tau,   c = c(t) + StrutInput::command within [0, 1]
// F_f slides at the largest torque of the brake, F_b = F_c, so that its mode follows from z and v. The bristle z returns to 0
// with time constant tau while the brake is released (c = 0). U = 1 locks the joint up to the elastic stick displacement.
// Stored: U k z^2 / 2. Dissipated: U times the power of the friction, and U k z^2 / tau while released.
// Supplied by the actuator: U' k z^2 / 2. theory 3.7.
struct BrakeParameters {
  TimeFunctionPtr command;             // c(t) [-]
  double largest_force = 0.0;          // > 0 [N]
  double lag = 1.0e-3;                 // tau > 0 [s]
  double stick_displacement = 1.0e-5;  // > 0 [m]
  double mass = 1.0;                   // as of the friction > 0 [kg]
  double damping_ratio = 4.0;          // as of the friction > 0 [-]
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
  JointFriction::Point of_friction(const StrutInput& in) const {
    return {in.z[1], friction_.mode_at(in.z[1], in.rate), in.rate};
  }

  BrakeParameters parameters_;
  JointFriction friction_;
};

}  // namespace footfall
