#include "mbd_solver/cli/calibrate/response_surface.h"

#include <cmath>
#include <limits>

namespace footfall {

namespace {

double cube(double r) { return r * r * r; }

// P: with a plane where the points span it and two more are left to tell its error.
Eigen::MatrixXd tail_of(const Eigen::MatrixXd& points) {
  const Eigen::Index n = points.cols(), m = points.rows();
  Eigen::MatrixXd p(n, m + 1);
  p << Eigen::VectorXd::Ones(n), points.transpose();
  return n >= m + 3 && p.colPivHouseholderQr().rank() == m + 1 ? p : p.leftCols(1);
}

}  // namespace

ResponseSurface::ResponseSurface(const Eigen::MatrixXd& points, const Eigen::VectorXd& values) : points_(points) {
  const Eigen::Index n = points.cols();
  const Eigen::MatrixXd p = tail_of(points);
  const Eigen::Index all = n + p.cols();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(all, all);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) matrix(i, j) = cube((points.col(i) - points.col(j)).norm());
  matrix.topRightCorner(n, p.cols()) = p;
  matrix.bottomLeftCorner(p.cols(), n) = p.transpose();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(all);
  right.head(n) = values;
  left_out_error_ = std::numeric_limits<double>::infinity();
  for (const double smoothing : kSmoothings) {
    Eigen::MatrixXd smoothed = matrix;
    smoothed.topLeftCorner(n, n).diagonal().array() += smoothing;
    const Eigen::MatrixXd inverse = smoothed.partialPivLu().inverse();
    const Eigen::VectorXd solution = inverse * right;
    if (!solution.allFinite()) continue;
    const double error = std::sqrt((solution.head(n).array() / inverse.diagonal().head(n).array()).square().mean());
    if (!(error < left_out_error_)) continue;
    left_out_error_ = error;
    weights_ = solution.head(n);
    plane_ = solution.tail(p.cols());
  }
  if (weights_.size() == n) return;
  weights_ = Eigen::VectorXd::Zero(n);  // one point alone: its value everywhere
  plane_ = Eigen::VectorXd::Constant(1, values.mean());
}

double ResponseSurface::at(const Eigen::VectorXd& x) const {
  double sum = plane_[0];
  if (plane_.size() > 1) sum += plane_.tail(plane_.size() - 1).dot(x);
  for (Eigen::Index j = 0; j < points_.cols(); ++j) sum += weights_[j] * cube((x - points_.col(j)).norm());
  return sum;
}

}  // namespace footfall
