#include "mbd_solver/model/flexible/fe_partition.h"

#include <algorithm>
#include <limits>

#include "coupler/errors.h"

namespace footfall {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

std::vector<int> active_dofs(const FeModel& model) {
  std::vector<int> dofs;
  const VectorXd stiffness = model.stiffness.diagonal();
  const VectorXd mass = lumped_mass_matrix(model).diagonal();
  for (int i = 0; i < 6 * model.node_count(); ++i)
    if (stiffness(i) != 0.0 || mass(i) != 0.0) dofs.push_back(i);
  return dofs;
}

std::vector<int> other_dofs(const std::vector<int>& all, const std::vector<int>& excluded) {
  std::vector<int> sorted = excluded;
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> result;
  std::set_difference(all.begin(), all.end(), sorted.begin(), sorted.end(), std::back_inserter(result));
  return result;
}

Sparse selected(const Sparse& matrix, const std::vector<int>& rows, const std::vector<int>& columns) {
  std::vector<int> number(static_cast<std::size_t>(matrix.rows()), -1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    number[static_cast<std::size_t>(rows[i])] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (Sparse::InnerIterator it(matrix, columns[j]); it; ++it) {
      const int i = number[static_cast<std::size_t>(it.row())];
      if (i >= 0) entries.emplace_back(i, static_cast<int>(j), it.value());
    }
  Sparse result(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

MatrixXd gathered(const MatrixXd& x, const std::vector<int>& rows) {
  MatrixXd result(static_cast<Index>(rows.size()), x.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) result.row(static_cast<Index>(i)) = x.row(rows[i]);
  return result;
}

MatrixXd scattered(const MatrixXd& x, const std::vector<int>& rows, Index size) {
  MatrixXd result = MatrixXd::Zero(size, x.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) result.row(rows[i]) = x.row(static_cast<Index>(i));
  return result;
}

MatrixXd rigid_motions(const FeModel& model, const Vector3d& centre) {
  MatrixXd R = MatrixXd::Zero(6 * model.node_count(), 6);
  for (int j = 0; j < model.node_count(); ++j) {
    R.block<3, 3>(6 * j, 0).setIdentity();
    for (int i = 0; i < 3; ++i)
      R.block<3, 1>(6 * j, 3 + i) = Vector3d::Unit(i).cross(Vector3d(model.nodes.col(j)) - centre);
    if (model.rotations) R.block<3, 3>(6 * j + 3, 3).setIdentity();
  }
  return R;
}

// Fields u = e_i x_k x_l with the rotation of their curl, theta = 1/2 curl u = 1/2 grad(x_k x_l) x e_i.
double elastic_scale(const FeModel& model) {
  const MassProperties body = mass_properties(model);
  const Sparse M = lumped_mass_matrix(model);
  const MatrixXd R = rigid_motions(model, body.centre);
  const MatrixXd MR = M * R;
  const Eigen::LDLT<MatrixXd> rigid_mass(R.transpose() * MR);
  double scale = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l) {
        VectorXd u = VectorXd::Zero(6 * model.node_count());
        for (int j = 0; j < model.node_count(); ++j) {
          const Vector3d x = model.nodes.col(j) - body.centre;
          const Vector3d gradient = Vector3d::Unit(k) * x(l) + Vector3d::Unit(l) * x(k);
          u(6 * j + i) = x(k) * x(l);
          if (model.rotations) u.segment<3>(6 * j + 3) = 0.5 * gradient.cross(Vector3d(Vector3d::Unit(i)));
        }
        const double before = u.dot(M * u);
        u -= R * rigid_mass.solve(MR.transpose() * u);
        const double mass = u.dot(M * u);
        const double energy = u.dot(model.stiffness * u);
        if (mass > 1e-6 * before && energy > 0.0) scale = std::min(scale, energy / mass);
      }
  if (!(scale < std::numeric_limits<double>::infinity()))
    throw InputError("the model has no stiffness or no mass: no elastic motion was found.");
  return scale;
}

}  // namespace footfall
