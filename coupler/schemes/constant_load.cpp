// Predicted paths, the work that is still pending at the end of a window, and the common window map.

#include "coupler/schemes/constant_load.h"

#include <cmath>

#include "coupler/load_average.h"
#include "coupler/messages.h"

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

double ConstantLoadScheme::pending_work(const AnsweredLoads& loads, const PredictedPath& path,
                                        const BodyMotion& computed) const {
  const MeanLoad &mean = loads.load.mean, &before = loads.before;
  // Means are values at the middles of the windows.
  const double share = loads.ratio / (1.0 + loads.ratio);
  Vector6d force;
  force << mean.F_W + share * (mean.F_W - before.F_W),
      computed.rotation() * (mean.T_B + share * (mean.T_B - before.T_B));
  return force.dot(path.gap(computed));
}

MapState ConstantLoadScheme::window_map(double omega_h, int n, const MapState& z) const {
  const double K = omega_h * omega_h, x = z[0], v = z[1], a = z[2], gap = z[3] - z[0];
  const double velocity = path_degree_ >= 1 ? v : 0.0, acceleration = path_degree_ >= 2 ? a : 0.0;
  // mean f = trapezoid + end_step (f(1) - f(0)).
  const double end_step = 0.5 * (weights_.closing - weights_.opening) / n;
  const double mean_tau = 0.5 + end_step, mean_tau2 = 1.0 / 3.0 + 1.0 / (6.0 * n * n) + end_step,
               mean_g = 0.5 / (1.0 * n * n) - end_step;
  // A boundary that jumps does so after the force at the start of the window.
  const double mean_gap = continuous_path() ? mean_g : 0.5 / n;
  const double f = -K * (x + mean_tau * velocity + 0.5 * mean_tau2 * acceleration + mean_gap * gap);
  MapState out;
  out << x + v + 0.5 * f, v + f, f, x + velocity + 0.5 * acceleration, velocity + acceleration + 2.0 * gap;
  return out;
}

void ConstantLoadScheme::predict(const BodyMotion& start, double tau, BodyMotion& out) const {
  if (path_degree_ == 1) return predict_linear(start, tau, out);
  if (path_degree_ == 0) {
    out.r = start.r;
    out.L = start.L;
    out.a = start.a;
    out.dr.setZero();
    out.w.setZero();
    out.da.setZero();
    return;
  }
  // r + dr tau + ddr tau^2/2,  exp(w tau + dw tau^2/2) L,  a + da tau + dda tau^2/2.
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
