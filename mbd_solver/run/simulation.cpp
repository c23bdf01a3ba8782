// Two loops: alone, a window ends where an input changes, and output rows are read on the way; with grains, every window
// is one exchange, and output and control overlap with the grains. Events without a period are located by bisection.

#include "mbd_solver/run/simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coupler/base/clock.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/run/codes.h"
#include "mbd_solver/run/observe/attached_damping.h"
#include "mbd_solver/run/observe/carry_over.h"
#include "mbd_solver/run/observe/observation.h"
#include "mbd_solver/run/observe/requirements.h"
#include "mbd_solver/run/observe/start_values.h"
#include "mbd_solver/run/settle.h"

namespace footfall {

template <>
inline constexpr auto kFields<State> = std::tuple{Field{"time", &State::time},
                                                  Field{"q", &State::q},
                                                  Field{"v", &State::v},
                                                  Field{"z", &State::z},
                                                  Field{"dissipated", &State::dissipated},
                                                  Field{"load_work", &State::load_work},
                                                  Field{"supplied", &State::supplied},
                                                  Field{"work_error", &State::work_error},
                                                  Field{"angles", &State::angles},
                                                  Field{"uncertain_angle", &State::uncertain_angle},
                                                  Field{"memory", &State::memory},
                                                  Field{"step", &State::step}};

template <>
inline constexpr auto kFields<TangentLoad> =
    std::tuple{Field{"K", &TangentLoad::K}, Field{"C", &TangentLoad::C}, Field{"r_mean", &TangentLoad::r_mean},
               Field{"L_mean", &TangentLoad::L_mean}, Field{"v_mean", &TangentLoad::v_mean}};

template <>
inline constexpr auto kFields<ExternalLoad> =
    std::tuple{Field{"F_W", &ExternalLoad::F_W}, Field{"T_B", &ExternalLoad::T_B}, Field{"Q_a", &ExternalLoad::Q_a},
               Field{"tangent", &ExternalLoad::tangent}};

template <>
inline constexpr auto kFields<Inputs> = std::tuple{Field{"loads", &Inputs::loads}, Field{"values", &Inputs::values}};

template <>
inline constexpr auto kFields<RunTimes> = std::tuple{
    Field{"total", &RunTimes::total}, Field{"mbd", &RunTimes::mbd}, Field{"overlapped", &RunTimes::overlapped},
    Field{"control", &RunTimes::control}, Field{"checkpoint", &RunTimes::checkpoint}};

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kForeseen = 0.1;  // of a DEM step: how exactly events are foreseen
constexpr double kFaster = 2.0;    // than loads have changed of late

Baumgarte baumgarte(const SolverSpec& spec) {
  if (spec.drift == DriftKind::kProjection) return {};
  return {spec.baumgarte_velocity, spec.baumgarte_position};
}

// Without grains: third order for windows of one step, fifth order for longer ones, where it takes longer steps
// (window_order). With grains windows are short, and their own error is of second order.
int order_of(OneStepMethod method, bool with_grains) {
  switch (method) {
    case OneStepMethod::kAuto: return with_grains ? 2 : 3;
    case OneStepMethod::kTrBdf2: return 2;
    case OneStepMethod::kEsdirk3: return 3;
    case OneStepMethod::kEsdirk5: return 5;
  }
  FOOTFALL_DEMAND(false);
  return 0;
}

IntegratorOptions integrator_options(const SolverSpec& spec, bool with_grains) {
  IntegratorOptions options;
  options.order = order_of(spec.method, with_grains);
  if (spec.method == OneStepMethod::kAuto) {
    options.window_order = with_grains ? 3 : 5;
    if (!spec.error_control && !with_grains) options.order = 5;  // fixed steps: one order for all windows
  }
  options.rtol = spec.rtol;
  options.atol = spec.atol_position();
  options.atol_velocity = spec.atol_velocity();
  options.max_step = spec.max_step;
  options.error_control = spec.error_control;
  options.projection = spec.drift == DriftKind::kProjection;
  return options;
}

}  // namespace

Simulation::Simulation(const Scene& scene, double t_end, Transport* partner_transport, const std::string& resume)
    : scene_(scene),
      t_end_(t_end),
      mechanism_(build_mechanism(scene)),
      assembly_(assemble(mechanism_.model, assembly_options(scene, mechanism_.model))),
      equations_(mechanism_.model, assembly_, baumgarte(scene.solver)),
      corners_(scene, mechanism_),
      integrator_(make_integrator(std::string(name_of(scene.solver.integrator)), equations_,
                                  integrator_options(scene.solver, partner_transport != nullptr))),
      state_(assembly_.state),
      rates_(Eigen::VectorXd::Zero(equations_.layout().size())),
      control_(mechanism_, {scene_, mechanism_, equations_.layout()}),
      sampler_({scene_, mechanism_, equations_.layout()}, equations_, state_, rates_, inputs_),
      checkpoints_(scene.output.checkpoint_interval, scene.output.checkpoint_interval) {
  for (std::string& warning : damping_warnings_of_run(scene, mechanism_))
    mechanism_.warnings.push_back(std::move(warning));
  if (!scene.requirements.empty()) {
    const Observation observation(subject());
    for (std::string& warning : requirement_unit_warnings(scene, observation.names(), observation.units()))
      mechanism_.warnings.push_back(std::move(warning));
  }
  if (!scene.initial.from.empty() && resume.empty())  // the angles, which the assembly has counted from zero
    carry_over(scene, mechanism_.model, equations_.layout(), state_, &mechanism_.warnings);
  stiff_signals_ = std::make_unique<StiffSignals>(scene, mechanism_, assembly_, baumgarte(scene.solver));
  if (stiff_signals_->empty()) stiff_signals_.reset();
  inputs_.values = mechanism_.inputs;
  inputs_change_ = std::isfinite(control_.next_sample());  // otherwise nothing is sampled, and rows do not end a window
  const Kinematics reference = kinematics();
  if (scene.initial.settle && resume.empty()) settle_start();
  equations_.settle_signals(nullptr, inputs_, state_);
  equations_.switch_modes(inputs_, state_);
  if (partner_transport) {
    inputs_.loads.resize(static_cast<std::size_t>(mechanism_.model.body_count()));
    coupled_ = std::make_unique<CoupledRun>(scene, mechanism_, assembly_, equations_, kinematics(), t_end,
                                            *partner_transport, resume);
    walls_ = coupled_->walls();
    set_walls(walls_, mechanism_);
  }
  collisions_ = std::make_unique<CollisionWatch>(scene, mechanism_, walls_, reference);
  for (const std::string& note : collisions_->notes()) assembly_.notes.push_back(note);
  if (collisions_->empty()) collisions_.reset();
}

// The middles of steps without grains, where a peak may exceed those of the ends: a rate that comes near its largest so far is beyond
// both of its ends, by more than kBeyond of it.
class Simulation::StepMiddles {
 public:
  bool are_peaks(StepView& step) {
    step.at(step.end(), state_, end_);
    step.at(0.5 * (step.begin() + step.end()), state_, rates_);
    if (largest_.size() == 0) largest_ = Eigen::VectorXd::Zero(end_.size());
    largest_ = largest_.cwiseMax(end_.cwiseAbs()).cwiseMax(rates_.cwiseAbs());
    const bool known = time_ == step.begin();
    bool peaks = !known;
    const double round_off = kRoundOff * largest_.maxCoeff();
    for (Eigen::Index i = 0; i < rates_.size() && !peaks; ++i) {
      const double low = std::min(begin_[i], end_[i]), high = std::max(begin_[i], end_[i]);
      peaks = std::max(rates_[i] - high, low - rates_[i]) > kBeyond * largest_[i] + round_off &&
              std::abs(rates_[i]) > kNear * largest_[i];
    }
    begin_.swap(end_);
    time_ = step.end();
    return peaks;
  }
  const State& state() const { return state_; }  // in the middle of the last step
  const Eigen::VectorXd& rates() const { return rates_; }

 private:
  static constexpr double kBeyond = 1e-3, kNear = 0.5;  // [-]
  static constexpr double kRoundOff = 1e-10;            // of the largest rate of all [-]

  State state_;
  Eigen::VectorXd rates_, begin_, end_, largest_;
  double time_ = -1.0;  // of the last end [s]
};

struct Simulation::Loop {
  const std::function<void(const Sample&)>& observe;
  const volatile std::sig_atomic_t& interrupted;
  const CheckpointWriter& checkpoints;
  double started;                   // wall clock, minus the time of earlier parts of the run [s]
  bool observation_pending = true;  // the sample has not been observed
  StepMiddles middles = {};

  bool overdue() const { return checkpoints.overdue && checkpoints.overdue(); }
};

void Simulation::run(const std::function<void(const Sample&)>& observe, const volatile std::sig_atomic_t& interrupted,
                     const CheckpointWriter& checkpoints) {
  Loop loop{observe, interrupted, checkpoints, wall_clock() - times_.total};
  begin(loop);
  coupled_ ? run_coupled(loop) : run_alone(loop);
}

void Simulation::begin(Loop& loop) {
  if (!resumed_) equations_.saddle().accelerations(state_, inputs_, rates_);
  update_sample();
  if (collisions_) collisions_->begin(sampler_.sample().kinematics);
  if (!resumed_) {
    apply_events();
    sample_at_start();
    loop.observe(sampler_.sample());
  }
  if (resumed_ && control_.signals()) control_.signals()->triggered(sampler_.sample(), inputs_.values);  // is read
  loop.observation_pending = false;
  stand_without_event();
}

// The first row has what acts from the start on. A program that leads the run sets its signals after that row, and a signal that
// jumps at the start is read behind its jump.
void Simulation::sample_at_start() {
  for (const SignalSpec& signal : scene_.signals)
    if (signal.kind == SignalKind::kHost) return;
  if (corners_.next(state_.time, inputs_.values).before <= state_.time) return;
  const Eigen::VectorXd before = inputs_.values;
  sample_controllers();
  if (inputs_.values == before) return;
  equations_.saddle().accelerations(state_, inputs_, rates_);
  update_sample();
}

void Simulation::run_alone(Loop& loop) {
  // A window ends only where an input changes: rows and samples are read on the way. While every sample changes an
  // input, windows end at samples, so that no step is cut.
  double last_row = state_.time;  // [s]
  bool given = false;             // at the last stop of a leading program: windows end as where samples change inputs
  Rows rows;
  rows.next = [&](double t) { return next_stop(t); };
  rows.on_row = [&](const State& state, const Eigen::VectorXd& rates) {
    const double row_started = wall_clock();
    state_ = state;
    rates_ = rates;
    check_finite();
    ++window_;
    update_sample();
    check_collisions();
    if (event_triggered()) {
      event_in_window_ = true;
      --window_;
      return false;
    }
    times_.total = row_started - loop.started;
    loop.observe(sampler_.sample());
    if (loop.overdue()) save_checkpoint(loop, true);
    last_row = state_.time;
    const bool led = is_led();
    if (!led) sample_controllers();
    times_.mbd -= wall_clock() - row_started;  // advance() counts it
    return loop.interrupted == 0 && !inputs_change_ && !led && !given;
  };

  WindowWatch watch(state_.time);
  while (!finished()) {
    if (watch.is_stuck(state_.time, t_end_)) give_up_short_windows(watch.moved());
    const bool end_requested = loop.interrupted != 0;
    bool saved = false;
    const bool due = checkpoints_.is_due(state_.time) || end_requested || checkpoint_requested_;
    if (loop.checkpoints && due) saved = save_checkpoint(loop, false);
    checkpoint_requested_ = false;
    if (end_requested && (saved || !loop.checkpoints)) break;

    given = take_given() || (given && state_.time < stop_ - row_tolerance());
    cross_jump();
    sample_controllers();
    const double t_end = std::min(
        {inputs_change_ ? control_.next_sample() : t_end_, t_end_, given && stop_ > state_.time ? stop_ : t_end_,
         loop.checkpoints ? checkpoints_.next() : t_end_, corners_.next(state_.time, inputs_.values).before});
    const bool continuous_events = control_.signals() && control_.signals()->has_unsampled_events();
    if (observe_step_ || continuous_events)
      rows.on_step = [&](StepView& step) {
        const bool peaks = observe_step_ && loop.middles.are_peaks(step);
        if (!watch_step(step, t_end)) return false;
        if (!peaks) return true;
        const double middle_started = wall_clock();
        state_ = loop.middles.state();
        rates_ = loop.middles.rates();
        update_sample();
        observe_step_(sampler_.sample());
        times_.mbd -= wall_clock() - middle_started;
        return true;
      };
    advance(state_, t_end, rows);
    const bool ended_at_row = !event_in_window_ && state_.time < t_end && state_.time == last_row;
    if (ended_at_row) continue;  // observed already
    finish_window();
    cross_jump();
    loop.observation_pending = true;
    observe_sample(loop);
  }
}

void Simulation::give_up_short_windows(double moved) {
  const bool samples = control_.next_sample() < corners_.next_time(state_.time, inputs_.values);
  throw NumericalError(code::kWindowsTooShort,
                       "t = " + plain_text(state_.time) + " s: " + std::to_string(WindowWatch::kWatched) +
                           " windows advanced the time by only " + number_text(moved, 2) + " s of " +
                           number_text(t_end_) + " s. They end at " +
                           (samples ? "samples of signals or controllers: lengthen their period"
                                    : "corners of " + corners_.name_of_next(state_.time, inputs_.values) +
                                          ": remove points of tables that are so near to each other"));
}

void Simulation::run_coupled(Loop& loop) {
  const auto end_requested = [&] { return loop.interrupted != 0 || coupled_->end_requested(); };
  const auto checkpoint_at = [&](double time) -> CheckpointRequest {
    const bool last = time >= t_end_ * (1.0 - 1e-12);
    if (last && !scene_.output.keep_grains) return {};
    const bool due = last || checkpoints_.is_due(time) || end_requested() || checkpoint_requested_;
    if (!loop.checkpoints || !(due || loop.overdue())) return {};
    return {loop.checkpoints.begin(window_ + 1), !due};
  };
  // Work for which the grains need not wait.
  const auto meanwhile = [&] {
    const double started = wall_clock();
    observe_sample(loop);
    sample_controllers();
    times_.overlapped += wall_clock() - started;
  };
  const Kinematics& kinematics = sampler_.sample().kinematics;  // of the present state

  while (!finished()) {
    bool saved = false;
    if (loop.checkpoints && coupled_->checkpoint_required()) {
      observe_sample(loop);
      saved = save_checkpoint(loop, coupled_->checkpoint_undisturbed());
      checkpoint_requested_ = false;
    }
    if (end_requested() && (saved || !loop.checkpoints)) break;

    sample_before_window(loop);
    const double corner = corners_.next_time(state_.time, inputs_.values);
    double t_end = state_.time;
    try {
      double stop = std::min({control_.next_sample(), corner, stop_ > state_.time ? stop_ : kNever});
      foreseen_ = foreseen_event(stop);
      stop = std::min(stop, foreseen_);
      if (foresees_events()) {
        loads_before_ = inputs_.loads;
        length_before_ = last_length_;
      }
      t_end = coupled_->exchange(state_, kinematics, stop, checkpoint_at, meanwhile, inputs_);
    } catch (...) {
      observe_sample(loop);  // the last row of a run whose partner is gone
      throw;
    }
    if (coupled_->script_has_ended()) break;
    Rows rows;
    // An interval below the step of the grains asks for a row per window.
    if (observe_row_ && scene_.output.interval > 0.999 * coupled_->agreement().dt) {
      rows.next = [&](double t) { return next_row(t); };
      rows.on_row = [&](const State& state, const Eigen::VectorXd& rates) {
        state_ = state;
        rates_ = rates;
        update_sample();
        observe_row_(sampler_.sample());
        return true;
      };
    }
    if (observe_step_) rows.on_step = [&](StepView& step) { return watch_step(step, t_end); };
    advance(state_, t_end, rows);
    coupled_->settle_work(state_);
    if (corner <= t_end) coupled_->restart();
    last_length_ = coupled_->window_length();
    finish_window();
    coupled_->end_window(state_, kinematics);
    loop.observation_pending = true;
  }
  observe_sample(loop);
  if (finished() && scene_.output.keep_grains && loop.checkpoints && coupled_->checkpoint_required())
    save_checkpoint(loop, false);
  if (finished()) coupled_->close();
}

void Simulation::observe_sample(Loop& loop) {
  if (!loop.observation_pending) return;
  loop.observation_pending = false;
  times_.total = wall_clock() - loop.started;
  loop.observe(sampler_.sample());
  if (!coupled_) return;  // take_given() follows before the next window
  for (const GivenInput& given : given_) inputs_.values(given.place) = given.value;
  given_.clear();
}

bool Simulation::save_checkpoint(Loop& loop, bool undisturbed) {
  if (!undisturbed) {
    checkpoints_.take_turn(state_.time);
    integrator_->forget();
    loop.middles = {};  // as a resumed run begins
  }
  const double started = wall_clock();
  times_.total = started - loop.started;
  if (!coupled_) loop.checkpoints.begin(window_);
  const bool complete = !coupled_ || coupled_->wait_for_checkpoint();
  complete ? loop.checkpoints.finish() : loop.checkpoints.cancel();
  times_.checkpoint += wall_clock() - started;
  return complete;
}

// ---- one window ----

void Simulation::advance(State from, double time, const Rows& rows) {
  const double started = wall_clock();
  for (;;) {
    const Corner corner = corners_.next_step_end(from.time, inputs_.values);
    const double end = std::min(corner.before, time);
    if (from.time < end) {
      integrator_->advance(from, end, inputs_, rows);
      rates_ = integrator_->end_rates();
    }
    if (end == time || from.time < end) break;
    if (rows.on_row && is_stop(end) && !rows.on_row(from, rates_) && is_led()) break;
    from.time = corner.after;
    if (from.time < time) continue;
    equations_.saddle().accelerations(from, inputs_, rates_);
    break;
  }
  state_ = from;
  times_.mbd += wall_clock() - started;
  check_finite();
}

bool Simulation::watch_step(StepView& step, double window_end) {
  if (!(step.end() < window_end)) return true;  // finish_window() follows
  const double started = wall_clock();
  step.at(step.end(), state_, rates_);
  if (scene_.output.reactions || !mechanism_.gears.empty())
    equations_.saddle().smallest_multipliers(state_, rates_.tail(equations_.layout().row_count));
  update_sample();
  const bool goes_on = coupled_ || !event_triggered();
  if (goes_on && observe_step_) observe_step_(sampler_.sample());
  event_in_window_ = event_in_window_ || !goes_on;
  times_.mbd -= wall_clock() - started;  // advance() counts it
  return goes_on;
}

void Simulation::cross_jump() {
  const Corner corner = corners_.next(state_.time, inputs_.values);
  if (!(corner.before <= state_.time)) return;
  state_.time = corner.after;
  equations_.saddle().accelerations(state_, inputs_, rates_);
  update_sample();
  if (event_triggered()) locate_event();
}

void Simulation::finish_window() {
  ++window_;
  update_sample();
  if (foresees_events())
    largest_kinetic_ = std::max(largest_kinetic_, sampler_.sample().energy.stored[Stored::kKinetic]);
  check_collisions();
  if (event_in_window_ || event_triggered()) locate_event();
}

double Simulation::row_tolerance() const { return 1e-9 * std::max(scene_.output.interval, 1e-6); }

double Simulation::next_row(double t) const {
  const double interval = scene_.output.interval;
  return (std::floor((t + row_tolerance()) / interval) + 1.0) * interval;
}

double Simulation::next_stop(double t) const {
  const double next = std::min({next_row(t), control_.next_sample(), t_end_});
  return stop_ > t && stop_ < next - row_tolerance() ? stop_ : next;
}

bool Simulation::is_stop(double t) const {
  return next_row(t - 2.0 * row_tolerance()) < t + row_tolerance() || std::abs(stop_ - t) <= row_tolerance();
}

bool Simulation::take_given() {
  if (given_.empty()) return false;
  for (const GivenInput& given : given_) inputs_.values(given.place) = given.value;
  given_.clear();
  if (!control_.signals()) return true;
  equations_.saddle().accelerations(state_, inputs_, rates_);
  update_sample();
  apply_events();
  return true;
}

bool Simulation::foresees_events() const {
  return coupled_ && control_.signals() && control_.signals()->has_unsampled_events();
}

// Means stand for the middles of their windows. A load that rises faster and faster has gone on by twice as much at most: windows
// end early rather than late, and the shorter ones tell more.
void Simulation::extrapolate_loads(double time) {
  const double ahead = kFaster * (0.5 * last_length_ + time) / (0.5 * (last_length_ + length_before_));
  for (std::size_t i = 0; i < inputs_.loads.size(); ++i) {
    ExternalLoad& load = inputs_.loads[i];
    const ExternalLoad& before = loads_before_[i];
    load.F_W += ahead * (load.F_W - before.F_W);
    load.T_B += ahead * (load.T_B - before.T_B);
    if (load.Q_a.size() > 0 && load.Q_a.size() == before.Q_a.size()) load.Q_a += ahead * (load.Q_a - before.Q_a);
  }
}

// The grains move before their load is known, so an event cannot cut the window in which it happens. A second integrator goes
// on under the mean loads of the last window instead, to see where the window that comes must end; conditions read loads and
// accelerations as they follow from the last two windows. Another event takes effect at the end of its window.
double Simulation::foreseen_event(double before) {
  SignalLoop* const signals = control_.signals();
  const double dt = coupled_->agreement().dt, end = std::min(coupled_->longest_window_end(state_.time), before);
  if (!foresees_events() || end < state_.time + 1.5 * dt) return kNever;
  if (!foresight_) {
    foresight_equations_ = std::make_unique<Equations>(mechanism_.model, assembly_, baumgarte(scene_.solver));
    foresight_ = make_integrator("one_step", *foresight_equations_, integrator_options(scene_.solver, true));
  }
  const State now = state_;
  const Eigen::VectorXd rates_now = rates_;
  Inputs inputs = inputs_;
  for (ExternalLoad& load : inputs.loads) load.tangent.reset();  // of another path
  const std::vector<ExternalLoad> loads_now = inputs_.loads;
  bool loads_vary = false;
  if (length_before_ > 0.0)
    for (std::size_t i = 0; i < loads_now.size(); ++i)
      loads_vary = loads_vary || loads_now[i].F_W != loads_before_[i].F_W || loads_now[i].T_B != loads_before_[i].T_B;
  double event = kNever;
  const auto holds_at = [&](StepView& step, double time) {
    step.at(time, state_, rates_);
    if (loads_vary) {
      inputs_.loads = inputs.loads;
      extrapolate_loads(time - now.time);
      foresight_equations_->saddle().accelerations(state_, inputs_, rates_);
    }
    update_sample();
    return signals->triggered(sampler_.sample(), inputs_.values).event >= 0;
  };
  Rows rows;
  rows.on_step = [&](StepView& step) {
    double early = step.begin(), late = step.end();
    if (!holds_at(step, late)) {
      const std::optional<double> between =
          holds_between(early, late, kForeseen * dt, [&](double time) { return holds_at(step, time); });
      if (!between) {
        signals->remember(sampler_.sample(), inputs_.values);
        return true;
      }
      late = *between;
    }
    while (late - early > kForeseen * dt) {
      const double middle = 0.5 * (early + late);
      (holds_at(step, middle) ? late : early) = middle;
    }
    event = late;
    return false;
  };
  signals->triggered(sampler_.sample(), inputs_.values);
  signals->remember(sampler_.sample(), inputs_.values);
  try {
    State state = now;
    foresight_->forget();  // the result depends on the state alone
    foresight_->advance(state, end, inputs, rows);
  } catch (const NumericalError&) {  // these loads need not be those of the window
  }
  state_ = now;
  rates_ = rates_now;
  inputs_.loads = loads_now;
  update_sample();
  return event;
}

// A change of accelerations by da, H late, changes velocities by H da:  share = H sqrt(sum m |da|^2 / 2 K),  K the largest
// kinetic energy so far.
void Simulation::tell_of_late_event(const std::string& event, const Eigen::VectorXd& change) {
  if (!(largest_kinetic_ > 0.0)) return;
  double gained = 0.0;  // [J/s2]
  const Layout& layout = equations_.layout();
  for (int i = 0; i < mechanism_.model.body_count(); ++i)
    gained += 0.5 * mechanism_.model.body(i).mass() * change.segment<3>(layout.v0() + layout.body_v[i]).squaredNorm();
  coupled_->tell_of_event(event, state_.time, coupled_->window_length() * std::sqrt(gained / largest_kinetic_),
                          state_.time < foreseen_);
}

void Simulation::sample_before_window(Loop& loop) {
  if (control_.next_sample() > state_.time + 1e-6 * coupled_->agreement().dt) return;
  observe_sample(loop);
  const Eigen::VectorXd before = inputs_.values;
  sample_controllers();
  if (!control_.signals() || inputs_.values == before) return;
  equations_.saddle().accelerations(state_, inputs_, rates_);
  update_sample();
  coupled_->restart();
}

void Simulation::check_finite() const {
  if (state_.q.allFinite() && state_.v.allFinite() && state_.z.allFinite()) return;
  throw NumericalError(code::kStateNotFinite,
                       "t = " + plain_text(state_.time) + " s: the state of the mechanism is not finite");
}

void Simulation::sample_controllers() {
  const double started = wall_clock(), due = control_.next_sample();
  const Eigen::VectorXd values = inputs_.values;
  control_.sample_due(sampler_.sample(), inputs_);
  if (control_.next_sample() > due) {
    inputs_change_ = inputs_.values != values;
    if (stiff_signals_) stiff_signals_->observe(state_, inputs_);
  }
  times_.control += wall_clock() - started;
}

// Walls that the script has removed no longer act.
void Simulation::check_collisions() {
  if (coupled_ && !coupled_->gone_walls().empty()) {
    const std::vector<std::string>& gone = coupled_->gone_walls();
    walls_.erase(std::remove_if(walls_.begin(), walls_.end(),
                                [&](const StaticWall& wall) {
                                  return std::find(gone.begin(), gone.end(), wall.name) != gone.end();
                                }),
                 walls_.end());
    set_walls(walls_, mechanism_);
    if (collisions_) collisions_->remove_walls(gone);
  }
  if (collisions_) collisions_->check(subject(), sampler_.sample());
}

// ---- events of the scene ----

bool Simulation::event_triggered() {
  SignalLoop* const signals = control_.signals();
  if (!signals) return false;
  if (signals->triggered(sampler_.sample(), inputs_.values).event >= 0) return true;
  if (!signals->has_unsampled_events()) return false;
  if (!coupled_ && without_event_.time < state_.time && signals->may_have_held(sampler_.sample(), inputs_.values)) {
    event_between_ = true;
    return true;
  }
  stand_without_event();
  return false;
}

void Simulation::stand_without_event() {
  without_event_ = state_;
  if (control_.signals()) control_.signals()->remember(sampler_.sample(), inputs_.values);
}

// The comparisons of conditions change at instants that bisection finds, each by itself; between two of them the condition is
// tried. Nothing: it holds nowhere between two times, at which it does not hold; the sample is that of the later one.
std::optional<double> Simulation::holds_between(double begin, double end, double precision,
                                                const std::function<bool(double)>& holds_at) {
  SignalLoop& signals = *control_.signals();
  if (!signals.may_have_held(sampler_.sample(), inputs_.values)) return std::nullopt;
  std::vector<double> instants;
  for (const std::size_t one : signals.changed(sampler_.sample(), inputs_.values)) {
    double early = begin, late = end;
    while (late - early > precision) {
      const double middle = 0.5 * (early + late);
      if (middle <= early || middle >= late) break;
      holds_at(middle);
      const std::vector<std::size_t> now = signals.changed(sampler_.sample(), inputs_.values);
      (std::find(now.begin(), now.end(), one) != now.end() ? late : early) = middle;
    }
    instants.push_back(late);
  }
  std::sort(instants.begin(), instants.end());
  for (std::size_t i = 1; i < instants.size(); ++i)
    if (const double middle = 0.5 * (instants[i - 1] + instants[i]); middle > begin && holds_at(middle)) return middle;
  holds_at(end);
  return std::nullopt;
}

// False: the condition held nowhere, and the state is as it was.
bool Simulation::find_between() {
  const State end = state_, begin = without_event_;
  const Eigen::VectorXd end_rates = rates_;
  const auto holds_at = [&](double time) {
    advance(begin, time);
    update_sample();
    return control_.signals()->triggered(sampler_.sample(), inputs_.values).event >= 0;
  };
  if (holds_between(begin.time, end.time, kEventTime, holds_at)) return true;
  integrator_->forget();
  state_ = end;
  rates_ = end_rates;
  update_sample();
  stand_without_event();
  return false;
}

// One at a time, in the order of the scene: conditions are evaluated in the state that the previous event leads to.
void Simulation::apply_events() {
  SignalLoop* const signals = control_.signals();
  if (!signals) return;
  const double time = state_.time;
  std::string names;
  for (std::size_t count = 0;; ++count) {
    const SignalLoop::Trigger trigger = signals->triggered(sampler_.sample(), inputs_.values);
    const int event = trigger.event;
    if (event < 0) break;
    names += (names.empty() ? "\"" : ", \"") + signals->event_name(event) + "\"";
    if (count > signals->state_count())
      throw NumericalError(code::kEventLoop, "t = " + plain_text(time) +
                                                 " s: events trigger each other without end: " + names +
                                                 ": give each a condition that is false in the state it leads to");
    if (!coupled_) event_watch_.count(signals->event_name(event), time, t_end_);
    const Eigen::VectorXd before = inputs_.values, rates = rates_;
    signals->apply(event, time, inputs_.values);
    equations_.settle_signals(&before, inputs_, state_);
    equations_.saddle().accelerations(state_, inputs_, rates_);
    update_sample();
    if (coupled_) coupled_->restart();
    if (coupled_ && !trigger.sampled) tell_of_late_event(signals->event_name(event), rates_ - rates);
  }
  stand_without_event();
}

// Bisection: a condition is true or false, and may depend on anything in a sample.
void Simulation::locate_event() {
  event_in_window_ = false;
  if (std::exchange(event_between_, false) && !find_between()) return;
  SignalLoop& signals = *control_.signals();
  const bool sampled = signals.triggered(sampler_.sample(), inputs_.values).sampled;
  if (!coupled_ && !sampled && without_event_.time < state_.time) {
    const double step = without_event_.step;
    const auto go_to = [&](double time) {
      advance(without_event_, time);
      update_sample();
    };
    double late = state_.time;
    while (late - without_event_.time > kEventTime) {
      const double middle = 0.5 * (without_event_.time + late);
      if (middle <= without_event_.time || middle >= late) break;
      go_to(middle);
      if (signals.triggered(sampler_.sample(), inputs_.values).event >= 0) {
        late = middle;
      } else {
        without_event_ = state_;
      }
    }
    if (state_.time != late) go_to(late);
    state_.step = step;
  }
  apply_events();
}

// ---- start, checkpoint ----

void Simulation::settle_start() {
  const Settled settled =
      settle(scene_, assembly_options(scene_, mechanism_.model), integrator_options(scene_.solver, false));
  state_.q = settled.state.q;
  state_.z = settled.state.z;
  state_.angles = settled.state.angles;
  state_.memory = settled.state.memory;
  equations_.recall(state_);
  equations_.saddle().project(state_);  // velocities of prescribed motions
  assembly_.notes.push_back(
      with_code(code::kSettled, "the mechanism was settled under the loads of the start: body \"" + settled.body +
                                    "\" moved most, by " + number_text(settled.moved, 3) +
                                    " m; the largest remaining acceleration is " +
                                    number_text(settled.acceleration, 3) + " m/s2 or rad/s2."));
}

Subject Simulation::subject() const {
  return {scene_, mechanism_, equations_.layout(), coupled_ ? &coupled_->agreement() : nullptr};
}

Kinematics Simulation::kinematics() const {
  Kinematics kinematics(mechanism_.model);
  kinematics.load(equations_.layout(), state_.q, state_.v, Eigen::VectorXd());
  return kinematics;
}

bool Simulation::finished() const {
  return state_.time >= t_end_ * (1.0 - 1e-12) || (coupled_ && coupled_->script_has_ended());
}

// The integrator's history is dropped at a checkpoint, in the run that continues and in the resumed one.
void Simulation::visit(Archive& archive) {
  archive("state", state_);
  archive("rates", rates_);
  archive("inputs", inputs_);
  archive("window", window_);
  archive("inputs_change", inputs_change_);
  archive("loads_before", loads_before_);
  archive("last_length", last_length_);
  archive("length_before", length_before_);
  archive("largest_kinetic", largest_kinetic_);
  archive("times", times_);
  archive("next_checkpoint", checkpoints_);
  archive("control", control_);
  IntegratorStatistics statistics = integrator_->statistics();
  archive("statistics", statistics);
  if (archive.restores()) integrator_->resume(statistics);
  if (archive.restores()) equations_.recall(state_);
  if (coupled_) archive("coupled", *coupled_);
  if (archive.restores()) given_.clear();
  resumed_ = archive.restores();
}

}  // namespace footfall
