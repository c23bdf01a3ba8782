#include "mbd_solver/integrator/one_step.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/integrator/work_integral.h"

namespace footfall {
namespace {

const double kGamma = 1.0 - std::sqrt(0.5);
const double kW = std::sqrt(2.0) / 4.0;
const double kNode = 2.0 * kGamma;  // time of the middle stage
// b - embedded b
const double kError[3] = {kW - (1.0 - kW) / 3.0, kW - (3.0 * kW + 1.0) / 3.0, 2.0 * kGamma / 3.0};

constexpr int kMostIterations = 10;
constexpr double kNewtonTolerance = 0.01;  // of the error tolerance: Newton must not be seen by the error estimate
constexpr double kSlow = 0.2;              // convergence rate above which the Jacobian is renewed before the next step
// A rate that was measured once says less and less about a Jacobian that grows old: without this, stages that end after
// one iteration would never measure it again (as in RADAU5 of Hairer and Wanner).
constexpr double kForgetting = 0.8;
// Drift is looked at after so many steps of a window, and removed above this share of the absolute tolerances; at the
// end of a window always.
constexpr int kStepsBetweenChecks = 8;
constexpr double kDriftShare = 0.1;
constexpr double kSafety = 0.9, kLeast = 0.2, kMost = 5.0;

}  // namespace

OneStep::OneStep(Equations& equations, const IntegratorOptions& options)
    : equations_(equations), options_(options), norm_(equations.layout(), options) {
  const int n = equations.layout().size();
  y_ = Ydot_ = known_ = F_ = change_ = rates_ = Eigen::VectorXd::Zero(n);
  dx_ = Eigen::VectorXd::Zero(equations.layout().v_size);
  for (Eigen::VectorXd& K : K_) K = Eigen::VectorXd::Zero(n);
  for (Eigen::VectorXd& Y : Y_) Y = Eigen::VectorXd::Zero(n);
  lu_ = std::make_unique<SparseLu>(equations.reduced_pattern());
}

void OneStep::forget() {
  factored_c_ = 0.0;
  rate_ = 1.0;
  lu_->forget();
  equations_.forget();
}

void OneStep::advance(State& state, double t_end, const Inputs& inputs) {
  const Layout& layout = equations_.layout();
  FOOTFALL_DEMAND(t_end > state.time);
  // Rates at the start under the loads of this window.
  equations_.accelerations(state, inputs, K_[0]);
  ++statistics_.factorizations;
  equations_.pack(state, K_[0].tail(layout.row_count), y_);
  equations_.energy(state.time, y_, inputs, energy_[0]);

  int since_check = 0;
  double t = state.time;
  double h = state.step > 0.0 ? state.step : t_end - t;
  if (options_.max_step > 0.0) h = std::min(h, options_.max_step);
  while (t < t_end) {
    // Equal steps to the end of the window.
    const double steps = std::ceil((t_end - t) / h * (1.0 - 1e-9));
    const double step = steps > 1.0 ? (t_end - t) / steps : t_end - t;
    fresh_ = false;
    Outcome outcome = try_step(t, step, inputs);
    if (outcome == Outcome::kNoConvergence && !fresh_) {
      factored_c_ = 0.0;
      outcome = try_step(t, step, inputs);
    }
    if (outcome == Outcome::kAccepted) {
      accept(t, step, inputs, state);
      t = steps > 1.0 ? t + step : t_end;
      if (t < t_end && options_.projection && ++since_check % kStepsBetweenChecks == 0) remove_drift(t, state);
      // Without error control only Newton shortens steps: they grow again.
      h = step *
          (options_.error_control ? std::clamp(kSafety / std::cbrt(std::max(error_, 1e-12)), kLeast, kMost) : 2.0);
      if (options_.max_step > 0.0) h = std::min(h, options_.max_step);
      continue;
    }
    if (outcome == Outcome::kTooInaccurate) {
      ++statistics_.rejected;
      h = step * std::clamp(kSafety / std::cbrt(error_), kLeast, 0.8);
    } else {
      ++statistics_.newton_failures;
      h = 0.25 * step;
    }
    if (h < options_.min_step) give_up(t);
  }

  ++statistics_.windows;
  equations_.unpack(y_, state);
  state.time = t_end;
  state.step = h;
  rates_ = K_[0];
  statistics_.count(options_.projection ? equations_.project(state) : equations_.check_closed(state));
}

// Within a window: results do not depend on its length.
void OneStep::remove_drift(double t, State& state) {
  equations_.unpack(y_, state);
  state.time = t;
  const Equations::Drift drift = equations_.drift(state);
  if (drift.position <= kDriftShare * options_.atol && drift.velocity <= kDriftShare * options_.atol_velocity) return;
  statistics_.count(equations_.project(state));
  equations_.pack(state, K_[0].tail(equations_.layout().row_count), y_);
}

OneStep::Outcome OneStep::try_step(double t, double h, const Inputs& inputs) {
  const int m = equations_.layout().lambda0(), rows = equations_.layout().row_count;
  const double c = 1.0 / (h * kGamma);
  norm_.set(y_);
  complaint_.clear();

  // Middle stage: known = y + h gamma K_0, predicted with K_1 = K_0.
  known_.head(m) = y_.head(m) + (h * kGamma) * K_[0].head(m);
  K_[1] = K_[0];
  Y_[0].head(m) = known_.head(m) + (h * kGamma) * K_[1].head(m);
  Y_[0].tail(rows) = K_[1].tail(rows);
  if (factored_c_ == 0.0 || std::abs(c / factored_c_ - 1.0) > 1e-6 || rate_ > kSlow) {
    if (!refresh(t, c, inputs)) return Outcome::kNoConvergence;
  }
  if (!solve_stage(1, t + kNode * h, h, inputs)) return Outcome::kNoConvergence;

  // Last stage: known = y + h w (K_0 + K_1), predicted along the straight line through K_0 and K_1.
  known_.head(m) = y_.head(m) + (h * kW) * (K_[0] + K_[1]).head(m);
  K_[2] = K_[0] + (K_[1] - K_[0]) / kNode;
  Y_[1].head(m) = known_.head(m) + (h * kGamma) * K_[2].head(m);
  Y_[1].tail(rows) = K_[2].tail(rows);
  if (!solve_stage(2, t + h, h, inputs)) return Outcome::kNoConvergence;

  // Error estimate e = h sum (b - b^) K, filtered: J x = c (dF/dydot) e, positions eliminated as in the
  // Jacobian.
  const Layout& layout = equations_.layout();
  const int lower = layout.size() - layout.q_size;
  Ydot_.head(m) = h * (kError[0] * K_[0] + kError[1] * K_[1] + kError[2] * K_[2]).head(m);
  Ydot_.tail(rows).setZero();
  equations_.apply_mass(Y_[1], Ydot_, t + h, F_);
  to_increments(layout, Y_[1].head(layout.q_size), Ydot_.head(layout.q_size), dx_);
  Eigen::Ref<Eigen::VectorXd> x = F_.tail(lower);
  x *= c;
  equations_.subtract_stiffness(dx_, x);
  lu_->solve(x);
  dx_ += x.head(layout.v_size) / c;
  from_increments(layout, Y_[1].head(layout.q_size), dx_, F_.head(layout.q_size));
  error_ = norm_(F_);
  worst_ = norm_.worst(F_);
  if (!std::isfinite(error_)) return Outcome::kNoConvergence;
  return error_ <= 1.0 || !options_.error_control ? Outcome::kAccepted : Outcome::kTooInaccurate;
}

bool OneStep::refresh(double t, double c, const Inputs& inputs) {
  // At the start of the step: the prediction of the first implicit stage differs from it by O(h).
  try {
    equations_.reduced_jacobian(t, y_, K_[0], c, inputs);
  } catch (const NumericalError& error) {
    complaint_ = error.what();
    return false;
  }
  ++statistics_.jacobians;
  ++statistics_.factorizations;
  fresh_ = true;
  rate_ = kSlow;
  factored_c_ = lu_->factor() ? c : 0.0;
  return factored_c_ != 0.0;
}

bool OneStep::solve_stage(int stage, double t, double h, const Inputs& inputs) {
  const Layout& layout = equations_.layout();
  const int m = layout.lambda0(), rows = layout.row_count, q = layout.q_size, lower = layout.size() - q;
  const double c = 1.0 / (h * kGamma);
  Eigen::VectorXd& Y = Y_[stage - 1];
  Ydot_.tail(rows).setZero();
  double last = 0.0;
  rate_ = std::max(rate_, std::min(std::pow(rate_, kForgetting), kSlow));
  for (int i = 0; i < kMostIterations; ++i) {
    // Positions and rates of the present velocities and states.
    change_.head(q) = Y.head(q);
    solve_positions(layout, known_.head(q), Y.segment(q, layout.v_size), c, Y.head(q));
    change_.head(q) -= Y.head(q);
    Ydot_.head(m) = c * (Y - known_).head(m);
    try {
      equations_.residual(t, Y, Ydot_, inputs, F_);
    } catch (const NumericalError& error) {  // a law without a value there: a smaller step may stay clear of it
      complaint_ = error.what();
      return false;
    }
    ++statistics_.residuals;
    Eigen::Ref<Eigen::VectorXd> x = change_.tail(lower);
    x = F_.tail(lower);
    lu_->solve(x);
    Y.tail(lower) -= x;
    const double size = norm_(change_);
    worst_ = norm_.worst(change_);
    if (!std::isfinite(size)) return false;
    if (i > 0) {
      rate_ = size / last;
      if (rate_ >= 1.0 && size > kNewtonTolerance) return false;
    }
    last = size;
    // What is still missing: size rate / (1 - rate); the rate of the stage before serves the first iteration.
    const double rate = std::min(rate_, 0.9);
    if (size * rate / (1.0 - rate) <= kNewtonTolerance) {
      solve_positions(layout, known_.head(q), Y.segment(q, layout.v_size), c, Y.head(q));
      K_[stage].head(m) = c * (Y - known_).head(m);
      K_[stage].tail(rows) = Y.tail(rows);
      return true;
    }
  }
  return false;
}

void OneStep::accept(double t, double h, const Inputs& inputs, State& state) {
  ++statistics_.steps;
  // Work integrals with the weights of the method itself.
  equations_.energy(t + kNode * h, Y_[0], inputs, energy_[1]);
  equations_.energy(t + h, Y_[1], inputs, energy_[2]);
  add_work(energy_[0], h * kW, state);
  add_work(energy_[1], h * kW, state);
  add_work(energy_[2], h * kGamma, state);
  y_.swap(Y_[1]);
  K_[0].swap(K_[2]);
  std::swap(energy_[0], energy_[2]);
}

void OneStep::give_up(double t) const {
  std::ostringstream out;
  out << "t = " << t << " s: the step size fell below " << options_.min_step << " s; ";
  if (!complaint_.empty()) {
    out << complaint_;
  } else {
    out << "what does not settle is " << equations_.entry_name(std::max(worst_, 0)) << ".";
  }
  throw NumericalError(out.str());
}

}  // namespace footfall
