#pragma once
// Parts of a finite-element model by degree of freedom, and its rigid-body motions: tools of fe_analysis and
// modal_basis.

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <vector>

#include "mbd_solver/fe/fe_model.h"

namespace footfall {

// Degrees of freedom with stiffness or mass, ascending; others (rotations of solid models) do not take part.
std::vector<int> active_dofs(const FeModel& model);
// Members of `all` (ascending) that are not in `excluded`.
std::vector<int> other_dofs(const std::vector<int>& all, const std::vector<int>& excluded);

Eigen::SparseMatrix<double> selected(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& rows,
                                     const std::vector<int>& columns);
// Rows of x; and back into zeros.
Eigen::MatrixXd gathered(const Eigen::MatrixXd& x, const std::vector<int>& rows);
Eigen::MatrixXd scattered(const Eigen::MatrixXd& x, const std::vector<int>& rows, Eigen::Index size);

// 6N x 6: unit translations, then unit rotations about the point [1, m, rad]. Rotational rows are zero in a
// model without rotations.
Eigen::MatrixXd rigid_motions(const FeModel& model, const Eigen::Vector3d& centre);

// The size of the first elastic lambda of the free body, from above [1/s2]: shift of eigenproblems and
// measure of "no stiffness".
double elastic_scale(const FeModel& model);

}  // namespace footfall
