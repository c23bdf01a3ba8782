#pragma once
// exp(A) of a square matrix, by Eigen. A separate file, because it takes long to compile.

#include <Eigen/Dense>

namespace footfall {

Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A);

}  // namespace footfall
