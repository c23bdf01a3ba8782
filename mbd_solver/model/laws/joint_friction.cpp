#include "mbd_solver/model/laws/joint_friction.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

constexpr double kElastic = 0.7;  // of delta: up to here nothing slides
constexpr double kDamping = 0.3;  // of F_c: with the spring at z_0 no more than F_c

}  // namespace

// a, r = a z / z_s and d(v), with their derivatives.
struct JointFriction::Sliding {
  Sliding(const JointFrictionParameters& p, double stiffness, double z, double v) {
    const double u = v / p.stribeck_speed;
    const double root = std::sqrt(1.0 + u * u);
    damping = kDamping * p.coulomb * u / root;
    damping_v = kDamping * p.coulomb / (p.stribeck_speed * root * root * root);
    if (!(z * v > 0.0)) return;
    const double fall = (p.breakaway - p.coulomb) * std::exp(-u * u);
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
  if (!(parameters.breakaway >= parameters.coulomb))
    throw InputError("joint_friction: breakaway " + number_text(parameters.breakaway) + " is less than coulomb " +
                     number_text(parameters.coulomb) + "; what holds at rest is at least what slides.");
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

}  // namespace footfall
