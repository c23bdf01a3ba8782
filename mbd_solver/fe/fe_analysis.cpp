#include "mbd_solver/fe/fe_analysis.h"

#include <Eigen/SparseCholesky>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/fe/eigen_solver.h"
#include "mbd_solver/fe/fe_partition.h"

namespace footfall {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd pressure_load(const FeModel& model, double pressure) {
  VectorXd load = VectorXd::Zero(6 * model.node_count());
  for (const Eigen::Vector3i& corner : model.triangles) {
    const Vector3d p = model.nodes.col(corner(0));
    const Vector3d twice_area =
        Vector3d(model.nodes.col(corner(1)) - p).cross(Vector3d(model.nodes.col(corner(2)) - p));
    for (int i = 0; i < 3; ++i) load.segment<3>(6 * corner(i)) -= pressure / 6.0 * twice_area;
  }
  return load;
}

VectorXd static_solution(const FeModel& model, const std::vector<int>& fixed, const VectorXd& load) {
  FOOTFALL_DEMAND(load.size() == 6 * model.node_count());
  const std::vector<int> free = other_dofs(active_dofs(model), fixed);
  const Eigen::SparseMatrix<double> K = selected(model.stiffness, free, free);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(K);
  const double largest = K.diagonal().cwiseAbs().maxCoeff();
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 1e-14 * largest))
    throw InputError("static solution: the supports leave the body free to move. Fix more degrees of freedom.");
  return scattered(factor.solve(gathered(load, free)), free, load.size());
}

VectorXd natural_frequencies(const FeModel& model, const std::vector<int>& fixed, int count) {
  const std::vector<int> free = other_dofs(active_dofs(model), fixed);
  const Eigen::SparseMatrix<double> M = lumped_mass_matrix(model);
  const Modes modes =
      lowest_modes(selected(model.stiffness, free, free), selected(M, free, free), count, elastic_scale(model));
  return modes.lambda.cwiseMax(0.0).cwiseSqrt() / (2.0 * kPi);
}

std::vector<int> node_dofs(int node, const std::vector<int>& components) {
  std::vector<int> dofs;
  for (int component : components) dofs.push_back(6 * node + component);
  return dofs;
}

}  // namespace footfall
