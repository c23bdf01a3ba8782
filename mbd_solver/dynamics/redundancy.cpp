#include "mbd_solver/dynamics/redundancy.h"

#include <cmath>

namespace footfall {
namespace {

// Combinations of unit rows with a length (squared) above this are not zero any more; drift is far below.
constexpr double kIndependent = 1e-8;
// |y| = 1 / cos of the angle between the old U and the new.
constexpr double kTurned = 2.0;

}  // namespace

int redundant_count(const std::vector<RedundantGroup>& groups) {
  int count = 0;
  for (const RedundantGroup& group : groups) count += static_cast<int>(group.U.cols());
  return count;
}

Redundancy::Redundancy(const RedundantGroup& group, int first)
    : joints_(group.joints), joint_size_(group.joint_size), rows_(group.rows), first_(first) {
  const Eigen::Index m = group.U.rows(), k = group.U.cols();
  s_ = Eigen::VectorXd::Ones(m);
  U_ = B_ = Y_ = Eigen::MatrixXd::Zero(m, k);
  m_ = G_ = Eigen::MatrixXd::Zero(k, k);
  rest_.assign(static_cast<std::size_t>(k), 0);
}

void Redundancy::announce(SparsePattern& pattern, int lambda0) const {
  std::size_t row = 0;
  for (int size : joint_size_) {
    pattern.add_block(lambda0 + rows_[row], size, lambda0 + first_, count());
    pattern.add_block(lambda0 + first_, count(), lambda0 + rows_[row], size);
    row += static_cast<std::size_t>(size);
  }
}

void Redundancy::locate(const Eigen::SparseMatrix<double>& matrix, int lambda0, Places& places) const {
  std::size_t row = 0;
  for (int size : joint_size_) {
    places.rows_by_slacks.emplace_back(matrix, lambda0 + rows_[row], size, lambda0 + first_, count());
    places.slacks_by_rows.emplace_back(matrix, lambda0 + first_, count(), lambda0 + rows_[row], size);
    row += static_cast<std::size_t>(size);
  }
}

void Redundancy::scatter(double* values, const Places& places) const {
  Eigen::Index row = 0;
  for (std::size_t j = 0; j < joint_size_.size(); ++j) {
    for (int k = 0; k < count(); ++k) {
      for (int i = 0; i < joint_size_[j]; ++i) {
        places.rows_by_slacks[j].add(values, i, k, B_(row + i, k));
        places.slacks_by_rows[j].add(values, k, i, B_(row + i, k));
      }
    }
    row += joint_size_[j];
  }
}

void Redundancy::add_residual(const Eigen::Ref<const Eigen::VectorXd>& lambda,
                              const Eigen::Ref<const Eigen::VectorXd>& regularisation,
                              Eigen::Ref<Eigen::VectorXd> F) const {
  for (int k = 0; k < count(); ++k) {
    const int slack = first_ + k;
    const double mu = lambda[slack];
    double sum = -regularisation[slack] * mu;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double b = B_(static_cast<Eigen::Index>(i), k);
      F[rows_[i]] += b * mu;
      sum += b * lambda[rows_[i]];
    }
    F[slack] = sum;
  }
}

void Redundancy::make_smallest(Eigen::Ref<Eigen::VectorXd> lambda) const {
  for (int k = 0; k < count(); ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < rows_.size(); ++i) sum += B_(static_cast<Eigen::Index>(i), k) * lambda[rows_[i]];
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Eigen::Index row = static_cast<Eigen::Index>(i);
      lambda[rows_[i]] -= sum * U_(row, k) / s_[row];
    }
  }
}

void Redundancy::set(const Eigen::MatrixXd& U, const Eigen::VectorXd& s, Eigen::VectorXd& regularisation) {
  s_ = s;
  U_.setZero();
  U_.leftCols(U.cols()) = U;
  B_ = s_.asDiagonal() * U_;
  for (int k = 0; k < count(); ++k) {
    rest_[static_cast<std::size_t>(k)] = k >= U.cols();
    regularisation[first_ + k] = at_rest(k) ? -1.0 : 0.0;
  }
}

void Redundancy::take(int slack, const Eigen::Ref<const Eigen::VectorXd>& solution) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    Y_(static_cast<Eigen::Index>(i), slack) = s_[static_cast<Eigen::Index>(i)] * solution[rows_[i]];
  m_.col(slack) = solution.segment(first_, count());
}

Redundancy::Renewal Redundancy::renew() {
  int moving = 0;  // slacks at rest stand behind the others
  while (moving < count() && !at_rest(moving)) ++moving;
  if (moving == 0) return Renewal::kNear;
  Eigen::Ref<Eigen::MatrixXd> Y = Y_.leftCols(moving);
  Eigen::Ref<Eigen::MatrixXd> G = G_.topLeftCorner(moving, moving);
  G.noalias() = Y.transpose() * Y;
  const double longest = G.diagonal().maxCoeff();
  if (!std::isfinite(longest) || !(m_.topLeftCorner(moving, moving).diagonal().maxCoeff() <= kIndependent * longest))
    return Renewal::kLost;
  // Y = U L^T with G = L L^T.
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factors(G);
  if (factors.info() != Eigen::Success) return Renewal::kLost;
  factors.matrixU().solveInPlace<Eigen::OnTheRight>(Y);
  U_.leftCols(moving) = Y;
  B_ = s_.asDiagonal() * U_;
  return longest < kTurned * kTurned ? Renewal::kNear : Renewal::kFar;
}

}  // namespace footfall
