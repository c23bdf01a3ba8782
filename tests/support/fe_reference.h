#pragma once
// A straight beam, and statics and vibration of a finite-element model on supports: the reference for reduced models.

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/eigen_solver.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/fe_model.h"

namespace footfall::test {

// Nodes 0..n from one end to the other, n + 1 ... 2 n the middles of the n elements.
inline FeModel straight_beam(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int n, const BeamSection& section,
                             const Material& material) {
  std::vector<Eigen::Vector3d> nodes;
  std::vector<BeamMember> members;
  for (int i = 0; i <= n; ++i) {
    nodes.push_back(from + (to - from) * (static_cast<double>(i) / n));
    if (i > 0) {
      BeamMember member;
      member.first = i - 1;
      member.second = i;
      members.push_back(member);
    }
  }
  return beam_model(nodes, members, {section}, material);
}

// Six numbers per node: forces [N] and moments [N m] at the nodes of a pressure [Pa] on all triangles against their normals.
inline Eigen::VectorXd pressure_load(const FeModel& model, double pressure) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(model.stiffness.rows());
  for (const Eigen::Vector3i& corner : model.triangles) {
    const Eigen::Vector3d a = model.nodes.col(corner(0)), b = model.nodes.col(corner(1)),
                          c = model.nodes.col(corner(2));
    for (int i = 0; i < 3; ++i) load.segment<3>(6 * corner(i)) -= pressure / 6.0 * (b - a).cross(c - a);
  }
  return load;
}

// The lowest natural frequencies on these supports [Hz]; a free body has six zeros first.
inline Eigen::VectorXd natural_frequencies(const FeModel& model, const std::vector<int>& fixed, int count) {
  const std::vector<int> free = other_dofs(active_dofs(model), fixed);
  const Eigen::SparseMatrix<double> M = mass_matrix(model);
  const Modes modes =
      lowest_modes(selected(model.stiffness, free, free), selected(M, free, free), count, elastic_scale(model));
  return modes.lambda.cwiseMax(0.0).cwiseSqrt() / (2.0 * kPi);
}

// The six degrees of freedom of a node, or only the given components (0..5).
inline std::vector<int> node_dofs(int node, const std::vector<int>& components = {0, 1, 2, 3, 4, 5}) {
  std::vector<int> dofs;
  for (const int component : components) dofs.push_back(6 * node + component);
  return dofs;
}

}  // namespace footfall::test
