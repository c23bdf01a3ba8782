// Eigen's matrix exponential: scaling and squaring with Pade approximants.

#include "coupler/matrix_exponential.h"

#include <unsupported/Eigen/MatrixFunctions>

namespace footfall {

Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A) { return A.exp(); }

}  // namespace footfall
