#include "mbd_solver/fe/equal_frequencies.h"

#include <Eigen/Eigenvalues>
#include <vector>

#include "mbd_solver/model/principal_axes.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kApart = 1e-3;  // of the largest eigenvalue of B

}  // namespace

Matrix3d axis_weight(const Matrix3d& principal_axes) {
  return principal_axes * Eigen::Vector3d(1.0, 2.0, 3.0).asDiagonal() * principal_axes.transpose();
}

Eigen::SparseMatrix<double> axis_weights(const FeModel& model) {
  const Matrix3d weight = axis_weight(principal_axes(mass_properties(model).inertia));
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < model.node_count(); ++j)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) entries.emplace_back(6 * j + a, 6 * j + b, model.node_mass(j) * weight(a, b));
  Eigen::SparseMatrix<double> W(6 * model.node_count(), 6 * model.node_count());
  W.setFromTriplets(entries.begin(), entries.end());
  return W;
}

MatrixXd along_axes(const VectorXd& lambda, const MatrixXd& B) {
  const Index modes = lambda.size();
  MatrixXd Y = MatrixXd::Identity(modes, modes);
  for (Index first = 0, end = 0; first < modes; first = end) {
    for (end = first + 1; end < modes && lambda(end) - lambda(end - 1) <= kOneFrequency * lambda(end);) ++end;
    const Index size = end - first;
    if (size == 1) continue;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(B.block(first, first, size, size));
    const VectorXd along = eigen.eigenvalues();  // rising
    const bool apart = (along.tail(size - 1) - along.head(size - 1)).minCoeff() > kApart * along(size - 1);
    if (apart) Y.block(first, first, size, size) = eigen.eigenvectors();
  }
  return Y;
}

}  // namespace footfall
