#include "mbd_solver/dynamics/redundancy.h"

namespace footfall {

Redundancy::Redundancy(const RedundantGroup& group)
    : joints_(group.joints), rows_(group.rows), count_(static_cast<int>(group.U.cols())), s_(group.s) {
  Y_ = Eigen::MatrixXd::Zero(group.U.rows(), group.U.cols());
  rest(group.U);
}

void Redundancy::rest(const Eigen::MatrixXd& combinations) {
  resting_.clear();
  if (combinations.cols() == 0) return;
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(combinations);
  const Eigen::VectorXi moved_to = lu.permutationP().indices();  // row i is the moved_to[i]-th pivot
  for (Eigen::Index i = 0; i < moved_to.size(); ++i)
    if (moved_to[i] < combinations.cols()) resting_.push_back(static_cast<int>(i));
}

void Redundancy::take(int k, const Eigen::Ref<const Eigen::VectorXd>& y) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    Y_(static_cast<Eigen::Index>(i), k) = s_[static_cast<Eigen::Index>(i)] * y[rows_[i]];
}

}  // namespace footfall
