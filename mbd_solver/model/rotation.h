#pragma once
// Rotations: unit quaternions L = (l0, l), scalar first, and rotation increments dtheta in the inertial frame W; symmetric
// matrices and the direction of up.
//   A(L) is evaluated with L / |L|, so that functions of the attitude do not depend on |L|:
//   dtheta = 2 R(L) dL / |L|^2,   R(L) = [-l, l~ + l0 I] (3 x 4),   R(L) L = 0,   dL/dt = 1/2 R(L)^T w.

#include <Eigen/Dense>

namespace footfall {

using Matrix34d = Eigen::Matrix<double, 3, 4>;

// x~: x~ y = x cross y.
inline Eigen::Matrix3d skew(const Eigen::Vector3d& x) {
  Eigen::Matrix3d m;
  m << 0.0, -x.z(), x.y(), x.z(), 0.0, -x.x(), -x.y(), x.x(), 0.0;
  return m;
}

// A(L / |L|) = R_WB. L must not be zero.
Eigen::Matrix3d rotation_matrix(const Eigen::Vector4d& L);

// R(L), see above.
Matrix34d rate_matrix(const Eigen::Vector4d& L);

// dL/dt = 1/2 R(L)^T w, w in W [rad/s].
Eigen::Vector4d quaternion_rate(const Eigen::Vector4d& L, const Eigen::Vector3d& w);

// Unit quaternion of a proper rotation matrix, l0 >= 0.
Eigen::Vector4d quaternion_from_matrix(const Eigen::Matrix3d& A);

// Unit quaternion of a rotation by `angle` [rad] about `axis` (any length but zero).
Eigen::Vector4d quaternion_about(const Eigen::Vector3d& axis, double angle);

// Rz(yaw) Ry(pitch) Rx(roll), angles in [rad]: the order of roll, pitch and yaw in scenes and histories.
Eigen::Matrix3d rotation_from_rpy(double roll, double pitch, double yaw);
// Its inverse (roll, pitch, yaw): roll and yaw in [-pi, pi], pitch in [-pi/2, pi/2].
Eigen::Vector3d rpy_from_rotation(const Eigen::Matrix3d& A);

// L turned by the rotation vector dtheta (in W, any size): exp(dtheta) * L, normalised.
Eigen::Vector4d rotated(const Eigen::Vector4d& L, const Eigen::Vector3d& dtheta);

// Right-handed axes (columns x, y, z) whose z is `z` and whose x is as near as possible to `x_hint` (any axis if parallel).
Eigen::Matrix3d axes_with_z(const Eigen::Vector3d& z, const Eigen::Vector3d& x_hint = Eigen::Vector3d::UnitX());

// The shortest rotation of the direction `from` to `to`, both unit vectors; half a turn about an axis normal to `from` if
// they are opposite. (Eigen's FromTwoVectors compiles a singular value decomposition for that case.)
Eigen::Matrix3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

// Up, for heights and vertical speeds: against gravity g [m/s2], along z without gravity. A unit vector of W.
inline Eigen::Vector3d up_direction(const Eigen::Vector3d& g) {
  return g.norm() > 0.0 ? Eigen::Vector3d(-g.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

// --- A symmetric 3 x 3 matrix as six numbers.

using Symmetric = Eigen::Matrix<double, 6, 1>;  // xx yy zz xy yz zx

// x + x^T
inline Symmetric twice_symmetric(const Eigen::Matrix3d& x) {
  Symmetric sum;
  sum << 2.0 * x(0, 0), 2.0 * x(1, 1), 2.0 * x(2, 2), x(0, 1) + x(1, 0), x(1, 2) + x(2, 1), x(2, 0) + x(0, 2);
  return sum;
}

inline Eigen::Matrix3d matrix(const Symmetric& x) {
  Eigen::Matrix3d m;
  m << x(0), x(3), x(5), x(3), x(1), x(4), x(5), x(4), x(2);
  return m;
}

// w . X w = squares(w) . X
inline Symmetric squares(const Eigen::Vector3d& w) {
  Symmetric s;
  s << w.x() * w.x(), w.y() * w.y(), w.z() * w.z(), 2.0 * w.x() * w.y(), 2.0 * w.y() * w.z(), 2.0 * w.z() * w.x();
  return s;
}

}  // namespace footfall
