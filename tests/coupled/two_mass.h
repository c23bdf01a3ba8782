#pragma once
// The two-mass oscillator of theory 7.3: a body on a spring, a grain on a spring, a linear contact
// spring between them.

#include <Eigen/Dense>
#include <cmath>

#include "tests/support/linear_algebra.h"

namespace footfall::test {

struct TwoMass {
  static constexpr double M = 10.0, K = 1e4;            // body [kg], its spring [N/m]
  static constexpr double m = 1.0, kp = 2e4, kc = 3e4;  // grain [kg], its spring, contact spring [N/m]

  // y = (X, V, x, v) of body and grain.
  static Eigen::Vector4d initial() { return {0.01, 0.5, 0.0, 0.0}; }
  static double energy(const Eigen::Vector4d& y) {
    return 0.5 *
           (M * y[1] * y[1] + K * y[0] * y[0] + m * y[3] * y[3] + kp * y[2] * y[2] + kc * std::pow(y[0] - y[2], 2));
  }
  // State after t, by the exponential of the system matrix in normal modes (exact to round-off).
  static Eigen::Vector4d exact(double t) {
    // With z = (sqrt(M) X, sqrt(m) x): z'' = -D z, D symmetric.
    Eigen::Matrix2d D;
    D << (K + kc) / M, -kc / std::sqrt(M * m), -kc / std::sqrt(M * m), (kp + kc) / m;
    const EigenPairs modes = symmetric_modes(D);
    const Eigen::Vector2d scale(std::sqrt(M), std::sqrt(m));
    const Eigen::Vector4d y = initial();
    const Eigen::Vector2d p = modes.vectors.transpose() * Eigen::Vector2d(scale[0] * y[0], scale[1] * y[2]);
    const Eigen::Vector2d q = modes.vectors.transpose() * Eigen::Vector2d(scale[0] * y[1], scale[1] * y[3]);
    Eigen::Vector2d position, velocity;
    for (int k = 0; k < 2; ++k) {
      const double om = std::sqrt(modes.values[k]);
      position[k] = p[k] * std::cos(om * t) + q[k] / om * std::sin(om * t);
      velocity[k] = -p[k] * om * std::sin(om * t) + q[k] * std::cos(om * t);
    }
    const Eigen::Vector2d z = modes.vectors * position, dz = modes.vectors * velocity;
    return {z[0] / scale[0], dz[0] / scale[0], z[1] / scale[1], dz[1] / scale[1]};
  }
  // Size of a state error: positions [cm], velocities [m/s], as in theory's table.
  static double error(const Eigen::Vector4d& y, const Eigen::Vector4d& reference) {
    return (y - reference).cwiseProduct(Eigen::Vector4d(100, 1, 100, 1)).norm();
  }
};

}  // namespace footfall::test
