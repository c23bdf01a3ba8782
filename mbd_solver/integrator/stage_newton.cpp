// The convergence rate of earlier iterations estimates the remaining error of the first one; it is forgotten gradually, so that
// it is measured again from time to time.

#include "mbd_solver/integrator/stage_newton.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/kinematics.h"

namespace footfall {
namespace {

// An iteration that no longer converges is accepted below this (1 = tolerance).
constexpr double kNoise = 1e-5;
constexpr int kMostIterations = 10;
// A measured rate loses its meaning as the Jacobian ages: without this, stages that end after one iteration would never
// measure it again (as in RADAU5 of Hairer and Wanner).
constexpr double kForgetting = 0.8;
// A stage that converges more slowly than this shows that the matrix belongs to another position: less error may remain then.
constexpr double kSlowStage = 0.02, kStricter = 0.1;

}  // namespace

StageNewton::StageNewton(Equations& equations, const ErrorNorm& norm, IntegratorStatistics& statistics,
                         StepFailure& failure)
    : equations_(equations),
      norm_(norm),
      statistics_(statistics),
      failure_(failure),
      system_(equations, equations.jacobian().negligible_shares()),
      stiff_from_(equations.saddle().has_redundant_rows() ? kStiffIfSingular : kStiff) {
  Ydot_ = F_ = change_ = Eigen::VectorXd::Zero(equations.layout().size());
}

void StageNewton::forget() {
  factored_c_ = 0.0;
  rate_ = 1.0;
  slowest_ = slowest_before_ = 0.0;
  system_.forget();
}

bool StageNewton::needs_jacobian(double c, bool first_stage, double slow) const {
  return factored_c_ == 0.0 || (first_stage && (std::abs(c / factored_c_ - 1.0) > 1e-6 || rate_ > slow));
}

bool StageNewton::refresh(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& K, double c, double slow,
                          const Inputs& inputs) {
  try {
    system_.evaluate(t, y, K, c, inputs);
  } catch (const NumericalError& error) {
    failure_.reason = error.what();
    return false;
  }
  ++statistics_.jacobians;
  ++statistics_.factorizations;
  fresh_ = true;
  rate_ = slow;
  stiffness_ = equations_.jacobian().largest_stiffness(c);
  factored_c_ = system_.factor() ? c : 0.0;
  return factored_c_ != 0.0;
}

bool StageNewton::solve(double t, double c, const Eigen::VectorXd& known, double tolerance, double slow,
                        const Inputs& inputs, Eigen::VectorXd& Y, Eigen::VectorXd& K) {
  const Layout& layout = equations_.layout();
  const int m = layout.lambda0(), rows = layout.row_count, q = layout.q_size, lower = layout.size() - q;
  Ydot_.tail(rows).setZero();
  expected_ = K.tail(rows);
  double last = 0.0;
  rate_ = std::max(rate_, std::min(std::pow(rate_, kForgetting), slow));
  if (stiff_ && std::max(slowest_, slowest_before_) > kSlowStage) tolerance *= kStricter;
  for (int i = 0; i < kMostIterations; ++i) {
    // Positions and rates of the current velocities and states.
    change_.head(q) = Y.head(q);
    solve_positions(layout, known.head(q), Y.segment(q, layout.v_size), c, Y.head(q));
    change_.head(q) -= Y.head(q);
    Ydot_.head(m) = c * (Y - known).head(m);
    try {
      equations_.residual(t, Y, Ydot_, inputs, F_);
      equations_.saddle().expect_multipliers(expected_, F_.tail(rows));
    } catch (const NumericalError& error) {  // a law without a value, which a smaller step may avoid
      failure_.reason = error.what();
      return false;
    }
    ++statistics_.residuals;
    Eigen::Ref<Eigen::VectorXd> x = change_.tail(lower);
    x = F_.tail(lower);
    apply_inverse(x);
    Y.tail(lower) -= x;
    const double size = norm_(change_);
    failure_.worst = norm_.worst(change_);
    if (!std::isfinite(size)) return false;
    bool done = false;
    if (i > 0) {
      rate_ = size / last;
      done = rate_ >= 1.0 && size <= std::max(kNoise, tolerance);
      if (rate_ >= 1.0 && !done) return false;
    }
    last = size;
    // Remaining error: size rate / (1 - rate); the first iteration uses the slowest rate of earlier stages.
    if (i > 0) slowest_ = std::max(slowest_, rate_);
    if (i > 0 && fresh_ && rate_ > kSlowStage && size > kNoise && has_stiff_force()) turns_ = true;
    const double rate = std::min(i > 0 ? rate_ : std::max({rate_, slowest_, slowest_before_}), 0.9);
    if (done || size * rate / (1.0 - rate) <= tolerance) {
      solve_positions(layout, known.head(q), Y.segment(q, layout.v_size), c, Y.head(q));
      K.head(m) = c * (Y - known).head(m);
      K.tail(rows) = Y.tail(rows);
      return true;
    }
  }
  return false;
}

}  // namespace footfall
