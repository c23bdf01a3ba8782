#include "mbd_solver/coupling/tangent.h"

#include <cmath>

namespace footfall {

Vector6d mean_velocity(const Body& body, const BodyMotion& motion, const ContactTangent& slope, double H) {
  Matrix6d M = Matrix6d::Zero();
  M.diagonal().head<3>().setConstant(body.mass());
  const Eigen::Matrix3d A = motion.rotation();
  M.bottomRightCorner<3, 3>() = A * body.rigid_inertia() * A.transpose();
  Vector6d v, a;
  v << motion.dr, motion.w;
  a << motion.ddr, motion.dw;
  if (slope.K.isZero(0.0)) return v + 0.5 * H * a;

  // Two equal implicit stages (SDIRK): V_i = v_i + g f(d_i + g V_i, V_i), g = gamma H.
  const double g = (1.0 - std::sqrt(0.5)) * H;
  const Eigen::PartialPivLU<Matrix6d> solver(M + g * slope.C + g * g * slope.K);
  const Vector6d constant = M * a + slope.C * v;
  const auto stage = [&](const Vector6d& d_0, const Vector6d& v_0) -> Vector6d {
    return solver.solve(M * v_0 + g * (constant - slope.K * d_0));
  };
  const Vector6d V_1 = stage(Vector6d::Zero(), v);
  const Vector6d d_2 = (H - g) * V_1, v_2 = v + (H - g) / g * (V_1 - v);
  return (d_2 + g * stage(d_2, v_2)) / H;
}

TangentLoad tangent_load(const ContactTangent& slope, const PredictedWindow& predicted, double omega_h, double H) {
  TangentLoad load;
  load.K = slope.K;
  const double w6 = std::pow(0.5 * omega_h, 6);
  load.C = slope.C + 0.5 * H * w6 / (1.0 + w6) * slope.K;
  load.r_mean = predicted.r_mean();
  load.L_mean = predicted.L_mean();
  load.v_mean = predicted.v_mean();
  return load;
}

Eigen::Vector3d surplus_impulse(const TangentLoad& load, const BodyMotion& start, const BodyMotion& end, double H) {
  // Means over the window of the cubic through both ends.
  Vector6d x, v;
  x << 0.5 * (start.r + end.r) + H / 12.0 * (start.dr - end.dr) - load.r_mean,
      0.5 * (rotation_vector(load.L_mean, start.L) + rotation_vector(load.L_mean, end.L)) +
          H / 12.0 * (start.w - end.w);
  v << (end.r - start.r) / H, rotation_vector(start.L, end.L) / H;
  v -= load.v_mean;
  const Vector6d reaction = load.K * x + load.C * v;
  return -H * reaction.head<3>();
}

double pending_work(const MeanLoad& mean, const MeanLoad& before, double ratio, const PredictedWindow& predicted,
                    const BodyMotion& computed) {
  // Means stand for the windows' middles.
  const double share = ratio / (1.0 + ratio);
  Vector6d force;
  force << mean.F_W + share * (mean.F_W - before.F_W),
      computed.rotation() * (mean.T_B + share * (mean.T_B - before.T_B));
  return force.dot(predicted.gap(computed));
}

double pending_work(const MeanLoad& mean, const ContactTangent& slope, const PredictedWindow& predicted,
                    const BodyMotion& computed) {
  const Vector6d gap = predicted.gap(computed);
  Vector6d force;
  force << mean.F_W, computed.rotation() * mean.T_B;
  force -= slope.K * (predicted.end_from_mean() + 0.5 * gap);
  return force.dot(gap);
}

}  // namespace footfall
