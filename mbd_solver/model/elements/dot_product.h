#pragma once
// Derivatives of a dot product a.b of kinematic vectors, the coordinate of most springs between two markers. Everything
// adds to its last argument.

#include "mbd_solver/model/kinematic_vector.h"

namespace footfall {

// (a.b)'
inline double dot_rate(const KinematicVector& a, const KinematicVector& b) {
  return a.rate().dot(b.value()) + a.value().dot(b.rate());
}

// out += factor d(a.b)/dx = factor d(a.b)'/dv
inline void add_dot(const KinematicVector& a, const KinematicVector& b, double factor,
                    Eigen::Ref<Eigen::VectorXd> out) {
  a.add_transposed(factor * b.value(), out);
  b.add_transposed(factor * a.value(), out);
}

// out += factor d(a.b)'/dx
inline void add_dot_rate(const KinematicVector& a, const KinematicVector& b, double factor,
                         Eigen::Ref<Eigen::VectorXd> out) {
  a.add_rate_by_position(factor * b.value(), out);
  b.add_rate_by_position(factor * a.value(), out);
  a.add_transposed(factor * b.rate(), out);
  b.add_transposed(factor * a.rate(), out);
}

// (a.b)''
inline double dot_acc(const KinematicVector& a, const KinematicVector& b) {
  return a.acc().dot(b.value()) + 2.0 * a.rate().dot(b.rate()) + a.value().dot(b.acc());
}

// out += factor d(a.b)''/dx at fixed v and dv
inline void add_dot_acc(const KinematicVector& a, const KinematicVector& b, double factor,
                        Eigen::Ref<Eigen::VectorXd> out) {
  a.add_acc_by_position(factor * b.value(), out);
  b.add_acc_by_position(factor * a.value(), out);
  a.add_rate_by_position(2.0 * factor * b.rate(), out);
  b.add_rate_by_position(2.0 * factor * a.rate(), out);
  a.add_transposed(factor * b.acc(), out);
  b.add_transposed(factor * a.acc(), out);
}

// out += factor d(a.b)''/dv at fixed x and dv
inline void add_dot_acc_by_velocity(const KinematicVector& a, const KinematicVector& b, double factor,
                                    Eigen::Ref<Eigen::VectorXd> out) {
  a.add_acc_by_velocity(factor * b.value(), out);
  b.add_acc_by_velocity(factor * a.value(), out);
  a.add_transposed(2.0 * factor * b.rate(), out);
  b.add_transposed(2.0 * factor * a.rate(), out);
}

// K += factor d2(a.b)/dx2
inline void add_dot_second(const KinematicVector& a, const KinematicVector& b, double factor,
                           Eigen::Ref<Eigen::MatrixXd> K) {
  a.add_second(factor * b.value(), K);
  b.add_second(factor * a.value(), K);
  const Eigen::Matrix3d scaled = factor * Eigen::Matrix3d::Identity();
  a.add_product(scaled, b, K);
  b.add_product(scaled, a, K);
}

}  // namespace footfall
