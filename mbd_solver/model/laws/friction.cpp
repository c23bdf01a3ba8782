// Stick is a spring and a damper, slip a constant or Stribeck force; the mode is a state. A brake scales the force by its
// engagement, and needs no memory of the mode.

#include "mbd_solver/model/laws/friction.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

// Slip ends when the force is this share below the sliding force, so that round-off does not end slip as soon as it begins.
constexpr double kHysteresis = 1e-4;

double sign(double x) { return x < 0.0 ? -1.0 : 1.0; }

}  // namespace

JointFriction::JointFriction(const JointFrictionParameters& parameters)
    : parameters_(parameters),
      stiffness_(parameters.coulomb / parameters.stick_displacement),
      damping_(2.0 * parameters.damping_ratio * std::sqrt(stiffness_ * parameters.mass)),
      breakaway_(parameters.breakaway.value_or(parameters.coulomb)) {
  require_positive(kind(), "coulomb", parameters.coulomb, "N");
  if (parameters.stribeck_speed) require_positive(kind(), "stribeck_speed", *parameters.stribeck_speed, "m/s");
  require_positive(kind(), "stick_displacement", parameters.stick_displacement, "m");
  require_not_negative(kind(), "viscous", parameters.viscous, "N s/m");
  require_positive(kind(), "mass", parameters.mass, "kg");
  require_positive(kind(), "damping_ratio", parameters.damping_ratio, "");
  if (parameters.breakaway && !(*parameters.breakaway >= parameters.coulomb))
    throw InputError(code::kParametersDisagree, "joint_friction: breakaway " + number_text(*parameters.breakaway) +
                                                    " is less than coulomb " + number_text(parameters.coulomb) +
                                                    "; expected at least as much friction at rest as in sliding.");
}

JointFriction::Slip JointFriction::slip(double rate) const {
  if (!parameters_.stribeck_speed) return {parameters_.coulomb, 0.0};
  const double u = rate / *parameters_.stribeck_speed;
  const double fall = (breakaway_ - parameters_.coulomb) * std::exp(-u * u);
  return {parameters_.coulomb + fall, -2.0 * u / *parameters_.stribeck_speed * fall};
}

JointFriction::Bristle JointFriction::bristle(const Point& at) const {
  Bristle out;
  if (at.s == 0.0) {
    out.force = trial(at.z, at.v);
    out.by_rate = damping_;
    out.by_z = stiffness_;
    out.dz = at.v;
    out.dz_by_rate = 1.0;
  } else {
    const Slip g = slip(at.v);
    out.force = at.s * g.force;
    out.by_rate = at.s * g.slope;
    out.dz = (at.s * g.force - stiffness_ * at.z) / damping_;
    out.dz_by_rate = at.s * g.slope / damping_;
    out.dz_by_z = -stiffness_ / damping_;
  }
  out.force += parameters_.viscous * at.v;
  out.by_rate += parameters_.viscous;
  return out;
}

void JointFriction::evaluate(const StrutInput& in, StrutOutput& out) const {
  const Bristle here = bristle({in.z[0], std::round(in.z[1]), in.rate});
  out.set_zero();
  out.force = here.force;
  out.dforce_drate = here.by_rate;
  out.dforce_dz[0] = here.by_z;
  out.dz[0] = here.dz;
  out.ddz_drate[0] = here.dz_by_rate;
  out.ddz_dz(0, 0) = here.dz_by_z;
}

double JointFriction::dissipated_power(const Point& at) const {
  double power = damping_ * at.v * at.v;
  if (at.s != 0.0) {
    const double g = at.s * slip(at.v).force, z_rate = (g - stiffness_ * at.z) / damping_;
    power = g * (at.v - z_rate) + damping_ * z_rate * z_rate;
  }
  return power + parameters_.viscous * at.v * at.v;
}

void JointFriction::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  out.push_back({Dissipation::kFriction, dissipated_power({in.z[0], std::round(in.z[1]), in.rate})});
}

// Relative to F_c.
double JointFriction::switch_value(const StrutInput& in) const {
  const double s = std::round(in.z[1]), force = trial(in.z[0], in.rate);
  const double left = s == 0.0 ? breakaway_ - std::abs(force) : s * force - (1.0 - kHysteresis) * slip(in.rate).force;
  return left / parameters_.coulomb;
}

void JointFriction::switch_state(const StrutInput& in, Eigen::Ref<Eigen::VectorXd> z) const {
  const double force = trial(in.z[0], in.rate);
  z[1] = std::abs(force) > breakaway_ ? sign(force) : 0.0;
}

double JointFriction::mode_at(double z, double rate) const {
  const double force = trial(z, rate);
  return std::abs(force) > breakaway_ ? sign(force) : 0.0;
}

namespace {

JointFrictionParameters friction_of(const BrakeParameters& p) {
  require_positive("brake", "max_torque", p.largest_force, "N m");
  require_positive("brake", "lag", p.lag, "s");
  JointFrictionParameters friction;
  friction.coulomb = p.largest_force;
  friction.stick_displacement = p.stick_displacement;
  friction.mass = p.mass;
  friction.damping_ratio = p.damping_ratio;
  return friction;
}

}  // namespace

Brake::Brake(const BrakeParameters& parameters) : parameters_(parameters), friction_(friction_of(parameters)) {
  FOOTFALL_DEMAND(parameters_.command != nullptr);
}

Eigen::VectorXd Brake::initial_state() const {
  return Eigen::Vector2d(std::clamp(parameters_.command->at(0.0).value, 0.0, 1.0), 0.0);
}

double Brake::engagement_command(const StrutInput& in) const {
  return std::clamp(parameters_.command->at(in.time).value + in.command, 0.0, 1.0);
}

void Brake::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  const JointFriction::Bristle friction = friction_.bristle(of_friction(in));
  const double U = in.z[0], c = engagement_command(in), tau = parameters_.lag;
  out.force = U * friction.force;
  out.dforce_drate = U * friction.by_rate;
  out.dforce_dz << friction.force, U * friction.by_z;
  out.dz << (c - U) / tau, friction.dz;
  out.ddz_drate[1] = friction.dz_by_rate;
  out.ddz_dz(0, 0) = -1.0 / tau;
  out.ddz_dz(1, 1) = friction.dz_by_z;
  if (c > 0.0) return;
  out.dz[1] -= in.z[1] / tau;
  out.ddz_dz(1, 1) -= 1.0 / tau;
}

double Brake::stored_energy(const StrutInput& in) const { return in.z[0] * friction_.stored_energy(in.z[1]); }

void Brake::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  double power = friction_.dissipated_power(of_friction(in));
  if (engagement_command(in) == 0.0) power += 2.0 * friction_.stored_energy(in.z[1]) / parameters_.lag;
  out.push_back({Dissipation::kFriction, in.z[0] * power});
}

double Brake::supplied_power(const StrutInput& in) const {
  return (engagement_command(in) - in.z[0]) / parameters_.lag * friction_.stored_energy(in.z[1]);
}

}  // namespace footfall
