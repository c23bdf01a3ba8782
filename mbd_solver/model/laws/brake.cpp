#include "mbd_solver/model/laws/brake.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"

namespace footfall {
namespace {

JointFrictionParameters friction_of(const BrakeParameters& p) {
  require_positive("brake", "max_torque", p.largest_force, "N m");
  require_positive("brake", "lag", p.lag, "s");
  JointFrictionParameters friction;
  friction.coulomb = friction.breakaway = p.largest_force;
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

double Brake::pressed(const StrutInput& in) const {
  return std::clamp(parameters_.command->at(in.time).value + in.command, 0.0, 1.0);
}

StrutInput Brake::of_friction(const StrutInput& in) const {
  return {in.stroke, in.rate, 0.0, in.z.segment(1, 1), in.time};
}

void Brake::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  friction_.evaluate(of_friction(in), out_);
  const double U = in.z[0], c = pressed(in), tau = parameters_.lag;
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
  if (pressed(in) == 0.0) power += 2.0 * friction_.stored_energy(of_friction(in)) / parameters_.lag;
  out.push_back({Dissipation::kFriction, in.z[0] * power});
}

double Brake::supplied_power(const StrutInput& in) const {
  return (pressed(in) - in.z[0]) / parameters_.lag * friction_.stored_energy(of_friction(in));
}

}  // namespace footfall
