#include "mbd_solver/fe/fe_check.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/fe/fe_partition.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kSymmetric = 1e-6;    // largest |K - K^T| over largest |K|: files print six digits or more
constexpr double kUnsupported = 1e-6;  // force of a rigid-body motion over the sum of its parts' magnitudes, likewise
constexpr double kMassRank = 1e-12;    // singular below this fraction of the largest eigenvalue

void check_mass(const FeModel& model, const std::string& who) {
  const std::string not_positive = who + ": mass matrix is not positive: ";
  for (int j = 0; j < model.node_count(); ++j) {
    if (!(model.node_mass(j) >= 0.0))
      throw InputError(not_positive + "node " + std::to_string(j) + " has the mass " +
                       std::to_string(model.node_mass(j)) + " kg, expected 0 or more.");
    const Matrix3d& J = model.node_inertia[static_cast<std::size_t>(j)];
    const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(J, Eigen::EigenvaluesOnly).eigenvalues();
    if (!(moments.minCoeff() >= -kMassRank * moments.cwiseAbs().maxCoeff()))
      throw InputError(not_positive + "node " + std::to_string(j) + " has a rotary inertia with the principal value " +
                       std::to_string(moments.minCoeff()) + " kg m2, expected 0 or more.");
  }
  if (!(model.node_mass.sum() > 0.0)) throw InputError(not_positive + "the body has no mass.");
  const Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(mass_properties(model).inertia, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(moments.minCoeff() > kMassRank * moments.maxCoeff()))
    throw InputError(not_positive +
                     "the body has no inertia about one of its axes, expected nodes that are not all in one "
                     "line, or nodes "
                     "with rotary inertia.");
}

// Nodes that the stiffness couples are one piece.
void check_connected(const FeModel& model, const std::string& who) {
  std::vector<bool> reached(static_cast<std::size_t>(model.node_count()), false);
  std::vector<int> todo = {0};
  reached[0] = true;
  while (!todo.empty()) {
    const int node = todo.back();
    todo.pop_back();
    for (int i = 0; i < 6; ++i)
      for (Sparse::InnerIterator it(model.stiffness, 6 * node + i); it; ++it) {
        const int other = static_cast<int>(it.row() / 6);
        if (it.value() == 0.0 || reached[static_cast<std::size_t>(other)]) continue;
        reached[static_cast<std::size_t>(other)] = true;
        todo.push_back(other);
      }
  }
  const auto missing = std::find(reached.begin(), reached.end(), false);
  if (missing != reached.end())
    throw InputError(who + ": disconnected pieces: no stiffness leads from node 0 to node " +
                     std::to_string(missing - reached.begin()) + ", expected a body of one piece.");
}

void check_free(const FeModel& model, const std::string& who) {
  const MatrixXd R = rigid_motions(model, mass_properties(model).centre);
  const Sparse magnitude = model.stiffness.cwiseAbs();
  for (int k = 0; k < 6; ++k) {
    const double force = (model.stiffness * R.col(k)).norm();
    const double parts = (magnitude * R.col(k).cwiseAbs()).norm();
    if (!(force <= kUnsupported * parts))
      throw InputError(who + ": the stiffness matrix resists " + (k < 3 ? "translation along " : "rotation about ") +
                       std::string(1, "xyz"[k % 3]) + " of the whole body (relative force " +
                       std::to_string(force / parts) +
                       "), expected a free body. Remove its supports; joints are given in the scene.");
  }
}

}  // namespace

void check_model(const FeModel& model, const std::string& who) {
  const Index n = model.node_count();
  FOOTFALL_DEMAND(model.node_mass.size() == n && static_cast<Index>(model.node_inertia.size()) == n);
  FOOTFALL_DEMAND(model.stiffness.rows() == 6 * n && model.stiffness.cols() == 6 * n);
  if (n == 0) throw InputError(who + ": the model has no nodes.");
  check_mass(model, who);
  const VectorXd diagonal = model.stiffness.diagonal();
  for (int j = 0; j < n; ++j)
    if (!(diagonal.segment<3>(6 * j).minCoeff() > 0.0))
      throw InputError(who + ": node " + std::to_string(j) +
                       " has no stiffness against some displacement: it belongs to no element, so no joint "
                       "can attach to it.");
  const Sparse skewed = model.stiffness - Sparse(model.stiffness.transpose());
  if (!(skewed.norm() <= kSymmetric * model.stiffness.norm()))
    throw InputError(who + ": the stiffness matrix is not symmetric.");
  check_connected(model, who);
  check_free(model, who);
}

void check_interface(const FeModel& model, const std::vector<int>& nodes, const std::string& who) {
  for (int node : nodes)
    if (node < 0 || node >= model.node_count())
      throw InputError(who + ": interface node " + std::to_string(node) +
                       " does not exist, so no joint can attach to it; expected 0 to " +
                       std::to_string(model.node_count() - 1) + ".");
}

}  // namespace footfall
