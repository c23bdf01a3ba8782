#pragma once
// A symmetric 3 x 3 matrix as its six numbers.

#include <Eigen/Dense>

namespace footfall {

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
