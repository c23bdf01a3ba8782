#pragma once
// Bodies with many joints, for a sparse QR of the rows of all joints. The rows of two joints on one body are adjacent, so
// that the factor of a body with n joints would have n^2 entries. Such a body is replaced by copies that share its mass and
// a few of its joints each; links hold each copy to the one before. With u = C^T v of a body whose mass matrix is C C^T, and
// c copies:
//   u_k = u / sqrt(c),   row on its copy: sqrt(c) C^-1 Phi_v,   link: (u_k - u_k+1) / sqrt(2) = 0
// Copies that move together have the motions, the metric and the combinations of rows of the body.

#include <Eigen/Sparse>
#include <map>
#include <utility>
#include <vector>

#include "mbd_solver/dynamics/kinematics.h"

namespace footfall {

class SplitBodies {
 public:
  SplitBodies(const Model& model, const Layout& layout);

  bool any() const { return !copied_.empty(); }
  // The columns of `transposed`, one per row of a joint over [u of all bodies], on copies; then one column per link.
  Eigen::SparseMatrix<double> split(const Eigen::SparseMatrix<double>& transposed) const;
  // u of all bodies from u of the copies: their mean.
  Eigen::VectorXd joined(const Eigen::VectorXd& u) const;

 private:
  struct Copied {
    int u = 0, size = 0;       // place of the body in u, number of its velocities
    int first = 0, count = 0;  // place of its first copy, which the others follow; number of copies
  };

  std::vector<Copied> copied_;
  std::vector<int> place_;  // of each velocity with copies; of a copied body: -1 - its index
  std::map<std::pair<int, std::size_t>, int> copy_of_;  // (row, index in copied_): the copy that it acts on
  int size_ = 0;                                        // velocities with copies
};

}  // namespace footfall
