#pragma once
// Seeded numbers for random mechanisms.

#include <Eigen/Dense>
#include <random>

#include "mbd_solver/model/rotation.h"
#include "tests/support/last_bits.h"

namespace footfall::test {

// Numbers for the arguments of one call are drawn before it: compilers differ in the order in which they evaluate them.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return last_bits(std::uniform_real_distribution<double>(low, high)(engine_));
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }  // both included
  bool one_in(int n) { return whole(1, n) == 1; }
  Eigen::Vector3d vector(double size) {
    const double x = between(-size, size), y = between(-size, size);
    return {x, y, between(-size, size)};
  }
  Eigen::Vector3d direction() {
    Eigen::Vector3d v;
    do v = vector(1.0);
    while (v.norm() > 1.0 || v.norm() < 0.1);
    return v.normalized();
  }
  // Of a length between these, which is drawn first.
  Eigen::Vector3d arrow(double low, double high) {
    const double length = between(low, high);
    return direction() * length;
  }
  Eigen::Vector4d quaternion() {
    const double w = between(-1.0, 1.0);
    const Eigen::Vector3d v = vector(1.0);
    return Eigen::Vector4d(w + 1.5, v.x(), v.y(), v.z()).normalized();
  }
  Eigen::Matrix3d axes() { return rotation_matrix(quaternion()); }

 private:
  std::mt19937 engine_;
};

}  // namespace footfall::test
