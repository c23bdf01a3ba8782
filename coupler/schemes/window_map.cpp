#include "coupler/schemes/window_map.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include "coupler/schemes/scheme.h"

namespace footfall {

PointMotion exact_flow(double K, double D, double f, const PointMotion& start) {
  Eigen::Matrix3d A;
  A << 0.0, 1.0, 0.0, -K, -D, f, 0.0, 0.0, 0.0;
  const Eigen::Vector3d end = A.exp() * Eigen::Vector3d(start.x, start.v, 1.0);
  return {end[0], end[1]};
}

double predicted_growth(const Scheme& scheme, double omega_h, int n) {
  Eigen::Matrix<double, 5, 5> map;
  for (int k = 0; k < 5; ++k) map.col(k) = scheme.window_map(omega_h, n, MapState::Unit(k));
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace footfall
