#pragma once
// Decompositions for tests, compiled once: each of them costs the compiler seconds in every program that makes it anew.

#include <Eigen/Core>

namespace footfall::test {

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& A);

// K v = lambda M v with symmetric K and M, by rising lambda; the columns v have v . M v = 1.
struct EigenPairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
EigenPairs symmetric_modes(const Eigen::MatrixXd& K);
EigenPairs symmetric_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M);

// A = U diag(s) V^T, by falling s; U and V are thin.
struct SingularValues {
  Eigen::MatrixXd U, V;
  Eigen::VectorXd s;
};
SingularValues singular_values(const Eigen::MatrixXd& A);

Eigen::MatrixXd exponential(const Eigen::MatrixXd& A);

// The x of A x = b for a regular A; of least squares where A is higher than wide.
Eigen::MatrixXd solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

}  // namespace footfall::test
