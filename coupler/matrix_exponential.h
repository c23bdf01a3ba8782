#pragma once
// exp(A) of a square matrix, by Eigen: compiled once, as it takes long.

#include <Eigen/Dense>

namespace footfall {

Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A);

}  // namespace footfall
