// Exact flow by a matrix exponential, spectral radius by repeated squaring.

#include "coupler/schemes/window_map.h"

#include <Eigen/Dense>
#include <algorithm>
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

double largest_omega_h(const Scheme& scheme, int n, double gain, double most) {
  constexpr double kRatio = 1.03;  // between two trials
  double last = 0.0;
  for (double w = 2e-3; w < most; w *= kRatio) {
    if (std::pow(predicted_growth(scheme, w, n), 2.0 * M_PI / w) > 1.0 + gain) return last;
    last = w;
  }
  return most;
}

// Long windows come ever closer to the map of fine steps: beyond kMany the last value holds.
double OmegaHLimit::at(int n) {
  constexpr std::size_t kMany = 32;
  known_.resize(kMany, 0.0);
  double& limit = known_[std::min(static_cast<std::size_t>(n), kMany) - 1];
  if (limit == 0.0) limit = largest_omega_h(*scheme_, std::min(n, static_cast<int>(kMany)), kContactGain, given_);
  return limit;
}

int OmegaHLimit::substeps(double omega_dt, int most, double share) {
  if (!(omega_dt > 0.0)) return most;
  int n = static_cast<int>(std::clamp(share * given_ / omega_dt, 1.0, static_cast<double>(most)));
  while (n > 1 && omega_dt * n > share * at(n)) --n;
  return n;
}

}  // namespace footfall
