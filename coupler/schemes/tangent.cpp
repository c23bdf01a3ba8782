// One SDIRK step predicts the mean velocity; the slopes of the contacts, with added damping, react within the window.

#include "coupler/schemes/tangent.h"

#include <algorithm>
#include <cmath>

namespace footfall {
namespace {

// D / K [s].
double window_damping(double omega_h, double H) {
  const double w6 = std::pow(0.5 * omega_h, 6);
  return 0.5 * H * w6 / (1.0 + w6);
}

// Slopes of one body's contacts; zero before the first window.
ContactTangent slope_of(const BodyLoad& load) { return load.tangent.empty() ? ContactTangent{} : load.tangent.front(); }

}  // namespace

void Tangent::predict(const BodyMotion& start, double tau, BodyMotion& out) const { predict_linear(start, tau, out); }

void Tangent::set_path_rates(const Matrix6d& M, const BodyLoad& last, double H, BodyMotion& motion) const {
  Vector6d v, a;
  v << motion.dr, motion.w;
  a << motion.ddr, motion.dw;
  const Vector6d mean = mean_velocity(M, v, a, slope_of(last), H);
  motion.dr = mean.head<3>();
  motion.w = mean.tail<3>();
  if (motion.mode_count() > 0) motion.da += 0.5 * H * motion.dda;
}

std::optional<TangentLoad> Tangent::reaction(const Matrix6d& M, const BodyLoad& load, const PredictedPath& path,
                                             double H) const {
  const double mass = M(0, 0);
  const double omega_h = std::sqrt(std::max(0.0, load.contact_stiffness) / mass) * H;
  return tangent_load(slope_of(load), path, omega_h, H);
}

double Tangent::pending_work(const AnsweredLoads& loads, const PredictedPath& path, const BodyMotion& computed) const {
  const Vector6d gap = path.gap(computed);
  const MeanLoad& mean = loads.load.mean;
  Vector6d force;
  force << mean.F_W, computed.rotation() * mean.T_B;
  force -= slope_of(loads.load).K * (path.end_from_mean() + 0.5 * gap);
  return force.dot(gap);
}

MapState Tangent::window_map(double omega_h, int n, const MapState& z) const {
  const double K = omega_h * omega_h, x = z[0], v = z[1], a = z[2], gap = z[3] - z[0], p = z[4];
  ContactTangent slope;
  slope.K(0, 0) = K;
  const double V = mean_velocity(Matrix6d::Identity(), v * Vector6d::UnitX(), a * Vector6d::UnitX(), slope, 1.0)[0];
  const double D = window_damping(omega_h, 1.0) * K;
  const double v_mean = V - gap + 0.5 / n * (p - (V - 4.0 * gap));
  const PointMotion end = exact_flow(K, D, D * v_mean, {x, v});
  MapState out;
  out << end.x, end.v, -K * end.x - D * (end.v - v_mean), x + V, V + 2.0 * gap;
  return out;
}

Vector6d mean_velocity(const Matrix6d& M, const Vector6d& v, const Vector6d& a, const ContactTangent& slope, double H) {
  if (slope.K.isZero(0.0)) return v + 0.5 * H * a;

  // Two equal implicit stages (SDIRK): V_i = v_i + g f(d_i + g V_i, V_i), g = gamma H.
  const double g = (1.0 - std::sqrt(0.5)) * H;
  const Eigen::PartialPivLU<Eigen::MatrixXd> solver(M + g * slope.C + g * g * slope.K);
  const Vector6d constant = M * a + slope.C * v;
  const auto stage = [&](const Vector6d& d_0, const Vector6d& v_0) -> Vector6d {
    return solver.solve(M * v_0 + g * (constant - slope.K * d_0));
  };
  const Vector6d V_1 = stage(Vector6d::Zero(), v);
  const Vector6d d_2 = (H - g) * V_1, v_2 = v + (H - g) / g * (V_1 - v);
  return (d_2 + g * stage(d_2, v_2)) / H;
}

TangentLoad tangent_load(const ContactTangent& slope, const PredictedPath& path, double omega_h, double H) {
  TangentLoad load;
  load.K = slope.K;
  load.C = slope.C + window_damping(omega_h, H) * slope.K;
  load.r_mean = path.r_mean;
  load.L_mean = path.L_mean;
  load.v_mean = path.v_mean;
  return load;
}

}  // namespace footfall
