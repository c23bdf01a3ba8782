// Control of steps: stages, error estimate, acceptance with rows on the way, drift at the end of steps, starts of windows.

#include "mbd_solver/integrator/one_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

#include "coupler/base/text.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/integrator/codes.h"

namespace footfall {
namespace {

constexpr double kSafety = 0.9, kLeast = 0.2, kMost = 5.0;
// After Newton diverged, mostly at a contact, the step is halved, and the next one grows little: it would fail again. With
// redundant conditions the step is quartered, and grows as its error allows.
constexpr double kDivergence = 0.5, kSingularDivergence = 0.25, kAfterDivergence = 1.5;
constexpr double kFirst = 0.01;     // relative change of y in the first step
constexpr double kCrossing = 1e-7;  // smallest error limit of a step over a singular position, near round-off
constexpr double kNear = 1e-9;      // of a step
constexpr double kNever = -std::numeric_limits<double>::infinity();
constexpr double kStretch = 10.0;  // number of steps to its end from which a window is divided into equal ones
// Drift [in absolute tolerances] that remains within a window; reported states have none.
constexpr double kDrift = 0.1;
constexpr double kOpen = 1e3;  // error of a step whose end cannot be closed

}  // namespace

double OneStep::View::begin() const { return steps_.dense_.start().time; }

double OneStep::View::end() const { return steps_.window_.state->time; }

void OneStep::View::at(double time, State& state, Eigen::VectorXd& rates) {
  const bool cut = steps_.window_.change < HUGE_VAL;  // the step ends before all of its stages
  if (time >= end() && !cut) {
    state = *steps_.window_.state;
    rates = steps_.step_.K[steps_.step_.last()];
    return;
  }
  state = steps_.dense_.at(time);
  rates = steps_.dense_.rates();
}

OneStep::OneStep(Equations& equations, const IntegratorOptions& options)
    : equations_(equations),
      options_(options),
      usual_(tableau_of_order(options.order)),
      high_(options.window_order == 0 ? usual_ : tableau_of_order(options.window_order)),
      step_(equations.layout(), usual_, std::max(usual_.stages, high_.stages)),
      stages_(equations, options_, std::min(usual_.stages, high_.stages), step_, statistics_),
      start_(equations, options_, step_, stages_.norm(), statistics_),
      dense_(equations, step_),
      turns_(equations.model(), equations.layout()),
      may_be_singular_(equations.saddle().resting_row_changes() > 0),
      change_(step_.y) {}

void OneStep::forget() {
  stages_.newton().forget();
  stages_.predictor().forget();
  crossing_.forget();
  dense_.forget();
  choice_ = {};
  start_.forget();
  turning_.time = kNever;
  equations_.saddle().forget();
}

void OneStep::begin(State& state, double t_end, const Inputs& inputs, const WindowStops& stops) {
  FOOTFALL_DEMAND(t_end > state.time);
  equations_.recall(state);
  equations_.switch_modes(inputs, state);
  start_.start_window(inputs, state);
  if (state.time != turning_.time) turns_.measure(state, step_.K[0], turning_);
  window_ = {};
  window_.state = &state;
  window_.t_end = t_end;
  window_.inputs = &inputs;
  window_.stops = stops;
  window_.row_time = stops.row_after(state.time);
  window_.required = state.step > 0.0 ? state.step : std::min(t_end - state.time, first_step());
  window_.watch = ProgressWatch(state.time, t_end);
  if (&high_ != &usual_ && options_.error_control)
    window_.required = choice_.begin(t_end - state.time, window_.required);
}

WindowStop OneStep::next() {
  FOOTFALL_DEMAND(window_.state != nullptr);
  for (;;) switch (window_.phase) {
      case Window::kTrying:
        if (window_.ended || !(window_.state->time < window_.t_end)) {
          finish_window();
          return {};
        }
        if (try_next_step()) window_.phase = Window::kInRows;
        break;
      case Window::kInRows:
        if (window_.row_time < window_.t_end && window_.row_time <= window_.reached) {
          window_.phase = Window::kAtRow;
          return read_row();
        }
        reach_end();
        window_.phase = Window::kAtEnd;
        if (window_.stops.steps) return {WindowStop::kStep, nullptr, nullptr, &view_};
        break;
      case Window::kAtRow:
        if (window_.ended) {
          stay_at_row();
          finish_step();
        } else {
          window_.row_time = window_.stops.row_after(window_.row_time);
          window_.phase = Window::kInRows;
        }
        break;
      case Window::kAtEnd:
        leave_end();
        finish_step();
        break;
    }
}

bool OneStep::try_next_step() {
  State& state = *window_.state;
  double& required = window_.required;
  const double t = state.time, t_end = window_.t_end;
  const double h = options_.max_step > 0.0 ? std::min(required, options_.max_step) : required;
  const double planned = planned_step(t, h), steps = std::ceil((t_end - t) / planned * (1.0 - 1e-9));
  const double step = steps > (planned != h ? 1.0 : kStretch) ? planned : (t_end - t) / steps;
  errors_.limit = planned != h && t + step > crossing_.time() ? std::max(1.0, kCrossing / options_.rtol) : 1.0;
  const bool few_stages = choice_.stiff() && high_.stages > kManyStages;
  step_.tableau = choice_.high() && !few_stages ? &high_ : &usual_;
  const Outcome outcome = try_with_newer_jacobians(t, step, *window_.inputs);
  if (outcome == Outcome::kAccepted) {
    crossing_.count_success();
    choice_.see(stages_.newton().turns());
    required = next_step(step);
    if (window_.diverged && !may_be_singular_) required = std::min(required, kAfterDivergence * step);
    window_.diverged = false;
    if (errors_.last > 1.0 && errors_.limit > 1.0)
      statistics_.reported_error = std::max(statistics_.reported_error, errors_.last);
    accept(step, steps > 1.0 ? t + step : t_end);
    return true;
  }
  window_.diverged = outcome == Outcome::kNoConvergence;
  ++(outcome == Outcome::kTooInaccurate ? statistics_.rejected : statistics_.newton_failures);
  if (finds_another_step(h, planned, *window_.inputs, state)) return false;
  required = outcome == Outcome::kTooInaccurate ? std::min(next_step(step), 0.8 * step)
                                                : (may_be_singular_ ? kSingularDivergence : kDivergence) * step;
  if (required < options_.min_step)
    give_up(code::kStepTooSmall, t, "the step size fell below " + number_text(options_.min_step, 3) + " s; ");
  return false;
}

void OneStep::finish_step() {
  State& state = *window_.state;
  window_.phase = Window::kTrying;
  equations_.remember(*window_.inputs, state);
  if (std::exchange(window_.switched, false)) window_.required = std::min(window_.required, first_step());
  if (const std::string slow = window_.watch.check(state.time); !slow.empty())
    give_up(code::kNoProgress, state.time, slow);
  if (crossing_.careful()) look_ahead(state);
  crossing_.finish_step();
}

void OneStep::finish_window() {
  State& state = *window_.state;
  ++statistics_.windows;
  state.step = window_.required;
  if (!end_.used)
    statistics_.count(options_.projection ? equations_.saddle().project(state, SaddleSystem::Close::kWithOldFactors)
                                          : equations_.saddle().check_closed(state));
  start_.end_window(state);
  window_.state = nullptr;
}

double OneStep::first_step() {
  if (!options_.error_control) return std::numeric_limits<double>::infinity();
  ErrorNorm& norm = stages_.norm();
  norm.set(step_.y);
  const double size = norm(step_.y), rate = norm(step_.K[0]);
  return kFirst * size < rate * options_.min_step ? options_.min_step
         : rate > 0.0                             ? kFirst * size / rate
                                                  : std::numeric_limits<double>::infinity();
}

double OneStep::next_step(double h) const {
  // Without error control only Newton shortens steps: they grow again.
  const double factor =
      options_.error_control
          ? std::clamp(kSafety * std::pow(std::max(errors_.last, 1e-12), -1.0 / (step_.tableau->estimated_order + 1)),
                       kLeast, kMost)
          : 2.0;
  return h * factor;
}

OneStep::Outcome OneStep::try_with_newer_jacobians(double t, double h, const Inputs& inputs) {
  StageNewton& newton = stages_.newton();
  newton.begin_step(choice_.stiff());
  Outcome outcome = try_step(t, h, false, inputs);
  if (outcome == Outcome::kNoConvergence && !newton.fresh()) {
    newton.drop_factors();
    outcome = try_step(t, h, false, inputs);
  }
  if (outcome != Outcome::kNoConvergence || (!crossing_.careful() && !may_be_singular_)) return outcome;
  // Beyond a singular position a vanishing condition has changed its sign: with the Jacobian of the step's start
  // Newton diverges there for any length of the step, and steps would shrink towards the position. With the stages'
  // Jacobians the step passes over it.
  outcome = try_step(t, h, true, inputs);
  newton.drop_factors();
  return outcome;
}

OneStep::Outcome OneStep::try_step(double t, double h, bool at_stages, const Inputs& inputs) {
  start_.follow_resting_rows(t);
  if (!stages_.solve(t, h, {errors_.before, slow(), at_stages, choice_.stiff()}, inputs))
    return Outcome::kNoConvergence;
  errors_.last = stages_.estimated_error(t, h);
  if (!std::isfinite(errors_.last)) return Outcome::kNoConvergence;
  errors_.of_state = errors_.last;
  if (errors_.last <= errors_.limit || !options_.error_control)
    errors_.last =
        std::max(errors_.last, stages_.work_error(t, h, window_.state->work_error.scale, errors_.of_state, inputs));
  if ((errors_.last <= errors_.limit || !options_.error_control) && !close_end(t + h)) return Outcome::kTooInaccurate;
  return errors_.last <= errors_.limit || !options_.error_control ? Outcome::kAccepted : Outcome::kTooInaccurate;
}

void OneStep::accept(double h, double t_new) {
  State& state = *window_.state;
  ++statistics_.steps;
  statistics_.summed_error += errors_.of_state;
  dense_.begin(state, h);
  const std::size_t last = step_.last();
  // Work integrals with the weights of the method.
  for (std::size_t i = 0; i <= last; ++i) {
    const double b = i < last ? step_.tableau->a[last][i] : step_.tableau->gamma;
    if (b != 0.0) add_work(step_.energy[i], h * b, state);
  }
  add_step_error(stages_.work_error_parts(), state.work_error);
  equations_.layout().unpack(step_.Y[last], state);
  state.time = t_new;
  window_.h = h;
  window_.change = equations_.has_modes() ? dense_.time_of_switch(t_new, *window_.inputs) : HUGE_VAL;
  // A row just behind the step, by round-off, belongs to it.
  window_.reached = window_.change < HUGE_VAL ? window_.change : t_new + kNear * h;
}

WindowStop OneStep::read_row() {
  State& row = dense_.at(window_.row_time);
  statistics_.count(options_.projection ? equations_.saddle().project(row, SaddleSystem::Close::kWithOldFactors)
                                        : equations_.saddle().check_closed(row));
  equations_.saddle().smallest_multipliers(row, dense_.rates().tail(equations_.layout().row_count));
  turns_.follow(turning_, dense_.rates(), row);
  return {WindowStop::kRow, &row, &dense_.rates(), nullptr};
}

void OneStep::stay_at_row() {
  *window_.state = dense_.state();
  step_.K[0] = dense_.rates();
  turning_.time = kNever;
  stages_.predictor().forget();
  end_.used = false;
}

void OneStep::reach_end() {
  State& state = *window_.state;
  if (!(window_.change < HUGE_VAL)) {
    turns_.follow(turning_, step_.K[step_.last()], state, &turning_next_);
    return;
  }
  State& end = dense_.at(window_.change);
  turns_.follow(turning_, dense_.rates(), end);
  state = end;
  add_step_error(stages_.work_error_parts(), state.work_error);  // at most the error of the whole step
}

void OneStep::leave_end() {
  State& state = *window_.state;
  if (window_.change < HUGE_VAL) {
    switch_modes(*window_.inputs, state);
    return;
  }
  const std::size_t last = step_.last();
  std::swap(turning_, turning_next_);
  stages_.predictor().accept(*step_.tableau, window_.h, step_.K);
  std::swap(step_.energy[0], step_.energy[last]);
  errors_.before = errors_.last;
  step_.y.swap(step_.Y[last]);
  if (stages_.newton().fresh()) equations_.saddle().update_resting_rows(state);
  if (end_.used) {
    statistics_.count(end_.drift);
    state.q = end_.state.q;
    state.v = end_.state.v;
    equations_.layout().pack(state, step_.K[0].tail(equations_.layout().row_count), step_.y);
  }
  if (crossing_.careful()) {
    crossing_.finish_careful_step();
    start_.renew(*window_.inputs, state);
  }
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
  crossing_.look_ahead(equations_.saddle(), dense_.start_before(), dense_.start(), state,
                       options_.error_control && stages_.predictor().has_step());
}

void OneStep::switch_modes(const Inputs& inputs, State& state) {
  equations_.switch_modes(inputs, state);
  statistics_.count(options_.projection ? equations_.saddle().project(state) : equations_.saddle().check_closed(state));
  start_.renew(inputs, state);
  turns_.measure(state, step_.K[0], turning_);
  stages_.predictor().forget();
  stages_.newton().drop_factors();
  end_.used = false;
  window_.switched = true;
}

// If drift is large enough, or a singular position near, projection is a part of the step.
bool OneStep::close_end(double t) {
  end_.used = false;
  if (!options_.projection) return true;
  const Eigen::VectorXd& y_end = step_.Y[step_.last()];
  equations_.layout().unpack(y_end, end_.state);
  end_.state.time = t;
  const Drift drift = equations_.saddle().drift(end_.state);
  end_.used = crossing_.careful() || drift.position > kDrift * options_.atol ||
              drift.velocity > kDrift * options_.atol_velocity;
  if (!end_.used) return true;
  if (crossing_.careful()) equations_.saddle().forget();  // the motion must not depend on pivots chosen for output rows
  try {
    end_.drift = equations_.saddle().project(end_.state, SaddleSystem::Close::kFully);
  } catch (const NumericalError& error) {   // a joint cannot be closed
    const std::string text = error.what();  // "t = ... s: ..."; the time is reported once
    stages_.failure().reason = text.substr(text.find(": ") + 2);
    errors_.last = kOpen;
    return false;
  }
  const Layout& layout = equations_.layout();
  const ErrorNorm& norm = stages_.norm();
  change_.head(layout.q_size) = end_.state.q - y_end.head(layout.q_size);
  change_.segment(layout.v0(), layout.v_size) = end_.state.v - y_end.segment(layout.v0(), layout.v_size);
  change_.segment(layout.z0(), layout.z_size).setZero();
  if (!options_.error_control || !norm.far(change_)) return true;
  errors_.last = norm(change_);
  stages_.failure().worst = norm.worst(change_);
  stages_.failure().reason =
      with_code(code::kStepTooSmall, "near a position where conditions of joints become dependent, drift of " +
                                         number_text(drift.velocity, 3) + " m/s can be removed only by changing " +
                                         equations_.entry_name(stages_.failure().worst) + " by " +
                                         number_text(std::abs(change_[stages_.failure().worst]), 3) +
                                         ". Increase rtol: longer steps pass over the position.");
  return false;
}

void OneStep::start_clean(const Inputs& inputs, State& state) {
  equations_.saddle().forget();
  statistics_.count(equations_.saddle().project(state, SaddleSystem::Close::kFully));
  start_.renew(inputs, state);
  crossing_.look_again();
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
void OneStep::give_up(const MessageCode& code, double t, const std::string& what) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << "t = " << t << " s: " << what;
  if (!stages_.failure().reason.empty()) throw NumericalError(out.str() + stages_.failure().reason);
  out << "Newton's method or the error test fails at " << equations_.entry_name(std::max(stages_.failure().worst, 0))
      << ".";
  throw NumericalError(code, out.str());
}

}  // namespace footfall
