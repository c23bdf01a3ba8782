// The mechanism is shown to the conditions as it would be at later times; afterwards it is as it
// was.

#include "mbd_solver/session/loop/event_foresight.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "coupler/base/errors.h"
#include "mbd_solver/session/loop/event_finder.h"
#include "mbd_solver/session/loop/moving_mechanism.h"

namespace footfall {
namespace {

constexpr double kForeseen = 0.1;  // of a DEM step: how exactly events are foreseen
constexpr double kFaster = 2.0;    // than loads have changed of late

}  // namespace

bool EventForesight::is_needed() const { return moving_.coupled() && signals_ && signals_->has_unsampled_events(); }

void EventForesight::begin_window() {
  if (!is_needed()) return;
  loads_before_ = moving_.inputs().loads;
  length_before_ = last_length_;
}

void EventForesight::end_window() {
  if (!moving_.coupled()) return;
  last_length_ = moving_.coupled()->window_length();
  if (is_needed()) largest_kinetic_ = std::max(largest_kinetic_, moving_.sample().energy.stored[Stored::kKinetic]);
}

// Means stand for the middles of their windows. A load that rises faster and faster has gone on by
// twice as much at most: windows end early rather than late, and the shorter ones tell more.
void EventForesight::extrapolate_loads(double time) {
  const double ahead = kFaster * (0.5 * last_length_ + time) / (0.5 * (last_length_ + length_before_));
  std::vector<ExternalLoad>& loads = moving_.inputs().loads;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    ExternalLoad& load = loads[i];
    const ExternalLoad& before = loads_before_[i];
    load.F_W += ahead * (load.F_W - before.F_W);
    load.T_B += ahead * (load.T_B - before.T_B);
    if (load.Q_a.size() > 0 && load.Q_a.size() == before.Q_a.size()) load.Q_a += ahead * (load.Q_a - before.Q_a);
  }
}

double EventForesight::find(double before) {
  foreseen_ = kNever;
  if (!is_needed()) return kNever;
  const CoupledRun& coupled = *moving_.coupled();
  const State now = moving_.state();
  const double dt = coupled.agreement().dt, end = std::min(coupled.longest_window_end(now.time), before);
  if (end < now.time + 1.5 * dt) return kNever;
  if (!integrator_) {
    const SolverSpec& solver = moving_.scene().solver;
    equations_ = std::make_unique<Equations>(moving_.mechanism().model, moving_.assembly(), baumgarte_of(solver));
    integrator_ = make_integrator("one_step", *equations_, integrator_options(solver, true));
  }
  const Eigen::VectorXd rates_now = moving_.rates();
  const std::vector<ExternalLoad> loads_now = moving_.inputs().loads;
  foreseen_ = find_under_present_loads(end, kForeseen * dt);
  moving_.inputs().loads = loads_now;
  moving_.show(now, rates_now);
  return foreseen_;
}

double EventForesight::find_under_present_loads(double end, double precision) {
  State state = moving_.state();
  const double now = state.time;
  Inputs inputs = moving_.inputs();
  for (ExternalLoad& load : inputs.loads) load.tangent.reset();  // of another path
  bool loads_vary = false;
  if (length_before_ > 0.0)
    for (std::size_t i = 0; i < inputs.loads.size(); ++i)
      loads_vary =
          loads_vary || inputs.loads[i].F_W != loads_before_[i].F_W || inputs.loads[i].T_B != loads_before_[i].T_B;
  const Eigen::VectorXd& values = moving_.inputs().values;
  const auto holds_at = [&](StepView& step, double time) {
    step.at(time, moving_.state(), moving_.rates());
    if (loads_vary) {
      moving_.inputs().loads = inputs.loads;
      extrapolate_loads(time - now);
      equations_->saddle().accelerations(moving_.state(), moving_.inputs(), moving_.rates());
    }
    moving_.update_sample();
    return signals_->triggered(moving_.sample(), values).event >= 0;
  };
  double event = kNever;
  Rows rows;
  rows.on_step = [&](StepView& step) {
    double early = step.begin(), late = step.end();
    if (!holds_at(step, late)) {
      const std::optional<double> between =
          holds_between(*signals_, moving_, early, late, precision, [&](double time) { return holds_at(step, time); });
      if (!between) {
        signals_->remember(moving_.sample(), values);
        return true;
      }
      late = *between;
    }
    while (late - early > precision) {
      const double middle = 0.5 * (early + late);
      (holds_at(step, middle) ? late : early) = middle;
    }
    event = late;
    return false;
  };
  signals_->triggered(moving_.sample(), values);
  signals_->remember(moving_.sample(), values);
  try {
    integrator_->forget();  // the result depends on the state alone
    integrator_->advance(state, end, inputs, rows);
  } catch (const NumericalError&) {  // the window's loads may be different
  }
  return event;
}

// A change of accelerations by da, H late, changes velocities by H da:  share = H sqrt(sum m |da|^2
// / 2 K),  K the largest kinetic energy so far.
void EventForesight::tell_of_late_event(const std::string& event, const Eigen::VectorXd& change) {
  if (!(largest_kinetic_ > 0.0)) return;
  double gained = 0.0;  // [J/s2]
  const Layout& layout = moving_.equations().layout();
  const Model& model = moving_.mechanism().model;
  for (int i = 0; i < model.body_count(); ++i)
    gained += 0.5 * model.body(i).mass() * change.segment<3>(layout.v0() + layout.body_v[i]).squaredNorm();
  CoupledRun& coupled = *moving_.coupled();
  const double time = moving_.state().time;
  coupled.tell_of_event(event, time, coupled.window_length() * std::sqrt(gained / largest_kinetic_), time < foreseen_);
}

void EventForesight::visit(Archive& archive) {
  archive.members<&EventForesight::loads_before_, &EventForesight::last_length_, &EventForesight::length_before_,
                  &EventForesight::largest_kinetic_>(*this);
}

}  // namespace footfall
