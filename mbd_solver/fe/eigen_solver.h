#pragma once
// Lowest modes of K x = lambda M x; K and M symmetric positive semidefinite (massless degrees of freedom follow statically).

#include <Eigen/Dense>
#include <Eigen/Sparse>

namespace footfall {

struct Modes {
  Eigen::VectorXd lambda;  // ascending [1/s2]
  Eigen::MatrixXd shapes;  // columns, x^T M x = 1
};

enum class EigenMethod { kAutomatic, kDense, kSubspace };

// The `count` lowest modes. K + shift M must be positive definite: shift = 0 for a supported body, about the first elastic
// lambda for a free one. Dense for small problems, else subspace iteration on (K + shift M)^-1 M, with the same result.
// Throws InputError if M has fewer than `count` positive directions or K + shift M is not positive definite, NumericalError
// if the iteration does not converge.
Modes lowest_modes(const Eigen::SparseMatrix<double>& K, const Eigen::SparseMatrix<double>& M, int count, double shift,
                   EigenMethod method = EigenMethod::kAutomatic);

// Number of independent motions with mass: the rank of a mass matrix, block by block of coupled rows.
int mass_rank(const Eigen::SparseMatrix<double>& M);

// All modes with mass, dense; for the small problems of reduced bases.
Modes all_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M, double shift);

}  // namespace footfall
