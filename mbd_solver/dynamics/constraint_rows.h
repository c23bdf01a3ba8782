#pragma once
// All conditions of all joints at one state, sparse, in the metric of the mass matrix:
//   B = D Phi_v C^-T,  M = C C^T,  D scales every row to unit length
// and what a sparse QR of B^T tells: its rank, the smallest corrections, and the rows that follow from others. Time and
// memory grow with the number of bodies for chains and trees.

#include <Eigen/Sparse>
#include <vector>

#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// Joints whose conditions depend on each other: k combinations of their rows are zero in every position nearby,
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

  void evaluate(const State& state);
  // The smallest change (in the mass metric) of positions or velocities that removes the defects, in the sense of least
  // squares where they contradict each other: -C^-T B^+ D defect. Rows count as dependent when what is new in them is
  // below `rank_tolerance` of their length.
  Eigen::VectorXd correction(const Eigen::VectorXd& defect, double rank_tolerance) const;
  // The groups of joints with redundant rows.
  std::vector<RedundantGroup> redundant(double rank_tolerance) const;

  const Kinematics& kinematics() const { return kinematics_; }
  Eigen::VectorXd phi, rate, scale;  // phi, phi', diagonal of D

 private:
  // Lengths of rows, one for the forces of a joint and one for its moments, so that the smallest reactions do not
  // depend on the directions in which its conditions are written.
  Eigen::VectorXd joint_lengths(const RedundantGroup& group) const;

  const Model& model_;
  const Layout& layout_;
  Kinematics kinematics_;
  std::vector<Eigen::MatrixXd> factors_;    // C per body
  Eigen::SparseMatrix<double> transposed_;  // B^T
};

}  // namespace footfall
