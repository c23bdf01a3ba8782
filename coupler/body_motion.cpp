// Rotations are unit quaternions, scalar first; Eigen does their algebra.

#include "coupler/body_motion.h"

#include <cmath>

namespace footfall {
namespace {

Eigen::Quaterniond quaternion(const Eigen::Vector4d& L) { return {L[0], L[1], L[2], L[3]}; }

Eigen::Vector4d components(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

}  // namespace

void BodyMotion::resize(int modes) {
  a.setZero(modes);
  da.setZero(modes);
  dda.setZero(modes);
}

Eigen::Matrix3d BodyMotion::rotation() const { return quaternion(L).toRotationMatrix(); }

bool BodyMotion::all_finite() const {
  return r.allFinite() && L.allFinite() && a.allFinite() && dr.allFinite() && w.allFinite() && da.allFinite() &&
         ddr.allFinite() && dw.allFinite() && dda.allFinite();
}

void GeneralizedForce::set_zero() {
  F_W.setZero();
  T_W.setZero();
  Q_a.setZero();
}

double power(const GeneralizedForce& Q, const BodyMotion& motion) {
  return Q.F_W.dot(motion.dr) + Q.T_W.dot(motion.w) + Q.Q_a.dot(motion.da);
}

Eigen::Vector4d turned(const Eigen::Vector4d& L, const Eigen::Vector3d& theta_W) {
  const double angle = theta_W.norm();
  if (angle == 0.0) return L;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, theta_W / angle));
  return components((turn * quaternion(L)).normalized());
}

Eigen::Vector3d rotation_vector(const Eigen::Vector4d& from, const Eigen::Vector4d& to) {
  if (from == to) return Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = quaternion(to) * quaternion(from).conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const double sine = turn.vec().norm();  // of half the angle
  if (sine == 0.0) return Eigen::Vector3d::Zero();
  return turn.vec() * (2.0 * std::atan2(sine, turn.w()) / sine);
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

}  // namespace footfall
