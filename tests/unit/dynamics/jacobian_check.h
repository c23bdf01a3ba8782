#pragma once
// The analytic Jacobian of a whole system against central differences of its residual.

#include <string>

#include "mbd_solver/dynamics/equations.h"

namespace footfall::test {

// Largest difference between the analytic matrix dF/dy + c dF/dydot and central differences, relative to the
// largest entry.
inline double jacobian_error(Equations& equations, const Eigen::VectorXd& y, const Eigen::VectorXd& ydot, double c,
                             const Inputs& inputs, std::string* where) {
  const Eigen::Index n = y.size();
  const Eigen::MatrixXd analytic = equations.jacobian(0.3, y, ydot, c, inputs);
  Eigen::VectorXd plus(n), minus(n);
  const double step = 4e-7;  // error of the difference: of order step^2 (truncation, with the curvature of stops and
                             // friction) and 1e-16 / step (round-off), both some 1e-10 here
  double largest = 0.0;
  for (Eigen::Index j = 0; j < n; ++j) {
    Eigen::VectorXd y1 = y, y2 = y, yd1 = ydot, yd2 = ydot;
    y1[j] += step;
    y2[j] -= step;
    yd1[j] += c * step;
    yd2[j] -= c * step;
    equations.residual(0.3, y1, yd1, inputs, plus);
    equations.residual(0.3, y2, yd2, inputs, minus);
    const Eigen::VectorXd column = (plus - minus) / (2.0 * step);
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
