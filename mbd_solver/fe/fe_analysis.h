#pragma once
// Statics and vibration of a finite-element model on supports, without any reduction: the reference for
// reduced models.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/fe/fe_model.h"

namespace footfall {

// Six numbers per node: forces [N] and moments [N m] at the nodes of a pressure [Pa] that acts on all
// triangles against their normals.
Eigen::VectorXd pressure_load(const FeModel& model, double pressure);

// 6N displacements [m, rad] under the load (6N), with the listed degrees of freedom (6 j + i) held at zero.
// Throws InputError when the supports leave the body free to move.
Eigen::VectorXd static_solution(const FeModel& model, const std::vector<int>& fixed, const Eigen::VectorXd& load);

// The lowest natural frequencies on these supports [Hz]; a free body has six zeros first.
Eigen::VectorXd natural_frequencies(const FeModel& model, const std::vector<int>& fixed, int count);

// The six degrees of freedom of a node, or those of the given components (0..5).
std::vector<int> node_dofs(int node, const std::vector<int>& components = {0, 1, 2, 3, 4, 5});

}  // namespace footfall
