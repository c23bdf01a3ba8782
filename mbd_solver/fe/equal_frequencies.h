#pragma once
// Modes of one frequency, as the two bendings of a round rod: any combinations of them are modes as well, and round-off would
// choose. Those are taken that move along one principal axis of the body each, if there are such. Then a rod has the same modes
// in every direction, a count that takes one of a pair takes the same one, and most sums over two modes are zero
// (model/column_groups.h).

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "mbd_solver/fe/fe_model.h"

namespace footfall {

constexpr double kOneFrequency = 1e-9;  // relative: lambdas nearer than this are one

// sum_i i e_i e_i^T, i = 1, 2, 3: tells motions along the principal axes e_i apart.
Eigen::Matrix3d axis_weight(const Eigen::Matrix3d& principal_axes);

// W, 6N x 6N: the node's mass times axis_weight for its displacement, nothing for its rotation [kg].
Eigen::SparseMatrix<double> axis_weights(const FeModel& model);

// Y (s x s, orthogonal): shapes X Y move along one axis each, where modes of one frequency can. lambda: s, rising [1/s2];
// B = X^T W X, s x s. Within each group of one frequency Y holds eigenvectors of B, if its eigenvalues are apart; elsewhere Y
// is the identity.
Eigen::MatrixXd along_axes(const Eigen::VectorXd& lambda, const Eigen::MatrixXd& B);

}  // namespace footfall
