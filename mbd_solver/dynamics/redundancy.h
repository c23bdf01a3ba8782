#pragma once
// Redundant conditions in the equations of motion. k combinations U of the rows of a group of joints are zero in every
// position: U orthonormal, sum_i U_ij phi''_i / s_i = 0; s_i: root mean square of |row| in the metric of the mass over the
// rows of its joint that are lengths, or angles. Multipliers along U
// move nothing, and what the rows contradict each other by (drift, round-off) has no answer. k slacks mu take it up:
//   F_lambda = phi'' + B mu,   F_mu = B^T lambda,   B = diag(s) U
// So lambda is the smallest, sum (s_i lambda_i)^2, of all that hold, and no regularisation steers the motion. U turns
// with the mechanism: it needs to be near the combinations that are zero now, not equal to them, and is brought up to
// date by one step of inverse iteration with the factors of the saddle matrix,
//   [M, Phi_v^T, 0; Phi_v, -eps, B; 0, B^T, 0] [x; y; m] = [0; 0; I]:   y is zero in Phi_v^T,  m = y^T (S + eps) y,
// S = Phi_v M^-1 Phi_v^T. A combination whose m is not small is not zero any more, because the mechanism has left a
// singular position: then U is found anew by QR, and slacks for which nothing is left come to rest, mu = 0.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/dynamics/sparse_blocks.h"

namespace footfall {

class Redundancy {
 public:
  // Slacks are the entries first, first + 1, ... of lambda.
  Redundancy(const RedundantGroup& group, int first);

  // Blocks of B and B^T in a matrix whose rows and columns of lambda start at lambda0.
  struct Places {
    std::vector<SparseBlock> rows_by_slacks, slacks_by_rows;  // per joint
  };
  void announce(SparsePattern& pattern, int lambda0) const;
  void locate(const Eigen::SparseMatrix<double>& matrix, int lambda0, Places& places) const;
  void scatter(double* values, const Places& places) const;
  // F_lambda += B mu, F_mu = B^T lambda - regularisation mu; both in the order of lambda.
  void add_residual(const Eigen::Ref<const Eigen::VectorXd>& lambda,
                    const Eigen::Ref<const Eigen::VectorXd>& regularisation, Eigen::Ref<Eigen::VectorXd> F) const;
  // lambda loses its part along U.
  void make_smallest(Eigen::Ref<Eigen::VectorXd> lambda) const;

  int first() const { return first_; }
  int count() const { return static_cast<int>(B_.cols()); }
  const std::vector<int>& joints() const { return joints_; }
  const std::vector<int>& rows() const { return rows_; }
  const Eigen::VectorXd& s() const { return s_; }
  // U from outside, orthonormal, at most count() columns; slacks beyond them come to rest. s: per row of the group.
  void set(const Eigen::MatrixXd& U, const Eigen::VectorXd& s, Eigen::VectorXd& regularisation);
  // Solution of the inverse iteration for one slack: [y; m] in the order of lambda.
  void take(int slack, const Eigen::Ref<const Eigen::VectorXd>& solution);
  // After take() of all slacks: the new U; kFar: the old one was far from it, better factor again; kLost: find it anew.
  enum class Renewal { kNear, kFar, kLost };
  Renewal renew();

  Places in_lower, in_saddle;

 private:
  bool at_rest(int slack) const { return rest_[static_cast<std::size_t>(slack)] != 0; }

  std::vector<int> joints_;
  std::vector<int> joint_size_;  // rows per joint
  std::vector<int> rows_;        // all rows of all joints, rising; those of one joint are neighbours
  int first_ = 0;
  Eigen::VectorXd s_;  // per row, at the start
  Eigen::MatrixXd U_, B_, Y_, m_, G_;
  std::vector<char> rest_;
};

int redundant_count(const std::vector<RedundantGroup>& groups);

}  // namespace footfall
