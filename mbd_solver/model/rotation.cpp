// Quaternions are normalised where they are read, so that an integrator may leave |L| to drift.

#include "mbd_solver/model/rotation.h"

#include <algorithm>
#include <cmath>

namespace footfall {

Eigen::Matrix3d rotation_matrix(const Eigen::Vector4d& L) {
  // A = [(l0^2 - l.l) I + 2 l l^T + 2 l0 l~] / |L|^2
  const double l0 = L[0];
  const Eigen::Vector3d l = L.tail<3>();
  const double s = 1.0 / L.squaredNorm();
  Eigen::Matrix3d A = (2.0 * s) * (l * l.transpose() + l0 * skew(l));
  A.diagonal().array() += s * (l0 * l0 - l.squaredNorm());
  return A;
}

Matrix34d rate_matrix(const Eigen::Vector4d& L) {
  Matrix34d R;
  R.col(0) = -L.tail<3>();
  R.rightCols<3>() = skew(L.tail<3>());
  R.rightCols<3>().diagonal().array() += L[0];
  return R;
}

Eigen::Vector4d quaternion_rate(const Eigen::Vector4d& L, const Eigen::Vector3d& w) {
  Eigen::Vector4d dL;
  const Eigen::Vector3d l = L.tail<3>();
  dL[0] = -0.5 * l.dot(w);
  dL.tail<3>() = 0.5 * (L[0] * w + w.cross(l));
  return dL;
}

Eigen::Vector4d quaternion_from_matrix(const Eigen::Matrix3d& A) {
  const Eigen::Quaterniond p(A);
  Eigen::Vector4d L(p.w(), p.x(), p.y(), p.z());
  L.normalize();
  return L[0] < 0.0 ? Eigen::Vector4d(-L) : L;
}

Eigen::Vector4d quaternion_about(const Eigen::Vector3d& axis, double angle) {
  Eigen::Vector4d L;
  L[0] = std::cos(0.5 * angle);
  L.tail<3>() = std::sin(0.5 * angle) * axis.normalized();
  return L;
}

Eigen::Matrix3d rotation_from_rpy(double roll, double pitch, double yaw) {
  return (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Vector3d rpy_from_rotation(const Eigen::Matrix3d& A) {
  return {std::atan2(A(2, 1), A(2, 2)), -std::asin(std::clamp(A(2, 0), -1.0, 1.0)), std::atan2(A(1, 0), A(0, 0))};
}

Eigen::Vector4d rotated(const Eigen::Vector4d& L, const Eigen::Vector3d& dtheta) {
  const double angle = dtheta.norm();
  const Eigen::Vector4d unit = L.normalized();
  // sin(x/2)/x = 1/2 - x^2/48 + ...: below 1e-4 the next term is under round-off.
  const double s = angle > 1e-4 ? std::sin(0.5 * angle) / angle : 0.5 - angle * angle / 48.0;
  const double p0 = std::cos(0.5 * angle);
  const Eigen::Vector3d p = s * dtheta;
  const Eigen::Vector3d l = unit.tail<3>();
  Eigen::Vector4d out;
  out[0] = p0 * unit[0] - p.dot(l);
  out.tail<3>() = p0 * l + unit[0] * p + p.cross(l);
  return out.normalized();
}

Eigen::Matrix3d axes_with_z(const Eigen::Vector3d& z, const Eigen::Vector3d& x_hint) {
  Eigen::Matrix3d axes;
  axes.col(2) = z.normalized();
  Eigen::Vector3d x = x_hint - x_hint.dot(axes.col(2)) * axes.col(2);
  // A hint (nearly) parallel to z is replaced by the unit vector farthest from z.
  if (x.norm() < 1e-6 * x_hint.norm() || x.norm() == 0.0) {
    Eigen::Index k = 0;
    axes.col(2).cwiseAbs().minCoeff(&k);
    x = Eigen::Vector3d::Unit(k);
    x -= x.dot(axes.col(2)) * axes.col(2);
  }
  axes.col(0) = x.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

Eigen::Matrix3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double c = to.dot(from);
  if (c < -1.0 + 1e-12) {
    const Eigen::Vector3d axis = axes_with_z(from).col(0);
    return 2.0 * axis * axis.transpose() - Eigen::Matrix3d::Identity();
  }
  const double s = std::sqrt(2.0 * (1.0 + c));
  Eigen::Quaterniond turn;
  turn.vec() = from.cross(to) * (1.0 / s);
  turn.w() = 0.5 * s;
  return turn.toRotationMatrix();
}

}  // namespace footfall
