#pragma once
// The analytic Jacobian of a whole system against central differences of its residual.

#include <Eigen/LU>
#include <string>

#include "mbd_solver/dynamics/equations.h"

namespace footfall::test {

// dF/dy + c dF/dydot of all of y, from the reduced Jacobian and the derivatives by increments of positions that it holds.
inline Eigen::MatrixXd whole_jacobian(Equations& equations, double t, const Eigen::VectorXd& y,
                                      const Eigen::VectorXd& ydot, double c, const Inputs& inputs) {
  const Layout& layout = equations.layout();
  const int nq = layout.q_size, nv = layout.v_size, lower = layout.size() - nq;
  const Eigen::VectorXd q = y.head(nq), v = y.segment(nq, nv);
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(layout.size(), layout.size());
  J.bottomRightCorner(lower, lower) = Eigen::MatrixXd(equations.jacobian().evaluate(t, y, ydot, c, inputs));
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(lower, nv);  // by increments
  for (int j = 0; j < nv; ++j) {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(lower);
    equations.jacobian().subtract_stiffness(Eigen::VectorXd::Unit(nv, j), column);
    K.col(j) = -column;
  }
  Eigen::VectorXd dq(nq), dx(nv);
  Eigen::MatrixXd inverse(nq, nq);
  for (int j = 0; j < nq; ++j) {
    to_increments(layout, q, Eigen::VectorXd::Unit(nq, j), dx);
    J.block(nq, j, lower, 1) = K * dx;
    dq = Eigen::VectorXd::Unit(nq, j);
    solve_position_rows(layout, v, c, dq);
    inverse.col(j) = dq;
  }
  J.topLeftCorner(nq, nq) = inverse.inverse();
  for (int j = 0; j < nv; ++j) {
    from_increments(layout, q, Eigen::VectorXd::Unit(nv, j), dq);
    J.block(0, nq + j, nq, 1) = -dq;
    solve_position_rows(layout, v, c, dq);
    to_increments(layout, q, dq, dx);
    J.block(nq, nq + j, lower, 1) -= K * dx;
  }
  return J;
}

// Largest difference between the analytic matrix dF/dy + c dF/dydot and central differences, relative to the
// largest entry.
inline double jacobian_error(Equations& equations, const Eigen::VectorXd& y, const Eigen::VectorXd& ydot, double c,
                             const Inputs& inputs, std::string* where) {
  const Eigen::Index n = y.size();
  const Eigen::MatrixXd analytic = whole_jacobian(equations, 0.3, y, ydot, c, inputs);
  Eigen::VectorXd plus(n), minus(n);
  const double step = 4e-7;
  double largest = 0.0;
  const auto difference = [&](Eigen::Index j, double h) -> Eigen::VectorXd {
    Eigen::VectorXd y1 = y, y2 = y, yd1 = ydot, yd2 = ydot;
    y1[j] += h;
    y2[j] -= h;
    yd1[j] += c * h;
    yd2[j] -= c * h;
    equations.residual(0.3, y1, yd1, inputs, plus);
    equations.residual(0.3, y2, yd2, inputs, minus);
    return (plus - minus) / (2.0 * h);
  };
  for (Eigen::Index j = 0; j < n; ++j) {
    // Richardson: without the error of step^2, with the curvature of stops, friction and soils; round-off remains, some 1e-9.
    const Eigen::VectorXd column = (4.0 * difference(j, step) - difference(j, 2.0 * step)) / 3.0;
    Eigen::Index row = 0;
    const double error = (column - analytic.col(j)).cwiseAbs().maxCoeff(&row);
    if (error > largest) {
      largest = error;
      *where = equations.entry_name(static_cast<int>(row)) + " by " + equations.entry_name(static_cast<int>(j));
    }
  }
  return largest / analytic.cwiseAbs().maxCoeff();
}

}  // namespace footfall::test
