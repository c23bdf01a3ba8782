#pragma once
// A motor with its gear on one coordinate x of a joint, rate v. The motor turns at omega = g v.
//   required:   torque: u = c(t)
//               speed: u = kp e + ki z, e = c(t) - v;  position: u = kp e + kd (c'(t) - v) + ki z, e = c(t) - x
//   delivered:  tau = u within [-tau_0 l(-omega), tau_0 l(omega)], l(omega) = 1 - omega / omega_0 within [-1, 1]
//   integral:   dz = e + (tau - u) / kp: stops growing at the limit (only with ki > 0)
//   at the joint: T = g (tau - |tau| L tanh(v / v_e)),
//                 L = 1 - eta where tau drives the joint, 1 / eta - 1 where it brakes
// Supplied power: tau omega. Dissipated in the gear: g |tau| L v tanh(v / v_e). The rotor's inertia
// belongs to the equations of motion (elements/constraint_row.h). theory 3.7.

#include <optional>

#include "mbd_solver/model/laws/strut_law.h"
#include "mbd_solver/model/laws/time_function.h"

namespace footfall {

enum class MotorKind {
  kTorque,    // delivers the torque `command`
  kSpeed,     // controls the joint's speed to `command`
  kPosition,  // controls the joint's coordinate to `command`
  kBrake      // no motor: Brake of laws/friction.h, engaged by `command` in [0, 1]
};
constexpr std::string_view name_of(MotorKind kind) { return name_in(kind, "torque", "speed", "position", "brake"); }

// Units of an angle x; of a displacement read m for rad of the joint.
struct MotorParameters {
  MotorKind kind = MotorKind::kTorque;
  TimeFunctionPtr command;  // c(t) [N m], [rad/s] or [rad]; StrutInput::command is added, its rate taken as 0
  double kp = 0.0;          // >= 0, > 0 for speed and position [N m s/rad or N m/rad]
  double ki = 0.0;          // >= 0 [N m/rad or N m/(rad s)]
  double kd = 0.0;          // >= 0, position [N m s/rad]
  std::optional<double> largest_torque;  // tau_0: at rest > 0; default no limit [N m]
  std::optional<double> no_load_speed;   // omega_0 > 0; default tau_0 at any speed [rad/s]
  double gear_ratio = 1.0;               // g > 0 [-, rad/m]
  double efficiency = 1.0;               // eta in (0, 1]
};

class Motor final : public StrutLaw {
 public:
  explicit Motor(const MotorParameters& parameters);  // throws InputError for a value out of range

  std::string_view kind() const override { return "motor"; }
  int state_count() const override { return parameters_.ki > 0.0 ? 1 : 0; }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(state_count()); }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;  // force = -T
  double stored_energy(const StrutInput&) const override { return 0.0; }
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kFriction >= 0
  double supplied_power(const StrutInput& in) const override;

 private:
  struct Shaft;
  MotorParameters parameters_;
};

}  // namespace footfall
