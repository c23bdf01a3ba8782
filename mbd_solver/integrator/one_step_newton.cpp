// Newton's method on the equations of one stage, with a Jacobian that serves many steps.
#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/integrator/one_step.h"

namespace footfall {
namespace {

// An iteration that no longer falls is done where it has left no more than this (1 = tolerance).
constexpr double kNoise = 1e-5;
constexpr int kMostIterations = 10;
// A rate that was measured once says less and less about a Jacobian that grows old: without this, stages that end after
// one iteration would never measure it again (as in RADAU5 of Hairer and Wanner).
constexpr double kForgetting = 0.8;

}  // namespace

bool OneStep::refresh(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& K, double c, const Inputs& inputs) {
  try {
    equations_.reduced_jacobian(t, y, K, c, inputs);
  } catch (const NumericalError& error) {
    complaint_ = error.what();
    return false;
  }
  ++statistics_.jacobians;
  ++statistics_.factorizations;
  fresh_ = true;
  rate_ = slow();
  factored_c_ = lu_.factor(equations_.own_diagonal()) ? c : 0.0;
  return factored_c_ != 0.0;
}

bool OneStep::solve_stage(int stage, double t, double h, const Inputs& inputs) {
  const Layout& layout = equations_.layout();
  const int m = layout.lambda0(), rows = layout.row_count, q = layout.q_size, lower = layout.size() - q;
  const double c = 1.0 / (h * tableau_->gamma);
  Eigen::VectorXd& Y = Y_[static_cast<std::size_t>(stage)];
  Eigen::VectorXd& K = K_[static_cast<std::size_t>(stage)];
  Ydot_.tail(rows).setZero();
  expected_ = K.tail(rows);
  double last = 0.0;
  rate_ = std::max(rate_, std::min(std::pow(rate_, kForgetting), slow()));
  for (int i = 0; i < kMostIterations; ++i) {
    // Positions and rates of the present velocities and states.
    change_.head(q) = Y.head(q);
    solve_positions(layout, known_.head(q), Y.segment(q, layout.v_size), c, Y.head(q));
    change_.head(q) -= Y.head(q);
    Ydot_.head(m) = c * (Y - known_).head(m);
    try {
      equations_.residual(t, Y, Ydot_, inputs, F_);
      equations_.saddle().expect_multipliers(expected_, F_.tail(rows));
    } catch (const NumericalError& error) {  // a law without a value there: a smaller step may stay clear of it
      complaint_ = error.what();
      return false;
    }
    ++statistics_.residuals;
    Eigen::Ref<Eigen::VectorXd> x = change_.tail(lower);
    x = F_.tail(lower);
    lu_.solve(x);
    Y.tail(lower) -= x;
    const double size = norm_(change_);
    worst_ = norm_.worst(change_);
    if (!std::isfinite(size)) return false;
    bool done = false;
    if (i > 0) {
      rate_ = size / last;
      done = rate_ >= 1.0 && size <= std::max(kNoise, newton_tolerance_);
      if (rate_ >= 1.0 && !done) return false;
    }
    last = size;
    // What is still missing: size rate / (1 - rate); the rate of the stage before serves the first iteration.
    const double rate = std::min(rate_, 0.9);
    if (done || size * rate / (1.0 - rate) <= newton_tolerance_) {
      solve_positions(layout, known_.head(q), Y.segment(q, layout.v_size), c, Y.head(q));
      K.head(m) = c * (Y - known_).head(m);
      K.tail(rows) = Y.tail(rows);
      return true;
    }
  }
  return false;
}

}  // namespace footfall
