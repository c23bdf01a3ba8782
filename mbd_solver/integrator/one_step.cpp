// Control of steps: stages, error estimate, acceptance with rows on the way, drift at the end of steps, starts of windows.

#include "mbd_solver/integrator/one_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/integrator/codes.h"
#include "mbd_solver/integrator/step_control.h"

namespace footfall {
namespace {

// Remaining error of Newton relative to the error of the step: invisible in the error estimate and in the sum over many steps.
// The error of a first step is estimated; none counts as less than kLeastError, because of round-off.
constexpr double kNewton = 0.03, kFirstError = 1e-2, kLeastError = 1e-4, kRoundOff = 1e-12;
constexpr double kSafety = 0.9, kLeast = 0.2, kMost = 5.0;
// After Newton diverged, mostly at a contact, the step is halved, and the next one grows little: it would fail again. With
// redundant conditions the step is quartered, and grows as its error allows.
constexpr double kDivergence = 0.5, kSingularDivergence = 0.25, kAfterDivergence = 1.5;
constexpr double kFirst = 0.01;         // relative change of y in the first step
constexpr double kCrossing = 1e-7;      // smallest error limit of a step over a singular position, near round-off
constexpr double kNear = 1e-9;          // of a step
constexpr double kKineticShare = 0.01;  // of the kinetic energy, against which errors of work are small
// Of the error of a step, beyond which that of work does not count: at rest work is round-off, and needs no short steps.
constexpr double kMostWorkError = 1e3;
constexpr int kMostHalvings = 60;  // in the search for the change of a mode
constexpr double kNever = -std::numeric_limits<double>::infinity();
constexpr double kStretch = 10.0;  // number of steps to its end from which a window is divided into equal ones
// Drift [in absolute tolerances] that remains within a window; reported states have none.
constexpr double kDrift = 0.1;
constexpr double kOpen = 1e3;  // error of a step whose end cannot be closed
// A window that continues the last one starts from its rates, corrected with existing factors of the saddle matrix, until the
// correction changes a step by less than this share of the tolerance.
constexpr double kRateError = 1e-4;
constexpr int kMostCorrections = 4;
// Convergence rate of a stage from which the next stage has a Jacobian of its own: a stiff force whose direction turns within the
// step makes the one of its start useless, and what Newton then leaves, small in every coordinate, adds up over many steps.
constexpr double kStale = 0.1;

}  // namespace

class OneStep::View : public StepView {
 public:
  View(OneStep& steps, double h, const State& end, bool cut) : steps_(steps), h_(h), end_(end), cut_(cut) {}
  double begin() const override { return steps_.start_.time; }
  double end() const override { return end_.time; }
  void at(double time, State& state, Eigen::VectorXd& rates) override {
    if (time >= end_.time && !cut_) {
      state = end_;
      rates = steps_.K_[steps_.last()];
      return;
    }
    steps_.interpolate(time, h_);
    state = steps_.row_;
    rates = steps_.row_rates_;
  }

 private:
  OneStep& steps_;
  double h_;
  const State& end_;
  bool cut_;  // the step ends before all of its stages
};

OneStep::OneStep(Equations& equations, const IntegratorOptions& options)
    : equations_(equations),
      options_(options),
      usual_(tableau_of_order(options.order)),
      high_(options.window_order == 0 ? usual_ : tableau_of_order(options.window_order)),
      tableau_(&usual_),
      norm_(equations.layout(), options),
      newton_(equations, norm_, statistics_, failure_),
      predictor_(std::min(usual_.stages, high_.stages), equations.layout().size()),
      turns_(equations.model(), equations.layout()),
      may_be_singular_(equations.saddle().resting_row_changes() > 0) {
  const int n = equations.layout().size();
  const std::size_t stages = static_cast<std::size_t>(std::max(usual_.stages, high_.stages));
  y_ = Ydot_ = known_ = F_ = change_ = rates_ = left_ = row_rates_ = Eigen::VectorXd::Zero(n);
  dx_ = Eigen::VectorXd::Zero(equations.layout().v_size);
  K_.assign(stages, Eigen::VectorXd::Zero(n));
  Y_.assign(stages, Eigen::VectorXd::Zero(n));
  energy_.resize(stages);
  start_before_.time = start_.time = kNever;
}

void OneStep::forget() {
  newton_.forget();
  predictor_.forget();
  crossing_.forget();
  start_before_.time = start_.time = kNever;
  choice_ = {};
  left_time_ = turning_.time = kNever;
  equations_.saddle().forget();
}

void OneStep::advance(State& state, double t_end, const Inputs& inputs, const Rows& rows) {
  const Layout& layout = equations_.layout();
  FOOTFALL_DEMAND(t_end > state.time);
  equations_.recall(state);
  equations_.switch_modes(inputs, state);
  work_scale_ = state.work_error.scale;
  start_window(inputs, state);
  row_time_ = rows.after(state.time);

  // The next step as accuracy alone requires.
  double required = state.step > 0.0 ? state.step : std::min(t_end - state.time, first_step());
  ProgressWatch watch(state.time, t_end);
  if (&high_ != &usual_ && options_.error_control) required = choice_.begin(t_end - state.time, required);
  bool continues = true;
  bool diverged = false;  // Newton, in the last try
  while (continues && state.time < t_end) {
    const double h = options_.max_step > 0.0 ? std::min(required, options_.max_step) : required;
    const double t = state.time, planned = planned_step(t, h), steps = std::ceil((t_end - t) / planned * (1.0 - 1e-9));
    const double step = steps > (planned != h ? 1.0 : kStretch) ? planned : (t_end - t) / steps;
    limit_ = planned != h && t + step > crossing_.time() ? std::max(1.0, kCrossing / options_.rtol) : 1.0;
    const bool few_stages = choice_.stiff() && high_.stages > kManyStages;
    tableau_ = choice_.high() && !few_stages ? &high_ : &usual_;
    const Outcome outcome = try_with_newer_jacobians(t, step, inputs);
    if (outcome == Outcome::kAccepted) {
      crossing_.count_success();
      choice_.see(newton_.turns());
      required = next_step(step);
      if (diverged && !may_be_singular_) required = std::min(required, kAfterDivergence * step);
      diverged = false;
      if (error_ > 1.0 && limit_ > 1.0) statistics_.reported_error = std::max(statistics_.reported_error, error_);
      continues = accept(step, steps > 1.0 ? t + step : t_end, t_end, inputs, rows, state);
      equations_.remember(inputs, state);
      if (std::exchange(switched_, false)) required = std::min(required, first_step());
      if (const std::string slow = watch.check(state.time); !slow.empty()) give_up(code::kNoProgress, state.time, slow);
      if (crossing_.careful()) look_ahead(state);
      crossing_.finish_step();
      continue;
    }
    diverged = outcome == Outcome::kNoConvergence;
    ++(outcome == Outcome::kTooInaccurate ? statistics_.rejected : statistics_.newton_failures);
    if (finds_another_step(h, planned, inputs, state)) continue;
    required = outcome == Outcome::kTooInaccurate ? std::min(next_step(step), 0.8 * step)
                                                  : (may_be_singular_ ? kSingularDivergence : kDivergence) * step;
    if (required < options_.min_step)
      give_up(code::kStepTooSmall, t, "the step size fell below " + number_text(options_.min_step, 3) + " s; ");
  }

  ++statistics_.windows;
  state.step = required;
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
  newton_.begin_step(choice_.stiff());
  Outcome outcome = try_step(t, h, inputs);
  if (outcome == Outcome::kNoConvergence && !newton_.fresh()) {
    newton_.drop_factors();
    outcome = try_step(t, h, inputs);
  }
  if (outcome != Outcome::kNoConvergence || (!crossing_.careful() && !may_be_singular_)) return outcome;
  // Beyond a singular position a vanishing condition has changed its sign: with the Jacobian of the step's start Newton
  // diverges there for any length of the step, and steps would shrink towards the position. With those of the stages the step
  // passes over it.
  at_stages_ = true;
  outcome = try_step(t, h, inputs);
  at_stages_ = false;
  newton_.drop_factors();
  return outcome;
}

OneStep::Outcome OneStep::try_step(double t, double h, const Inputs& inputs) {
  const Layout& layout = equations_.layout();
  const int m = layout.lambda0(), rows = layout.row_count, stages = tableau_->stages;
  const double c = 1.0 / (h * tableau_->gamma);
  norm_.set(y_);
  failure_.reason.clear();
  const double expected = predictor_.has_step() && predictor_.tableau() == tableau_
                              ? error_before_ * std::pow(h / predictor_.step(), tableau_->estimated_order + 1)
                              : kFirstError;
  const double newton_tolerance =
      kNewton * std::clamp(expected, std::min(std::max(kLeastError, kRoundOff / options_.rtol), 1.0), 1.0);

  if (const long changes = equations_.saddle().resting_row_changes(); changes != resting_row_changes_) {
    resting_row_changes_ = changes;
    equations_.saddle().multipliers_without_resting_rows(t, y_, K_[0].tail(rows));
  }
  for (int i = 1; i < stages; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    known_ = y_;
    for (std::size_t j = 0; j < at; ++j)
      if (tableau_->a[at][j] != 0.0) known_ += (h * tableau_->a[at][j]) * K_[j];
    predictor_.predict(*tableau_, i, h, K_);
    Y_[at].head(m) = known_.head(m) + (h * tableau_->gamma) * K_[at].head(m);
    Y_[at].tail(rows) = K_[at].tail(rows);
    const double t_stage = t + tableau_->c[at] * h;
    const bool own = at_stages_ || (choice_.stiff() && i > 1 && newton_.rate() > kStale);
    if (own) {
      if (!newton_.refresh(t_stage, Y_[at], K_[at], c, slow(), inputs)) return Outcome::kNoConvergence;
    } else if (newton_.needs_jacobian(c, i == 1, slow())) {
      // At the start of the step: the prediction of the first implicit stage differs from it by O(h).
      if (!newton_.refresh(t, y_, K_[0], c, slow(), inputs)) return Outcome::kNoConvergence;
    }
    if (newton_.solve(t_stage, c, known_, newton_tolerance, slow(), inputs, Y_[at], K_[at])) continue;
    // Once more with the Jacobian of this stage, if that of the start of this step is not enough.
    if (own || !newton_.fresh()) return Outcome::kNoConvergence;
    Y_[at].head(m) = known_.head(m) + (h * tableau_->gamma) * K_[at].head(m);
    Y_[at].tail(rows) = K_[at].tail(rows);
    if (!newton_.refresh(t_stage, Y_[at], K_[at], c, slow(), inputs) ||
        !newton_.solve(t_stage, c, known_, newton_tolerance, slow(), inputs, Y_[at], K_[at]))
      return Outcome::kNoConvergence;
  }

  error_ = estimated_error(t, h);
  failure_.worst = norm_.worst(F_);
  if (!std::isfinite(error_)) return Outcome::kNoConvergence;
  state_error_ = error_;
  if (error_ <= limit_ || !options_.error_control)
    error_ = std::max(error_, std::min(work_error(t, h, inputs), kMostWorkError * error_));
  if ((error_ <= limit_ || !options_.error_control) && !close_end(t + h)) return Outcome::kTooInaccurate;
  return error_ <= limit_ || !options_.error_control ? Outcome::kAccepted : Outcome::kTooInaccurate;
}

// e = h sum (b - b^) K, filtered: J x = c (dF/dydot) e, positions eliminated as in the Jacobian.
double OneStep::estimated_error(double t, double h) {
  const Layout& layout = equations_.layout();
  const double c = 1.0 / (h * tableau_->gamma);
  const int m = layout.lambda0(), lower = layout.size() - layout.q_size;
  const Eigen::VectorXd& end = Y_[last()];
  Ydot_.setZero();
  for (std::size_t j = 0; j <= last(); ++j) Ydot_.head(m) += (h * tableau_->error[j]) * K_[j].head(m);
  equations_.apply_mass(end, Ydot_, t + h, F_);
  to_increments(layout, end.head(layout.q_size), Ydot_.head(layout.q_size), dx_);
  Eigen::Ref<Eigen::VectorXd> x = F_.tail(lower);
  x *= c;
  equations_.subtract_stiffness(dx_, x);
  newton_.apply_inverse(x);
  dx_ += x.head(layout.v_size) / c;
  from_increments(layout, end.head(layout.q_size), dx_, F_.head(layout.q_size));
  return norm_(F_);
}

// Integrals of powers are further unknowns, W' = P, without influence on the others: their error is h sum (b - b^) P. It is
// compared with the energies that all powers have transferred, and with a share of the kinetic energy.
double OneStep::work_error(double t, double h, const Inputs& inputs) {
  step_error_.dissipated = {};
  step_error_.supplied = {};
  step_error_.load_work = Eigen::VectorXd::Zero(equations_.model().body_count());
  for (std::size_t i = 0; i <= last(); ++i) {
    if (i == last()) {
      equations_.energy(t + h, Y_[i], inputs, energy_[i]);
    } else if (i > 0) {
      equations_.powers(t + tableau_->c[i] * h, Y_[i], inputs, energy_[i]);
    }
    add_work_error(energy_[i], h * tableau_->error[i], step_error_);
  }
  step_error_.scale = 0.5 * h * (size_of_powers(energy_[0]) + size_of_powers(energy_[last()]));
  const double error = step_error_.total();
  if (error == 0.0) return 0.0;
  const double scale = work_scale_ + step_error_.scale + kKineticShare * energy_[last()].stored[Stored::kKinetic];
  return error / (options_.rtol * scale);
}

bool OneStep::accept(double h, double t_new, double t_end, const Inputs& inputs, const Rows& rows, State& state) {
  ++statistics_.steps;
  statistics_.summed_error += state_error_;
  // Work integrals with the weights of the method.
  std::swap(start_before_, start_);
  start_ = state;
  for (std::size_t i = 0; i <= last(); ++i) {
    const double b = i < last() ? tableau_->a[last()][i] : tableau_->gamma;
    if (b != 0.0) add_work(energy_[i], h * b, state);
  }
  add_step_error(step_error_, state.work_error);
  work_scale_ = state.work_error.scale;
  equations_.unpack(Y_[last()], state);
  state.time = t_new;

  const double change = equations_.has_modes() ? time_of_switch(h, t_new, inputs) : HUGE_VAL;
  // A row just behind the step, by round-off, belongs to it.
  const double reached = change < HUGE_VAL ? change : t_new + kNear * h;
  for (; row_time_ < t_end && row_time_ <= reached; row_time_ = rows.after(row_time_)) {
    interpolate(row_time_, h);
    statistics_.count(options_.projection ? equations_.saddle().project(row_, SaddleSystem::Close::kWithOldFactors)
                                          : equations_.saddle().check_closed(row_));
    equations_.saddle().smallest_multipliers(row_, row_rates_.tail(equations_.layout().row_count));
    turns_.follow(turning_, row_rates_, row_);
    if (rows.on_row(row_, row_rates_)) continue;
    state = row_;
    K_[0] = row_rates_;
    turning_.time = kNever;
    predictor_.forget();
    closed_ = false;
    return false;
  }

  const bool changes = change < HUGE_VAL;
  if (changes) {
    interpolate(change, h);
    turns_.follow(turning_, row_rates_, row_);
    state = row_;
    add_step_error(step_error_, state.work_error);  // at most that of the whole step
  } else {
    turns_.follow(turning_, K_[last()], state, &turning_next_);
  }
  bool continues = true;
  if (rows.on_step) {
    View view(*this, h, state, changes);
    continues = rows.on_step(view);
  }
  if (changes) {
    switch_modes(inputs, state);
    return continues;
  }
  std::swap(turning_, turning_next_);
  predictor_.accept(*tableau_, h, K_);
  std::swap(energy_[0], energy_[last()]);
  error_before_ = error_;
  y_.swap(Y_[last()]);
  if (newton_.fresh()) equations_.saddle().update_resting_rows(state);
  if (closed_) {
    statistics_.count(end_drift_);
    state.q = end_.q;
    state.v = end_.v;
    equations_.pack(state, K_[0].tail(equations_.layout().row_count), y_);
  }
  if (crossing_.careful()) {
    crossing_.finish_careful_step();
    renew_rates(inputs, state);
  }
  return continues;
}

bool OneStep::finds_another_step(double h, double planned, const Inputs& inputs, State& state) {
  const bool suspicious = crossing_.count_failure();
  if (!options_.projection) return false;
  if (crossing_.careful()) {
    if (planned == h) return false;
    crossing_.count_failed_crossing();
    return planned_step(state.time, h) < planned;
  }
  if (!suspicious) return false;
  if (!may_be_singular_) {
    look_ahead(state);
    if (!crossing_.in_sight(state.time, h)) return false;
  }
  crossing_.begin_careful_steps();
  start_clean(inputs, state);
  look_ahead(state);
  return planned_step(state.time, h) != h;
}

void OneStep::look_ahead(const State& state) {
  crossing_.look_ahead(equations_.saddle(), start_before_, start_, state,
                       options_.error_control && predictor_.has_step());
}

void OneStep::interpolate(double time, double h) {
  const int m = equations_.layout().lambda0();
  const DenseWeights w(*tableau_, (time - start_.time) / h);
  row_ = start_;
  row_.time = time;
  known_ = y_;
  row_rates_.setZero();
  for (std::size_t i = 0; i <= last(); ++i) {
    known_.head(m) += (h * w.b[i]) * K_[i].head(m);
    row_rates_ += w.slope[i] * K_[i];
    add_work(energy_[i], h * w.b[i], row_);
  }
  equations_.unpack(known_, row_);
}

// The first crossing of zero that the middle or the end of the step shows, from above; behind it the mode no longer fits.
double OneStep::time_of_switch(double h, double end, const Inputs& inputs) {
  const auto value = [&](double time) {
    interpolate(time, h);
    return equations_.mode_value(row_, inputs);
  };
  double before = start_.time, after = 0.5 * (start_.time + end);
  double at_after = value(after);
  if (at_after >= 0.0) {
    before = std::exchange(after, end);
    at_after = value(end);
    if (at_after >= 0.0) return HUGE_VAL;
  }
  double at_before = before == start_.time ? std::max(equations_.mode_value(start_, inputs), 0.0) : value(before);
  // Regula falsi (Illinois), with bisection where it does not halve the bracket.
  for (int i = 0; i < kMostHalvings && after - before > kNear * h; ++i) {
    const double share = i % 3 == 2 ? 0.5 : at_before / (at_before - at_after);
    const double middle = before + std::clamp(share, 0.01, 0.99) * (after - before);
    if (middle <= before || middle >= after) break;
    const double now = value(middle);
    (now < 0.0 ? after : before) = middle;
    (now < 0.0 ? at_after : at_before) = now;
    if (now < 0.0) at_before *= 0.5;
  }
  return after;
}

void OneStep::switch_modes(const Inputs& inputs, State& state) {
  equations_.switch_modes(inputs, state);
  statistics_.count(options_.projection ? equations_.saddle().project(state) : equations_.saddle().check_closed(state));
  renew_rates(inputs, state);
  turns_.measure(state, K_[0], turning_);
  predictor_.forget();
  newton_.drop_factors();
  closed_ = false;
  switched_ = true;
}

// If drift is large enough, or a singular position near, projection is a part of the step.
bool OneStep::close_end(double t) {
  closed_ = false;
  if (!options_.projection) return true;
  equations_.unpack(Y_[last()], end_);
  end_.time = t;
  const Drift drift = equations_.saddle().drift(end_);
  closed_ = crossing_.careful() || drift.position > kDrift * options_.atol ||
            drift.velocity > kDrift * options_.atol_velocity;
  if (!closed_) return true;
  if (crossing_.careful()) equations_.saddle().forget();  // the motion must not depend on pivots chosen for output rows
  try {
    end_drift_ = equations_.saddle().project(end_, SaddleSystem::Close::kFully);
  } catch (const NumericalError& error) {   // a joint cannot be closed
    const std::string text = error.what();  // "t = ... s: ..."; the time is reported once
    failure_.reason = text.substr(text.find(": ") + 2);
    error_ = kOpen;
    return false;
  }
  const Layout& layout = equations_.layout();
  F_.head(layout.q_size) = end_.q - Y_[last()].head(layout.q_size);
  F_.segment(layout.v0(), layout.v_size) = end_.v - Y_[last()].segment(layout.v0(), layout.v_size);
  F_.segment(layout.z0(), layout.z_size).setZero();
  if (!options_.error_control || !norm_.far(F_)) return true;
  error_ = norm_(F_);
  failure_.worst = norm_.worst(F_);
  failure_.reason = with_code(
      code::kStepTooSmall,
      "near a position where conditions of joints become dependent, drift of " + number_text(drift.velocity, 3) +
          " m/s can be removed only by changing " + equations_.entry_name(failure_.worst) + " by " +
          number_text(std::abs(F_[failure_.worst]), 3) + ". Increase rtol: longer steps pass over the position.");
  return false;
}

void OneStep::start_clean(const Inputs& inputs, State& state) {
  equations_.saddle().forget();
  statistics_.count(equations_.saddle().project(state, SaddleSystem::Close::kFully));
  renew_rates(inputs, state);
  crossing_.look_again();
}

void OneStep::start_window(const Inputs& inputs, const State& state) {
  if (!follow_rates(inputs, state)) {
    equations_.saddle().stage_rates(state, inputs, K_[0]);
    ++statistics_.factorizations;
    resting_row_changes_ = equations_.saddle().resting_row_changes();
  }
  equations_.pack(state, K_[0].tail(equations_.layout().row_count), y_);
  equations_.powers(state.time, y_, inputs, energy_[0]);
  if (state.time != turning_.time) turns_.measure(state, K_[0], turning_);
}

bool OneStep::follow_rates(const Inputs& inputs, const State& state) {
  if (state.time != left_time_ || !(state.step > 0.0)) return false;
  const int m = equations_.layout().lambda0();
  equations_.pack(state, rates_.tail(equations_.layout().row_count), y_);
  if (y_.head(m) != left_.head(m)) return false;
  K_[0] = rates_;
  norm_.set(y_);
  const double step = options_.max_step > 0.0 ? std::min(state.step, options_.max_step) : state.step;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostCorrections; ++i) {
    if (!equations_.saddle().correct_rates(state, inputs, K_[0], change_)) return false;
    ++statistics_.residuals;
    change_ *= step;
    const double size = norm_(change_);
    if (size <= kRateError) return true;
    if (!(size < 0.1 * last)) return false;
    // The remaining error relates to this correction as this one to the previous one.
    if (size * (size / last) <= kRateError && i > 0) return true;
    last = size;
  }
  return false;
}

void OneStep::renew_rates(const Inputs& inputs, const State& state) {
  equations_.saddle().forget();
  equations_.saddle().stage_rates(state, inputs, K_[0]);
  ++statistics_.factorizations;
  resting_row_changes_ = equations_.saddle().resting_row_changes();
  equations_.pack(state, K_[0].tail(equations_.layout().row_count), y_);
  equations_.powers(state.time, y_, inputs, energy_[0]);
}

std::string OneStep::warning() const {
  if (!(statistics_.reported_error > 0.0)) return {};
  return with_code(
      code::kSingularPassed,
      "the mechanism passed a singular position, where its joints do not determine the motion, in a step with "
      "an error of " +
          number_text(statistics_.reported_error, 2) +
          " times solver.rtol and solver.atol; round-off does not allow a smaller step there. Compare with a "
          "solver.rtol of 1e-7");
}

// A reason from below ends with its own code.
void OneStep::give_up(const MessageCode& code, double t, const std::string& what) const {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << "t = " << t << " s: " << what;
  if (!failure_.reason.empty()) throw NumericalError(out.str() + failure_.reason);
  out << "Newton's method or the error test fails at " << equations_.entry_name(std::max(failure_.worst, 0)) << ".";
  throw NumericalError(code, out.str());
}

}  // namespace footfall
