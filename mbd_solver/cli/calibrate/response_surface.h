#pragma once
// Smooth functions through scattered numbers with noise: cubic radial basis functions and a plane,
//
//   s(x) = sum over j of w_j |x - x_j|^3 + c_0 + c . x,   [K + lambda I, P; P^T, 0] [w; c] = [y; 0]
//
// with K_ij = |x_i - x_j|^3 and P = [1, x^T]; with too few points for a plane, P = [1]. lambda, of kSmoothings, is the
// one that tells each point best from the others: least sum of e_j^2, e_j = w_j / (M^-1)_jj of the matrix M above
// [Rippa 1999, for lambda = 0]. Several numbers at the same points share M; each has its own lambda.

#include <Eigen/Dense>
#include <array>

namespace footfall {

class ResponseSurfaces {
 public:
  static constexpr std::array<double, 6> kSmoothings = {1e-5, 1e-3, 1e-2, 1e-1, 1.0, 10.0};

  // `points`: one per column; `values`: a row for each point, a column for each number.
  ResponseSurfaces(const Eigen::MatrixXd& points, const Eigen::MatrixXd& values);

  Eigen::VectorXd at(const Eigen::VectorXd& x) const;  // all numbers
  // What is wrong, root mean square, where a point is told from the others alone; per number.
  const Eigen::VectorXd& left_out_errors() const { return left_out_errors_; }

 private:
  Eigen::MatrixXd points_;
  Eigen::MatrixXd weights_;  // w above c, a column for each number
  Eigen::VectorXd left_out_errors_;
};

}  // namespace footfall
