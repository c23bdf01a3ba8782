#include "liggghts_fix/wall_contact.h"

#include <cmath>

namespace footfall {
namespace {

constexpr double kSliding = 1.0 - 1e-6;  // of the Coulomb limit, to round-off

double compliance(const ElasticConstants& m) { return (1.0 - m.poisson * m.poisson) / m.young; }

double shear_compliance(const ElasticConstants& m) { return 2.0 * (2.0 - m.poisson) * (1.0 + m.poisson) / m.young; }

}  // namespace

WallContact hertz_mindlin(const ElasticConstants& grain, const ElasticConstants& wall) {
  WallContact contact;
  contact.young = 1.0 / (compliance(grain) + compliance(wall));
  contact.shear = 1.0 / (shear_compliance(grain) + shear_compliance(wall));
  return contact;
}

double damping_of_restitution(double e) {
  const double log_e = std::log(e);
  return -2.0 * std::sqrt(5.0 / 6.0) * log_e / std::sqrt(log_e * log_e + M_PI * M_PI);
}

ContactSlope WallContact::slope(const Eigen::Vector3d& normal_W, const Eigen::Vector3d& f_W, double s,
                                double mass) const {
  ContactSlope slope;
  slope.normal_W = normal_W;
  slope.stiffness = stiffness(s);
  const bool is_linear = linear > 0.0;
  slope.damping = is_linear ? linear_damping * mass : damping * std::sqrt(slope.stiffness * mass);
  const double pressure = f_W.dot(normal_W);
  const double across = (f_W - pressure * normal_W).norm();
  if (across < kSliding * friction * std::abs(pressure)) {
    slope.shear_stiffness = is_linear ? linear_shear : 8.0 * shear * s;
    slope.shear_damping = is_linear ? linear_shear_damping * mass : damping * std::sqrt(slope.shear_stiffness * mass);
  }
  return slope;
}

}  // namespace footfall
