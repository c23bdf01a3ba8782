#pragma once
// The linear systems of Newton's method, J x = r with J = dF/dy + c dF/dydot, over [v; z; lambda] alone. The rows dq - N v give
// the positions, D dq = r_q + N dv with D = c I - d(N v)/dq, block-diagonal with closed inverse:
//   (J_v + K X D^-1 N) dv + J_z dz + J_lambda dlambda = r - K X D^-1 r_q,   dq = D^-1 (r_q + N dv),
// K by increments dx = X dq of positions. Inner states of elements with many of them are eliminated, too (CondensedMatrix).

#include "mbd_solver/dynamics/condensed_matrix.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/sparse_lu.h"

namespace footfall {

class ReducedSystem {
 public:
  // `share`: entries that Newton may neglect (ThinLu), per velocity. The equations must outlive this object.
  ReducedSystem(Equations& equations, const Eigen::VectorXd& share);

  // J at (t, y, ydot). Throws NumericalError where a law has no value.
  void evaluate(double t, const Eigen::VectorXd& y, const Eigen::Ref<const Eigen::VectorXd>& ydot, double c,
                const Inputs& inputs);
  // Its factors. False: the matrix is singular or not finite.
  bool factor();
  // x = J^-1 x over [v; z; lambda], where r_q = 0.
  void solve(Eigen::Ref<Eigen::VectorXd> x) {
    matrix_.solve(x, [this](Eigen::Ref<Eigen::VectorXd> y) { lu_.solve(y); });
  }
  // x = J^-1 x over [q; v; z; lambda]. The last Jacobian of the equations must come from evaluate().
  void solve_whole(Eigen::Ref<Eigen::VectorXd> x);
  // The next factor() selects entries and pivots from the values alone.
  void forget() { lu_.forget(); }

 private:
  Equations& equations_;
  CondensedMatrix matrix_;
  ThinLu lu_;
  double c_ = 0.0;
  Eigen::VectorXd at_;       // y of the last evaluate()
  Eigen::VectorXd dx_, dq_;  // scratch
};

}  // namespace footfall
