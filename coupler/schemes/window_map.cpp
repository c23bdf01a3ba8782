// Exact flow by a matrix exponential, spectral radius by repeated squaring.

#include "coupler/schemes/window_map.h"

#include <Eigen/Dense>
#include <cmath>

#include "coupler/matrix_exponential.h"
#include "coupler/schemes/scheme.h"

namespace footfall {
namespace {

using Map = Eigen::Matrix<double, 5, 5>;

// Gelfand's formula: |A^k|^(1/k) with k = 2^40, by squaring. Its error is log(k) / k, 3e-11, and up to 2e-6 by round-off
// where eigenvalues coincide and share one eigenvector. (Eigen's eigenvalues of a general matrix take long to compile.)
double spectral_radius(Map A) {
  double log_radius = 0.0, share = 1.0;
  for (int doubling = 0; doubling <= 40; ++doubling, share *= 0.5) {
    const double size = A.norm();
    if (size == 0.0) return 0.0;
    log_radius += share * std::log(size);
    A /= size;
    A = (A * A).eval();
  }
  return std::exp(log_radius);
}

}  // namespace

PointMotion exact_flow(double K, double D, double f, const PointMotion& start) {
  Eigen::Matrix3d A;
  A << 0.0, 1.0, 0.0, -K, -D, f, 0.0, 0.0, 0.0;
  const Eigen::Vector3d end = matrix_exponential(A) * Eigen::Vector3d(start.x, start.v, 1.0);
  return {end[0], end[1]};
}

double predicted_growth(const Scheme& scheme, double omega_h, int n) {
  Map map;
  for (int k = 0; k < 5; ++k) map.col(k) = scheme.window_map(omega_h, n, MapState::Unit(k));
  return spectral_radius(map);
}

}  // namespace footfall
