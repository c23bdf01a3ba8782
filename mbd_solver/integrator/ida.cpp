#include "mbd_solver/integrator/ida.h"

#include <ida/ida.h>
#include <sundials/sundials_version.h>

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/integrator/ida_sundials.h"
#include "mbd_solver/integrator/progress_watch.h"

namespace footfall {
namespace {

constexpr double kProjectAbove = 1e-9;       // drift [m or rad] that stays in a run that goes on
constexpr double kProjectSpeedAbove = 5e-9;  // [m/s or rad/s]
// Drift that stays within a window [in absolute tolerances of a step], at least round-off. At a distance s from a position
// in which conditions become dependent, loops that are open by d ask for multipliers of d / s^2: what is more than a part of
// a step's error turns the motion there, and no step is short enough for what the multipliers then do.
constexpr double kDriftKept = 0.1;
constexpr double kLeastDrift = 1e-12, kLeastSpeedDrift = 1e-11;  // [m or rad], [m/s or rad/s]
// Sum of the errors of all steps [tolerances] that a run warns of; a motion may make them ten times larger.
constexpr double kTold = 10.0;
constexpr int kRenewRest = 10;  // steps after which resting rows are looked at

bool same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a.size() == b.size() && a == b; }

bool same(const ExternalLoad& a, const ExternalLoad& b) {
  if (a.F_W != b.F_W || a.T_B != b.T_B || !same(a.Q_a, b.Q_a) || a.tangent.has_value() != b.tangent.has_value())
    return false;
  return !a.tangent ||
         (a.tangent->K == b.tangent->K && a.tangent->C == b.tangent->C && a.tangent->r_mean == b.tangent->r_mean &&
          a.tangent->L_mean == b.tangent->L_mean && a.tangent->v_mean == b.tangent->v_mean);
}

bool same(const Inputs& a, const Inputs& b) {
  return same(a.voltages, b.voltages) && a.loads.size() == b.loads.size() &&
         std::equal(a.loads.begin(), a.loads.end(), b.loads.begin(),
                    [](const ExternalLoad& x, const ExternalLoad& y) { return same(x, y); });
}

}  // namespace

Ida::Ida(Equations& equations, const IntegratorOptions& options)
    : ida_(std::make_unique<Sundials>(equations, options)) {}

Ida::~Ida() = default;

std::string Ida::warning() const {
  if (statistics_.told_error <= kTold) return {};
  return "the errors of the " + std::to_string(statistics_.steps) + " steps of solver.integrator = \"ida\" add up to " +
         number_text(statistics_.told_error, 2) +
         " times solver.rtol and solver.atol: the end may be off by as much. Compare with \"one_step\", which takes "
         "longer steps where parts are stiff, or make solver.rtol smaller";
}

const Eigen::VectorXd& Ida::end_rates() const { return ida_->rates; }

void Ida::forget() {
  ida_->state_last = {};
  ida_->forget_passage();
  ida_->equations.forget();
  ida_->check(SUNLinSol_KLUReInit(ida_->solver, ida_->matrix, SUNSparseMatrix_NNZ(ida_->matrix), SUNKLU_REINIT_PARTIAL),
              "SUNLinSol_KLUReInit");
}

void Ida::resume(const IntegratorStatistics& so_far) {
  forget();
  statistics_ = so_far;
  ida_->jacobians = so_far.jacobians;
}

void Ida::advance(State& state, double t_end, const Inputs& inputs, const Rows& rows) {
  Sundials& s = *ida_;
  FOOTFALL_DEMAND(t_end > state.time);
  s.inputs_now = &inputs;
  const bool goes_on = state.time == s.state_last.time && same(state.q, s.state_last.q) &&
                       same(state.v, s.state_last.v) && same(state.z, s.state_last.z) && same(inputs, s.inputs_last);
  if (goes_on) s.aim(t_end, rows, state);
  bool starts = !goes_on, ended_by_row = false;
  Equations::Drift drift;
  int steps = 0;
  ProgressWatch watch(state.time, t_end);
  const double kept_position = std::max(kLeastDrift, kDriftKept * s.share * s.options.atol);
  const double kept_velocity = std::max(kLeastSpeedDrift, kDriftKept * s.share * s.options.atol_velocity);
  while (!ended_by_row && state.time < t_end) {
    if (state.time < s.passage_end) {
      ended_by_row = !s.pass(t_end, inputs, rows, state, statistics_);
      drift = {};
      starts = true;
      continue;
    }
    if (starts) {
      s.restart(state, inputs, statistics_);
      s.aim(t_end, rows, state);
      starts = false;
    }
    ended_by_row = !s.step(t_end, inputs, rows, state, statistics_);
    if (++steps % kRenewRest == 0) s.equations.renew_rest(state);
    if (const std::string slow = watch.complaint(state.time); !slow.empty()) s.give_up(slow);
    drift = s.options.projection ? s.equations.drift(state) : s.equations.check_closed(state);
    if (!ended_by_row) s.look_ahead(state);
    if (ended_by_row || state.time >= t_end || !s.options.projection ||
        (drift.position < kept_position && drift.velocity < kept_velocity))
      continue;
    statistics_.count(s.equations.project(state, Equations::Close::kFully));
    if (s.move_history(state)) continue;
    s.equations.forget();  // pivots of other positions shall not turn the motion here
    s.equations.project(state, Equations::Close::kFully);
    starts = true;
  }
  s.count(statistics_);
  ++statistics_.windows;

  bool goes_on_next = !ended_by_row && !starts;
  if (s.options.projection && (drift.position > kProjectAbove || drift.velocity > kProjectSpeedAbove)) {
    drift = s.equations.project(state);
    goes_on_next = goes_on_next && s.move_history(state);
  }
  s.state_last = goes_on_next ? state : State{};
  s.inputs_last = inputs;
  statistics_.count(drift);
  if (!ended_by_row) s.equations.smallest_multipliers(state, s.rates.tail(s.equations.layout().row_count));
}

std::string sundials_version() {
  char version[64] = "unknown";
  SUNDIALSGetVersion(version, sizeof version);
  return version;
}

}  // namespace footfall
