#pragma once
// All conditions of all joints at one state, sparse, in the metric of the mass matrix:
//   B = D Phi_v C^-T,  M = C C^T,  D scales every row to unit length
// A sparse QR of B^T gives its rank, the smallest corrections, and the rows that follow from others. Time and memory grow with
// the number of bodies for chains and trees; bodies with many joints are split (split_bodies.h).

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <memory>
#include <vector>

#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/dynamics/split_bodies.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// Joints with dependent conditions: k combinations of their rows are zero in all positions nearby,
//   sum_i U_ij phi'_i D_i = 0 for j = 1 .. k
struct RedundantGroup {
  std::vector<int> joints;                // rising
  std::vector<int> joint_size;            // rows per joint
  std::vector<int> rows;                  // all rows of these joints, rising
  Eigen::VectorXd s;                      // per row: mean length of the rows of its joint and unit
  Eigen::MatrixXd U;                      // rows x k, orthonormal
  std::vector<int> dropped;               // k rows that follow from the other rows
  std::vector<std::vector<int>> sources;  // for each of these: joints it follows from
};

class ConstraintRows {
 public:
  ConstraintRows(const Model& model, const Layout& layout);
  ~ConstraintRows();

  void evaluate(const State& state);
  // The smallest change (in the mass metric) of positions or velocities that removes the defects, in the least-squares sense if
  // they contradict each other: -C^-T B^+ D defect. Rows are dependent if their independent part is below `rank_tolerance` of
  // their length.
  Eigen::VectorXd correction(const Eigen::VectorXd& defect, double rank_tolerance);
  // The groups of joints with redundant rows.
  std::vector<RedundantGroup> redundant(double rank_tolerance);
  // Entries of the triangular factor R at this tolerance.
  Eigen::Index factor_entries(double rank_tolerance);

  const Kinematics& kinematics() const { return kinematics_; }
  Eigen::VectorXd phi, rate, scale;  // phi, phi', diagonal of D

 private:
  struct Factors;
  struct Combination;
  // The factors of the current rows: computed once for each tolerance until the rows change.
  Factors& factors(double rank_tolerance);
  bool is_rotor(int row) const;
  std::vector<Combination> combinations(double rank_tolerance);
  // Fills a group, but for its joints, from its combinations.
  void complete(const std::vector<const Combination*>& combinations, RedundantGroup& group) const;
  // Lengths of rows, one for the forces of a joint and one for its moments, so that the smallest reactions do not depend on the
  // directions of its conditions.
  Eigen::VectorXd joint_lengths(const RedundantGroup& group) const;

  const Model& model_;
  const Layout& layout_;
  Kinematics kinematics_;
  SplitBodies split_;
  std::vector<Eigen::MatrixXd> masses_;     // C per body
  Eigen::SparseMatrix<double> transposed_;  // B^T
  std::unique_ptr<Factors> factors_;
};

// Redundant conditions in the equations of motion. k combinations Y of the rows of a group of joints are zero in every
// position: sum_i Y_ij phi''_i = 0. Multipliers along Y cause no motion, and contradictions between the rows (drift, round-off)
// have no solution. Therefore k rows rest: their equation is
//   F_lambda = phi'' - s^2 lambda           s^2: (Phi_v M^-1 Phi_v^T)_ii of the row, or the mean over its joint
// instead of phi'' - eps lambda. They follow from the others: phi'' is their contradiction, and lambda is phi'' over s^2:
// round-off. The matrix does not grow. The choice of resting rows is a choice of basis and does not influence the motion as
// long as the combinations in that basis, Y = 1 in their own row, are of moderate size. They are the solution of
//   [M, Phi_v^T; Phi_v, -eps; -s^2 where a row rests] [x; y] = [0; -s^2 e]
// One such solve for all resting rows together gives their size; if it is too large, each is solved for, and other rows are
// selected (pivots of Y). |x| in the metric of the mass shows whether they are still zero: if not, the mechanism has left a
// singular position, and redundant combinations are found again by QR.
class Redundancy {
 public:
  explicit Redundancy(const RedundantGroup& group);

  const std::vector<int>& joints() const { return joints_; }
  const std::vector<int>& rows() const { return rows_; }        // all rows of all joints, rising
  const Eigen::VectorXd& s() const { return s_; }               // per row of the group, at the start
  const std::vector<int>& resting() const { return resting_; }  // places in rows()
  int count() const { return count_; }                          // combinations at the start
  // Lets the pivots of `combinations` (rows of the group times s by combinations, independent) rest.
  void rest(const Eigen::MatrixXd& combinations);
  // Sets a column of Y: y, in the order of lambda, of resting row k; after all columns, reselect().
  void set_combination(int k, const Eigen::Ref<const Eigen::VectorXd>& y);
  void reselect() { rest(Y_.leftCols(static_cast<Eigen::Index>(resting_.size()))); }

 private:
  std::vector<int> joints_, rows_, resting_;
  int count_ = 0;
  Eigen::VectorXd s_;
  Eigen::MatrixXd Y_;
};

}  // namespace footfall
