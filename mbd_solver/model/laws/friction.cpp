// The bristle model of Dupont et al. with analytic derivatives; a brake scales it by its engagement.

#include "mbd_solver/model/laws/friction.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

constexpr double kElastic = 0.7;  // z_0 over delta: no sliding up to here
constexpr double kDamping = 0.3;  // of F_c: spring at z_0 plus damping do not exceed F_c

}  // namespace

// a, r = a z / z_s and d(v), with their derivatives.
struct JointFriction::Sliding {
  Sliding(const JointFrictionParameters& p, double stiffness, double z, double v) {
    const double u = v / p.stribeck_speed;
    const double root = std::sqrt(1.0 + u * u);
    damping = kDamping * p.coulomb * u / root;
    damping_v = kDamping * p.coulomb / (p.stribeck_speed * root * root * root);
    if (!(z * v > 0.0)) return;
    const double fall = (p.breakaway.value_or(p.coulomb) - p.coulomb) * std::exp(-u * u);
    const double end = (p.coulomb + fall) / stiffness;  // |z_s|
    const double end_v = -2.0 * u / p.stribeck_speed * fall / stiffness;
    const double sign = v > 0.0 ? 1.0 : -1.0, size = std::abs(z);
    const double begin = kElastic * p.stick_displacement;
    if (size <= begin) return;
    if (size >= end) {
      a = 1.0;
    } else {
      const double s = (size - begin) / (end - begin);  // in (0, 1)
      a = 0.5 * (1.0 - std::cos(kPi * s));
      const double slope = 0.5 * kPi * std::sin(kPi * s) / (end - begin);
      a_z = slope * sign;
      a_v = -slope * s * end_v;
    }
    r = a * size / end;
    r_z = (a_z * size + a * sign) / end;
    r_v = (a_v * size - r * end_v) / end;
  }
  double a = 0.0, a_z = 0.0, a_v = 0.0;
  double r = 0.0, r_z = 0.0, r_v = 0.0;
  double damping, damping_v;
};

JointFriction::JointFriction(const JointFrictionParameters& parameters)
    : parameters_(parameters), stiffness_(parameters.coulomb / parameters.stick_displacement) {
  require_positive(kind(), "coulomb", parameters.coulomb, "N");
  require_positive(kind(), "stribeck_speed", parameters.stribeck_speed, "m/s");
  require_positive(kind(), "stick_displacement", parameters.stick_displacement, "m");
  require_not_negative(kind(), "viscous", parameters.viscous, "N s/m");
  if (parameters.breakaway && !(*parameters.breakaway >= parameters.coulomb))
    throw InputError(code::kParametersDisagree, "joint_friction: breakaway " + number_text(*parameters.breakaway) +
                                                    " is less than coulomb " + number_text(parameters.coulomb) +
                                                    "; expected at least as much friction at rest as in sliding.");
}

void JointFriction::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  const double z = in.z[0], v = in.rate;
  const Sliding s(parameters_, stiffness_, z, v);
  out.force = stiffness_ * z + (1.0 - s.a) * s.damping + parameters_.viscous * v;
  out.dforce_drate = (1.0 - s.a) * s.damping_v - s.a_v * s.damping + parameters_.viscous;
  out.dforce_dz[0] = stiffness_ - s.a_z * s.damping;
  out.dz[0] = v * (1.0 - s.r);
  out.ddz_drate[0] = 1.0 - s.r - v * s.r_v;
  out.ddz_dz(0, 0) = -v * s.r_z;
}

void JointFriction::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  const double z = in.z[0], v = in.rate;
  const Sliding s(parameters_, stiffness_, z, v);
  out.push_back(
      {Dissipation::kFriction, stiffness_ * z * v * s.r + (1.0 - s.a) * s.damping * v + parameters_.viscous * v * v});
}

namespace {

JointFrictionParameters friction_of(const BrakeParameters& p) {
  require_positive("brake", "max_torque", p.largest_force, "N m");
  require_positive("brake", "lag", p.lag, "s");
  JointFrictionParameters friction;
  friction.coulomb = p.largest_force;
  friction.stick_displacement = p.stick_displacement;
  return friction;
}

}  // namespace

Brake::Brake(const BrakeParameters& parameters) : parameters_(parameters), friction_(friction_of(parameters)), out_(1) {
  FOOTFALL_DEMAND(parameters_.command != nullptr);
}

Eigen::VectorXd Brake::initial_state() const {
  return Eigen::Vector2d(std::clamp(parameters_.command->at(0.0).value, 0.0, 1.0), 0.0);
}

double Brake::engagement_command(const StrutInput& in) const {
  return std::clamp(parameters_.command->at(in.time).value + in.command, 0.0, 1.0);
}

StrutInput Brake::of_friction(const StrutInput& in) const {
  return {in.stroke, in.rate, 0.0, in.z.segment(1, 1), in.time};
}

void Brake::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  friction_.evaluate(of_friction(in), out_);
  const double U = in.z[0], c = engagement_command(in), tau = parameters_.lag;
  out.force = U * out_.force;
  out.dforce_dstroke = U * out_.dforce_dstroke;
  out.dforce_drate = U * out_.dforce_drate;
  out.dforce_dz << out_.force, U * out_.dforce_dz[0];
  out.dz << (c - U) / tau, out_.dz[0];
  out.ddz_dstroke[1] = out_.ddz_dstroke[0];
  out.ddz_drate[1] = out_.ddz_drate[0];
  out.ddz_dz(0, 0) = -1.0 / tau;
  out.ddz_dz(1, 1) = out_.ddz_dz(0, 0);
  if (c > 0.0) return;
  out.dz[1] -= in.z[1] / tau;
  out.ddz_dz(1, 1) -= 1.0 / tau;
}

double Brake::stored_energy(const StrutInput& in) const { return in.z[0] * friction_.stored_energy(of_friction(in)); }

void Brake::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  power_.clear();
  friction_.dissipated_power(of_friction(in), power_);
  double power = 0.0;
  for (const StrutPower& p : power_) power += p.power;
  if (engagement_command(in) == 0.0) power += 2.0 * friction_.stored_energy(of_friction(in)) / parameters_.lag;
  out.push_back({Dissipation::kFriction, in.z[0] * power});
}

double Brake::supplied_power(const StrutInput& in) const {
  return (engagement_command(in) - in.z[0]) / parameters_.lag * friction_.stored_energy(of_friction(in));
}

}  // namespace footfall
