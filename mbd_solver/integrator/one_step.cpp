#include "mbd_solver/integrator/one_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/integrator/progress_watch.h"
#include "mbd_solver/integrator/work_integral.h"

namespace footfall {
namespace {

// What Newton may leave, relative to the error of the step: it must be seen neither by the error estimate nor in the sum
// over many steps. The error of a first step is guessed; none is taken to be less than kLeastError, as round-off stands in
// the way.
constexpr double kNewton = 0.03, kFirstError = 1e-2, kLeastError = 1e-4, kRoundOff = 1e-12;
constexpr double kSafety = 0.9, kLeast = 0.2, kMost = 5.0;
// Where Newton diverged, mostly at a contact, the step is halved, and one that converges then grows little: it would fail again.
// A mechanism that may pass singular positions takes a quarter, and grows as its error allows.
constexpr double kDivergence = 0.5, kSingularDivergence = 0.25, kAfterDivergence = 1.5;
constexpr double kFirst = 0.01;     // of y changes in the first step of all
constexpr double kCrossing = 1e-7;  // least error that a step over a singular position may have: round-off is not far
constexpr int kMostBefore = 4;      // rates of a step from which the next one is predicted
constexpr double kNear = 1e-9;      // of a step
constexpr double kNever = -std::numeric_limits<double>::infinity();
constexpr double kStretch = 10.0;  // so many steps before its end a window is divided into equal ones

}  // namespace

OneStep::OneStep(Equations& equations, const IntegratorOptions& options)
    : equations_(equations),
      options_(options),
      usual_(tableau_of_order(options.order)),
      high_(options.window_order == 0 ? usual_ : tableau_of_order(options.window_order)),
      tableau_(&usual_),
      norm_(equations.layout(), options),
      lu_(equations.reduced_pattern(), equations.negligible_shares()),
      may_be_singular_(equations.saddle().resting_row_changes() > 0) {
  const int n = equations.layout().size();
  const std::size_t stages = static_cast<std::size_t>(std::max(usual_.stages, high_.stages));
  y_ = Ydot_ = known_ = F_ = change_ = rates_ = left_ = row_rates_ = Eigen::VectorXd::Zero(n);
  dx_ = Eigen::VectorXd::Zero(equations.layout().v_size);
  K_.assign(stages, Eigen::VectorXd::Zero(n));
  Y_.assign(stages, Eigen::VectorXd::Zero(n));
  energy_.resize(stages);
  before_.assign(static_cast<std::size_t>(std::min({usual_.stages, high_.stages, kMostBefore})),
                 Eigen::VectorXd::Zero(n));
  start_before_.time = start_.time = kNever;
}

void OneStep::forget() {
  factored_c_ = 0.0;
  rate_ = 1.0;
  h_before_ = 0.0;
  start_before_.time = start_.time = kNever;
  trouble_ = careful_ = crossings_ = 0;
  choice_ = {};
  singular_time_ = -kNever;
  looked_time_ = std::numeric_limits<double>::quiet_NaN();
  left_time_ = kNever;
  lu_.forget();
  equations_.saddle().forget();
}

void OneStep::advance(State& state, double t_end, const Inputs& inputs, const Rows& rows) {
  const Layout& layout = equations_.layout();
  FOOTFALL_DEMAND(t_end > state.time);
  start_window(inputs, state);
  row_time_ = rows.after(state.time);

  // The next step, by accuracy alone.
  double wanted = state.step > 0.0 ? state.step : std::min(t_end - state.time, first_step());
  ProgressWatch watch(state.time, t_end);
  if (&high_ != &usual_ && options_.error_control) wanted = choice_.begin(t_end - state.time, wanted);
  bool goes_on = true;
  bool diverged = false;  // Newton, in the last try
  while (goes_on && state.time < t_end) {
    const double h = options_.max_step > 0.0 ? std::min(wanted, options_.max_step) : wanted;
    const double t = state.time, planned = planned_step(t, h), steps = std::ceil((t_end - t) / planned * (1.0 - 1e-9));
    const double step = steps > (planned != h ? 1.0 : kStretch) ? planned : (t_end - t) / steps;
    limit_ = planned != h && t + step > singular_time_ ? std::max(1.0, kCrossing / options_.rtol) : 1.0;
    tableau_ = choice_.high() ? &high_ : &usual_;
    const Outcome outcome = try_with_newer_jacobians(t, step, inputs);
    if (outcome == Outcome::kAccepted) {
      trouble_ = std::max(0, trouble_ - 1);
      wanted = next_step(step);
      if (diverged && !may_be_singular_) wanted = std::min(wanted, kAfterDivergence * step);
      diverged = false;
      if (error_ > 1.0 && limit_ > 1.0) statistics_.told_error = std::max(statistics_.told_error, error_);
      goes_on = accept(t, step, steps > 1.0 ? t + step : t_end, t_end, inputs, rows, state);
      if (const std::string slow = watch.complaint(state.time); !slow.empty()) give_up(state.time, slow);
      if (careful_ > 0) look_ahead(state);
      crossings_ = 0;
      continue;
    }
    diverged = outcome == Outcome::kNoConvergence;
    ++(outcome == Outcome::kTooInaccurate ? statistics_.rejected : statistics_.newton_failures);
    if (finds_another_step(h, planned, inputs, state)) continue;
    wanted = outcome == Outcome::kTooInaccurate ? std::min(next_step(step), 0.8 * step)
                                                : (may_be_singular_ ? kSingularDivergence : kDivergence) * step;
    if (wanted < options_.min_step)
      give_up(t, "the step size fell below " + number_text(options_.min_step, 3) + " s; ");
  }

  ++statistics_.windows;
  state.step = wanted;
  rates_ = K_[0];
  if (!closed_)
    statistics_.count(options_.projection ? equations_.saddle().project(state, SaddleSystem::Close::kWithOldFactors)
                                          : equations_.saddle().check_closed(state));
  equations_.saddle().smallest_multipliers(state, rates_.tail(layout.row_count));
  left_time_ = state.time;
  equations_.pack(state, rates_.tail(layout.row_count), left_);
}

double OneStep::first_step() {
  if (!options_.error_control) return std::numeric_limits<double>::infinity();
  norm_.set(y_);
  const double size = norm_(y_), rate = norm_(K_[0]);
  return kFirst * size < rate * options_.min_step ? options_.min_step
         : rate > 0.0                             ? kFirst * size / rate
                                                  : std::numeric_limits<double>::infinity();
}

double OneStep::next_step(double h) const {
  // Without error control only Newton shortens steps: they grow again.
  const double factor =
      options_.error_control
          ? std::clamp(kSafety * std::pow(std::max(error_, 1e-12), -1.0 / (tableau_->estimated_order + 1)), kLeast,
                       kMost)
          : 2.0;
  return h * factor;
}

OneStep::Outcome OneStep::try_with_newer_jacobians(double t, double h, const Inputs& inputs) {
  fresh_ = false;
  Outcome outcome = try_step(t, h, inputs);
  if (outcome == Outcome::kNoConvergence && !fresh_) {
    factored_c_ = 0.0;
    outcome = try_step(t, h, inputs);
  }
  if (outcome != Outcome::kNoConvergence || (careful_ == 0 && !may_be_singular_)) return outcome;
  // Beyond a singular position a condition that fades has changed its sign: with the Jacobian of the step's start Newton
  // diverges there however short the step is, and steps would shrink into the position. With those of the stages the
  // step goes over it.
  at_stages_ = true;
  outcome = try_step(t, h, inputs);
  at_stages_ = false;
  factored_c_ = 0.0;
  return outcome;
}

OneStep::Outcome OneStep::try_step(double t, double h, const Inputs& inputs) {
  const Layout& layout = equations_.layout();
  const int m = layout.lambda0(), rows = layout.row_count, stages = tableau_->stages;
  const double c = 1.0 / (h * tableau_->gamma);
  norm_.set(y_);
  complaint_.clear();
  const double expected = h_before_ > 0.0 && tableau_before_ == tableau_
                              ? error_before_ * std::pow(h / h_before_, tableau_->estimated_order + 1)
                              : kFirstError;
  newton_tolerance_ =
      kNewton * std::clamp(expected, std::min(std::max(kLeastError, kRoundOff / options_.rtol), 1.0), 1.0);

  if (const long choices = equations_.saddle().resting_row_changes(); choices != rest_choices_) {
    rest_choices_ = choices;
    equations_.saddle().multipliers_without_resting_rows(t, y_, K_[0].tail(rows));
  }
  for (int i = 1; i < stages; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    known_ = y_;
    for (std::size_t j = 0; j < at; ++j)
      if (tableau_->a[at][j] != 0.0) known_ += (h * tableau_->a[at][j]) * K_[j];
    predict(i, h);
    Y_[at].head(m) = known_.head(m) + (h * tableau_->gamma) * K_[at].head(m);
    Y_[at].tail(rows) = K_[at].tail(rows);
    const double t_stage = t + tableau_->c[at] * h;
    if (at_stages_) {
      if (!refresh(t_stage, Y_[at], K_[at], c, inputs)) return Outcome::kNoConvergence;
    } else if (factored_c_ == 0.0 || (i == 1 && (std::abs(c / factored_c_ - 1.0) > 1e-6 || rate_ > slow()))) {
      // At the start of the step: the prediction of the first implicit stage differs from it by O(h).
      if (!refresh(t, y_, K_[0], c, inputs)) return Outcome::kNoConvergence;
    }
    if (!solve_stage(i, t_stage, h, inputs)) return Outcome::kNoConvergence;
  }

  // Error estimate e = h sum (b - b^) K, filtered: J x = c (dF/dydot) e, positions eliminated as in the
  // Jacobian.
  const Eigen::VectorXd& end = Y_[last()];
  const int lower = layout.size() - layout.q_size;
  Ydot_.setZero();
  for (std::size_t j = 0; j <= last(); ++j) Ydot_.head(m) += (h * tableau_->error[j]) * K_[j].head(m);
  equations_.apply_mass(end, Ydot_, t + h, F_);
  to_increments(layout, end.head(layout.q_size), Ydot_.head(layout.q_size), dx_);
  Eigen::Ref<Eigen::VectorXd> x = F_.tail(lower);
  x *= c;
  equations_.subtract_stiffness(dx_, x);
  lu_.solve(x);
  dx_ += x.head(layout.v_size) / c;
  from_increments(layout, end.head(layout.q_size), dx_, F_.head(layout.q_size));
  error_ = norm_(F_);
  worst_ = norm_.worst(F_);
  if (!std::isfinite(error_)) return Outcome::kNoConvergence;
  if ((error_ <= limit_ || !options_.error_control) && !close_end(t + h)) return Outcome::kTooInaccurate;
  return error_ <= limit_ || !options_.error_control ? Outcome::kAccepted : Outcome::kTooInaccurate;
}

bool OneStep::accept(double t, double h, double t_new, double t_end, const Inputs& inputs, const Rows& rows,
                     State& state) {
  ++statistics_.steps;
  // Work integrals with the weights of the method itself.
  std::swap(start_before_, start_);
  start_ = state;
  for (std::size_t i = 0; i <= last(); ++i) {
    const double b = i < last() ? tableau_->a[last()][i] : tableau_->gamma;
    if (i > 0) equations_.powers(t + tableau_->c[i] * h, Y_[i], inputs, energy_[i]);
    if (b != 0.0) add_work(energy_[i], h * b, state);
  }
  equations_.unpack(Y_[last()], state);
  state.time = t_new;

  const double reached = t_new + kNear * h;  // a row that round-off has put just behind the step belongs to it
  for (; row_time_ < t_end && row_time_ <= reached; row_time_ = rows.after(row_time_)) {
    interpolate(row_time_, h);
    statistics_.count(options_.projection ? equations_.saddle().project(row_, SaddleSystem::Close::kWithOldFactors)
                                          : equations_.saddle().check_closed(row_));
    equations_.saddle().smallest_multipliers(row_, row_rates_.tail(equations_.layout().row_count));
    if (rows.on_row(row_, row_rates_)) continue;
    state = row_;
    K_[0] = row_rates_;
    h_before_ = 0.0;
    closed_ = false;
    return false;
  }

  for (std::size_t k = 0; k + 1 < before_.size(); ++k) before_[k].swap(K_[k]);
  before_.back().swap(K_[last()]);
  K_[0] = before_.back();
  std::swap(energy_[0], energy_[last()]);
  h_before_ = h;
  tableau_before_ = tableau_;
  error_before_ = error_;
  y_.swap(Y_[last()]);
  if (fresh_) equations_.saddle().update_resting_rows(state);
  if (closed_) {
    statistics_.count(end_drift_);
    state.q = end_.q;
    state.v = end_.v;
    equations_.pack(state, K_[0].tail(equations_.layout().row_count), y_);
  }
  if (careful_ > 0) {
    --careful_;
    renew_rates(inputs, state);
  }
  return true;
}

std::string OneStep::warning() const {
  if (!(statistics_.told_error > 0.0)) return {};
  return "the mechanism went through a singular position, in which its joints do not say how it goes on, in a step "
         "with an "
         "error of " +
         number_text(statistics_.told_error, 2) +
         " times solver.rtol and solver.atol: near it round-off does not allow a smaller one. Compare with a "
         "solver.rtol "
         "of 1e-7";
}

void OneStep::give_up(double t, const std::string& what) const {
  std::ostringstream out;
  out << "t = " << t << " s: " << what;
  if (!complaint_.empty()) {
    out << complaint_;
  } else {
    out << "what does not settle is " << equations_.entry_name(std::max(worst_, 0)) << ".";
  }
  throw NumericalError(out.str());
}

}  // namespace footfall
