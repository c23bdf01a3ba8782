#pragma once
// Statics of a finite-element model on supports, the reference for reduced models; parts of matrices by degree of freedom,
// and rigid-body motions.

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <vector>

#include "mbd_solver/fe/fe_model.h"

namespace footfall {

// Degrees of freedom with stiffness or mass, ascending; rotations of solid models have neither.
std::vector<int> active_dofs(const FeModel& model);
// Members of `all` (ascending) that are not in `excluded`.
std::vector<int> other_dofs(const std::vector<int>& all, const std::vector<int>& excluded);

Eigen::SparseMatrix<double> selected(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& rows,
                                     const std::vector<int>& columns);
// Rows of x; and their places in a matrix of zeros.
Eigen::MatrixXd gathered(const Eigen::MatrixXd& x, const std::vector<int>& rows);
Eigen::MatrixXd scattered(const Eigen::MatrixXd& x, const std::vector<int>& rows, Eigen::Index size);

// 6N x 6: unit translations, then unit rotations about the point [1, m, rad]. Rotational rows are zero in a model without
// rotations.
Eigen::MatrixXd rigid_motions(const FeModel& model, const Eigen::Vector3d& centre);

// An upper bound of the order of the first elastic lambda of the free body [1/s2]: shift of eigenproblems and measure of "no
// stiffness".
double elastic_scale(const FeModel& model);

// 6N displacements [m, rad] under the load (6N), with the listed degrees of freedom (6 j + i) held at zero. Throws InputError
// if the supports leave the body free to move.
Eigen::VectorXd static_solution(const FeModel& model, const std::vector<int>& fixed, const Eigen::VectorXd& load);

}  // namespace footfall
