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

ResponseSurfaces::ResponseSurfaces(const Eigen::MatrixXd& points, const Eigen::MatrixXd& values) : points_(points) {
  const Eigen::Index n = points.cols(), numbers = values.cols();
  const Eigen::MatrixXd p = tail_of(points);
  const Eigen::Index all = n + p.cols();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(all, all);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) matrix(i, j) = cube((points.col(i) - points.col(j)).norm());
  matrix.topRightCorner(n, p.cols()) = p;
  matrix.bottomLeftCorner(p.cols(), n) = p.transpose();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(all, numbers);
  right.topRows(n) = values;
  weights_ = Eigen::MatrixXd::Zero(all, numbers);  // one point alone: its value everywhere
  weights_.row(n) = values.colwise().mean();
  left_out_errors_ = Eigen::VectorXd::Constant(numbers, std::numeric_limits<double>::infinity());
  for (const double smoothing : kSmoothings) {
    Eigen::MatrixXd smoothed = matrix;
    smoothed.topLeftCorner(n, n).diagonal().array() += smoothing;
    const Eigen::MatrixXd inverse = smoothed.partialPivLu().inverse();
    const Eigen::MatrixXd solution = inverse * right;
    for (Eigen::Index k = 0; k < numbers; ++k) {
      const double error =
          std::sqrt((solution.col(k).head(n).array() / inverse.diagonal().head(n).array()).square().mean());
      if (!(error < left_out_errors_[k])) continue;  // nor when it is no number
      left_out_errors_[k] = error;
      weights_.col(k) = solution.col(k);
    }
  }
}

Eigen::VectorXd ResponseSurfaces::at(const Eigen::VectorXd& x) const {
  const Eigen::Index n = points_.cols();
  Eigen::VectorXd base(weights_.rows());
  for (Eigen::Index j = 0; j < n; ++j) base[j] = cube((x - points_.col(j)).norm());
  base[n] = 1.0;
  if (base.size() > n + 1) base.tail(x.size()) = x;
  return weights_.transpose() * base;
}

}  // namespace footfall
