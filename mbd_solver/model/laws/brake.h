#pragma once
// A brake on one coordinate of a joint: the dry friction of joint_friction.h with true stick, pressed by U in [0, 1].
//   F = U F_f(z, v),   U' = (c - U) / tau,   c = c(t) + StrutInput::command within [0, 1]
// F_f slides at the brake's largest torque and holds up to it; z is its bristle, which goes back to 0 with tau where the
// brake is let go (c = 0). U = 1 locks the joint, but for the elastic stick displacement.
// Stored: U k z^2 / 2. Dissipated: U times that of the friction, and U k z^2 / tau where it is let go.
// Supplied, by what presses it: U' k z^2 / 2. theory 3.7.

#include "mbd_solver/model/laws/joint_friction.h"
#include "mbd_solver/model/laws/time_function.h"

namespace footfall {

// Units of a displacement; of an angle read rad for m and N m for N.
struct BrakeParameters {
  TimeFunctionPtr command;             // c(t) [-]
  double largest_force = 0.0;          // > 0 [N]
  double lag = 1.0e-3;                 // tau > 0 [s]
  double stick_displacement = 1.0e-4;  // > 0 [m]
};

class Brake final : public StrutLaw {
 public:
  explicit Brake(const BrakeParameters& parameters);  // throws InputError for a value out of its range

  std::string_view kind() const override { return "brake"; }
  int state_count() const override { return 2; }   // [U, z]
  Eigen::VectorXd initial_state() const override;  // U = c(0)
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override;
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kFriction >= 0
  double supplied_power(const StrutInput& in) const override;

 private:
  double pressed(const StrutInput& in) const;  // c
  StrutInput of_friction(const StrutInput& in) const;

  BrakeParameters parameters_;
  JointFriction friction_;
  mutable StrutOutput out_;
  mutable std::vector<StrutPower> power_;
};

}  // namespace footfall
