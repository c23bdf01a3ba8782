// The chain command -> controller -> torque limit -> gear loss in one place (Shaft), with its derivatives.

#include "mbd_solver/model/laws/motor.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

constexpr double kGearSpeed = 1.0e-3;  // v_e: the gear loss fades below this speed [rad/s or m/s]

// l(omega) and its slope.
struct SpeedLimit {
  SpeedLimit(double omega, const std::optional<double>& no_load_speed) {
    if (!no_load_speed) return;
    const double s = omega / *no_load_speed;
    value = std::clamp(1.0 - s, -1.0, 1.0);
    if (s > 0.0 && s < 2.0) slope = -1.0 / *no_load_speed;
  }
  double value = 1.0, slope = 0.0;
};

}  // namespace

// From the coordinate to the torque at the joint, with derivatives by x, v and z.
struct Motor::Shaft {
  Shaft(const MotorParameters& p, const StrutInput& in) {
    TimeValue c = p.command->at(in.time);
    c.value += in.command;
    const double x = in.stroke, v = in.rate, z = p.ki > 0.0 ? in.z[0] : 0.0;
    switch (p.kind) {
      case MotorKind::kTorque: u = c.value; break;
      case MotorKind::kSpeed:
        e = c.value - v;
        e_v = -1.0;
        u = p.kp * e + p.ki * z;
        u_v = -p.kp;
        break;
      case MotorKind::kPosition:
        e = c.value - x;
        e_x = -1.0;
        u = p.kp * e + p.kd * (c.rate - v) + p.ki * z;
        u_x = -p.kp;
        u_v = -p.kd;
        break;
      case MotorKind::kBrake: break;
    }
    tau = u;
    tau_x = u_x;
    tau_v = u_v;
    tau_z = p.ki;
    if (p.largest_torque) {
      const double omega = p.gear_ratio * v;
      const SpeedLimit forward(omega, p.no_load_speed), backward(-omega, p.no_load_speed);
      const double high = *p.largest_torque * forward.value, low = -*p.largest_torque * backward.value;
      const bool too_high = u > high, too_low = u < low;
      if (too_high || too_low) {
        tau = too_high ? high : low;
        tau_v = *p.largest_torque * p.gear_ratio * (too_high ? forward.slope : backward.slope);
        tau_x = tau_z = 0.0;
      }
    }
    // T = g (tau - |tau| loss), loss = L tanh(v / v_e)
    const double L = tau * v > 0.0 ? 1.0 - p.efficiency : 1.0 / p.efficiency - 1.0;
    const double s = std::tanh(v / kGearSpeed), sign = tau < 0.0 ? -1.0 : 1.0;
    const double loss = L * s, loss_v = L * (1.0 - s * s) / kGearSpeed;
    const double by_tau = p.gear_ratio * (1.0 - sign * loss);
    T = by_tau * tau;
    T_x = by_tau * tau_x;
    T_v = by_tau * tau_v - p.gear_ratio * std::abs(tau) * loss_v;
    T_z = by_tau * tau_z;
    dissipated = p.gear_ratio * std::abs(tau) * loss * v;
  }
  double e = 0.0, e_x = 0.0, e_v = 0.0;  // error
  double u = 0.0, u_x = 0.0, u_v = 0.0;  // required; by z: ki
  double tau, tau_x, tau_v, tau_z;       // delivered
  double T, T_x, T_v, T_z;               // at the joint
  double dissipated;                     // in the gear [W]
};

Motor::Motor(const MotorParameters& parameters) : parameters_(parameters) {
  const MotorParameters& p = parameters_;
  FOOTFALL_DEMAND(p.command != nullptr && p.kind != MotorKind::kBrake);
  require_not_negative(kind(), "kp", p.kp, "");
  require_not_negative(kind(), "ki", p.ki, "");
  require_not_negative(kind(), "kd", p.kd, "");
  require_positive(kind(), "gear_ratio", p.gear_ratio, "");
  require_positive(kind(), "efficiency", p.efficiency, "");
  require_within(kind(), "efficiency", p.efficiency, 0.0, 1.0, "");
  if (p.kind != MotorKind::kTorque) require_positive(kind(), "kp", p.kp, "");
  if (p.kind == MotorKind::kTorque && p.ki > 0.0)
    throw InputError(code::kParametersDisagree, "motor: ki has no effect on a commanded torque; leave it out.");
  if (p.largest_torque) require_positive(kind(), "max_torque", *p.largest_torque, "N m");
  if (p.no_load_speed) require_positive(kind(), "max_speed", *p.no_load_speed, "rad/s");
  if (p.no_load_speed && !p.largest_torque)
    throw InputError(
        code::kParametersDisagree,
        "motor: max_speed requires max_torque; the torque falls from max_torque at rest to 0 at max_speed.");
}

void Motor::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  const Shaft s(parameters_, in);
  out.force = -s.T;
  out.dforce_dstroke = -s.T_x;
  out.dforce_drate = -s.T_v;
  if (parameters_.ki == 0.0) return;
  const double kp = parameters_.kp;
  out.dforce_dz[0] = -s.T_z;
  out.dz[0] = s.e + (s.tau - s.u) / kp;
  out.ddz_dstroke[0] = s.e_x + (s.tau_x - s.u_x) / kp;
  out.ddz_drate[0] = s.e_v + (s.tau_v - s.u_v) / kp;
  out.ddz_dz(0, 0) = (s.tau_z - parameters_.ki) / kp;
}

void Motor::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  out.push_back({Dissipation::kFriction, Shaft(parameters_, in).dissipated});
}

double Motor::supplied_power(const StrutInput& in) const {
  return Shaft(parameters_, in).tau * parameters_.gear_ratio * in.rate;
}

}  // namespace footfall
