// Selected rows and columns of K and M, factored by sparse Cholesky; elastic_scale() bounds the first mode by trial fields.

#include "mbd_solver/fe/fe_analysis.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "mbd_solver/model/codes.h"

namespace footfall {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

namespace {

constexpr double kRigid = 1e-6;   // a field is a rigid motion if less than this fraction of its norm remains
constexpr int kScaleRounds = 10;  // each lowers the scale by up to 1e8; most bodies need two or three
constexpr int kScaleIterations = 4;
constexpr double kScaleFloor = 1e-8;

}  // namespace

std::vector<int> active_dofs(const FeModel& model) {
  std::vector<int> dofs;
  const VectorXd stiffness = model.stiffness.diagonal();
  const VectorXd mass = mass_matrix(model).diagonal();
  for (int i = 0; i < stiffness.size(); ++i)
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
  for (std::size_t i = 0; i < rows.size(); ++i) number[rows[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (Sparse::InnerIterator it(matrix, columns[j]); it; ++it) {
      const int i = number[it.row()];
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
  MatrixXd R = MatrixXd::Zero(model.stiffness.rows(), 6);
  R.topRows(6 * model.nodes.cols()) = rigid_motions(model.nodes.colwise() - centre, model.rotations);
  return R;
}

// A first bound from fields u = e_i x_k x_l, with the rotation of their curl, theta = 1/2 grad(x_k x_l) x e_i. It can be far
// too high, because the fields ignore where the body is soft; inverse iteration with the bound as shift and rigid motion
// removed improves it.
double elastic_scale(const FeModel& model) {
  const MassProperties body = mass_properties(model);
  const std::vector<int> active = active_dofs(model);
  const Sparse M = selected(mass_matrix(model), active, active);
  const Sparse K = selected(model.stiffness, active, active);
  const MatrixXd R = gathered(rigid_motions(model, body.centre), active);
  const MatrixXd MR = M * R;
  const Eigen::LDLT<MatrixXd> rigid_mass(R.transpose() * MR);
  const auto remove_rigid = [&](VectorXd& u) { u -= R * rigid_mass.solve(MR.transpose() * u); };
  double scale = std::numeric_limits<double>::infinity();
  VectorXd start = VectorXd::Zero(K.rows());
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l) {
        VectorXd field = VectorXd::Zero(model.stiffness.rows());
        for (int j = 0; j < model.node_count(); ++j) {
          const Vector3d x = model.nodes.col(j) - body.centre;
          const Vector3d gradient = Vector3d::Unit(k) * x(l) + Vector3d::Unit(l) * x(k);
          field(6 * j + i) = x(k) * x(l);
          field.segment<3>(6 * j + 3) = 0.5 * gradient.cross(Vector3d(Vector3d::Unit(i)));
        }
        VectorXd u = gathered(field, active);
        const double before = u.dot(M * u);
        remove_rigid(u);
        const double mass = u.dot(M * u);
        const double energy = u.dot(K * u);
        if (!(mass > kRigid * before) || !(energy > 0.0)) continue;
        scale = std::min(scale, energy / mass);
        start += u / std::sqrt(mass);
      }
  if (!(scale < std::numeric_limits<double>::infinity()))
    throw InputError(code::kFeModel, "the model has no stiffness or no mass: no elastic motion was found.");

  Eigen::SimplicialLDLT<Sparse> factor;
  factor.analyzePattern(K + M);
  for (int round = 0; round < kScaleRounds; ++round) {
    factor.factorize(K + scale * M);
    if (factor.info() != Eigen::Success) break;
    for (int iteration = 0; iteration < kScaleIterations; ++iteration) {
      start = factor.solve(M * start).eval();
      remove_rigid(start);
      start /= std::sqrt(start.dot(M * start));
    }
    const double better = start.dot(K * start);
    if (!(better > kScaleFloor * scale)) break;  // only round-off: a mechanism, which is found later
    const bool settled = better > 0.5 * scale;
    scale = std::min(scale, better);
    if (settled) break;
  }
  return scale;
}

VectorXd static_solution(const FeModel& model, const std::vector<int>& fixed, const VectorXd& load) {
  FOOTFALL_DEMAND(load.size() == model.stiffness.rows());
  const std::vector<int> free = other_dofs(active_dofs(model), fixed);
  const Eigen::SparseMatrix<double> K = selected(model.stiffness, free, free);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(K);
  const double largest = K.diagonal().cwiseAbs().maxCoeff();
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 1e-14 * largest))
    throw InputError(code::kSupports,
                     "static solution: the supports leave the body free to move. Fix more degrees of freedom.");
  return scattered(factor.solve(gathered(load, free)), free, load.size());
}

}  // namespace footfall
