#pragma once
// The Jacobian of the equations of motion F(t, y, dy/dt) (equations.h), dF/dy + c dF/dydot, gathered over [v; z; lambda] by
// increments dx = [dr; dtheta; da] and by velocities; q is eliminated by dq = N v at the rate c:
//   dx = T dv,  T = diag(1/c, (c I + w~/2) / (c^2 + |w|^2 / 4), 1/c).
// No function allocates, but for those that return a vector.

#include <Eigen/Sparse>
#include <vector>

#include "mbd_solver/dynamics/condensed_matrix.h"
#include "mbd_solver/dynamics/evaluation.h"
#include "mbd_solver/dynamics/jacobian_pattern.h"

namespace footfall {

class SaddleSystem;

struct Baumgarte {
  double alpha = 0.0;  // [1/s]
  double beta = 0.0;   // [1/s]
};

class Jacobian {
 public:
  // All must outlive this object.
  Jacobian(Evaluation& evaluation, const SaddleSystem& saddle, const Baumgarte& baumgarte);

  // At (t, y, ydot), with the rows F_q and the columns q eliminated by c dq = N dv + (dN v): square in [v; z; lambda],
  // column-major, compressed, of constant pattern; values are rewritten in place. The remaining part of a right-hand
  // side with F_q != 0 is in ReducedSystem.
  const Eigen::SparseMatrix<double>& evaluate(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                              const Eigen::Ref<const Eigen::VectorXd>& ydot, double c,
                                              const Inputs& inputs);
  // The rest belongs to the last evaluate(). The same matrix:
  const Eigen::SparseMatrix<double>& matrix() const { return pattern_.reduced; }
  // Per velocity, the contribution of its body alone to the diagonal, reduced at c: c M_ii, of a mode c M_ii + C_i + K_i / c.
  const Eigen::VectorXd& own_diagonal() const { return own_diagonal_; }
  // Largest stiffness of a velocity's own position over its inertia, K_ii / (c own_i): (gamma h)^2 K / M.
  double largest_stiffness(double c) const;
  // Per velocity, the share of own_diagonal() below which Newton may neglect an entry of its row (ThinLu).
  Eigen::VectorXd negligible_shares() const;
  // Inner states of elements with many, each of which acts on few others: unknowns of the matrix.
  std::vector<LocalUnknowns> local_states() const;
  // out -= d[F_v; F_z; F_lambda]/dx dx. dx as v; out as [v; z; lambda].
  void subtract_stiffness(const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> out) const;

 private:
  void gather(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::Ref<const Eigen::VectorXd>& ydot,
              double c, const Inputs& inputs);
  void add_body(int index, double c, const Inputs& inputs);
  void add_joint(int index, double t, double c, const Eigen::Ref<const Eigen::VectorXd>& lambda);
  void add_force(int index, double t, const Eigen::Ref<const Eigen::VectorXd>& z, const Eigen::VectorXd& input_values);
  void add_signals(double t, const Eigen::Ref<const Eigen::VectorXd>& y);

  Evaluation& at_;
  const Model& model_;
  const Layout& layout_;
  const SaddleSystem& saddle_;
  Baumgarte baumgarte_;
  JacobianPattern pattern_;
  Eigen::VectorXd own_diagonal_;
  // Scratch.
  std::vector<ElementDerivatives> elements_;  // per force element
  Eigen::VectorXd row_, row2_, row3_, row4_;  // local rows of the largest pair
  RowScratch row_scratch_;                    // of the largest pair
  Eigen::MatrixXd K_, D_, M_;                 // local matrices of the largest pair or body
};

}  // namespace footfall
