#include "coupler/schemes/quadratic.h"

#include <cmath>

namespace footfall {
namespace {

// Angular velocity of exp(theta(t)) in W, p = |theta|:
//   theta' + (1 - cos p)/p^2 theta x theta' + (p - sin p)/p^3 theta x (theta x theta')
Eigen::Vector3d angular_velocity(const Eigen::Vector3d& theta, const Eigen::Vector3d& theta_rate) {
  const double p2 = theta.squaredNorm();
  const double p = std::sqrt(p2);
  const bool small = p < 1e-4;  // series: the next terms are below p^4 / 24 = 4e-18
  const double c1 = small ? 0.5 - p2 / 24.0 : (1.0 - std::cos(p)) / p2;
  const double c2 = small ? 1.0 / 6.0 - p2 / 120.0 : (p - std::sin(p)) / (p2 * p);
  const Eigen::Vector3d cross = theta.cross(theta_rate);
  return theta_rate + c1 * cross + c2 * theta.cross(cross);
}

}  // namespace

// r + dr tau + ddr tau^2/2,  exp(w tau + dw tau^2/2) L,  a + da tau + dda tau^2/2.
void Quadratic::predict(const BodyMotion& start, double tau, BodyMotion& out) const {
  const double half = 0.5 * tau;
  const Eigen::Vector3d theta = tau * (start.w + half * start.dw);
  out.r = start.r + tau * (start.dr + half * start.ddr);
  out.L = turned(start.L, theta);
  out.a = start.a + tau * (start.da + half * start.dda);
  out.dr = start.dr + tau * start.ddr;
  out.w = angular_velocity(theta, start.w + tau * start.dw);
  out.da = start.da + tau * start.dda;
}

}  // namespace footfall
