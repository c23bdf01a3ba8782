#include "mbd_solver/run/simulation.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/run/observe/start_values.h"
#include "mbd_solver/run/settle.h"

namespace footfall {
namespace {

Baumgarte baumgarte(const SolverSpec& spec) {
  if (spec.drift == DriftKind::kProjection) return {};
  return {spec.baumgarte_velocity, spec.baumgarte_position};
}

// Without grains windows that one step fills go by the third order, and longer ones by the fifth, which has the longer steps
// (window_order). With grains the windows are short, and their own error is of second order.
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
    if (!spec.error_control && !with_grains) options.order = 5;  // fixed steps: no window chooses
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
      assembly_(assemble(mechanism_.model, assembly_options(scene))),
      equations_(mechanism_.model, assembly_, baumgarte(scene.solver)),
      integrator_(make_integrator(std::string(name_of(scene.solver.integrator)), equations_,
                                  integrator_options(scene.solver, partner_transport != nullptr))),
      state_(assembly_.state),
      rates_(Eigen::VectorXd::Zero(equations_.layout().size())),
      control_(mechanism_, {scene_, mechanism_, equations_.layout()}),
      sampler_({scene_, mechanism_, equations_.layout()}, equations_, state_, rates_, inputs_),
      checkpoints_(scene.output.checkpoint_interval, scene.output.checkpoint_interval) {
  inputs_.values = mechanism_.inputs;
  inputs_change_ = std::isfinite(control_.next_sample());  // else nothing samples: rows alone end no window
  const Kinematics drawn = kinematics();
  if (scene.initial.settle && resume.empty()) start_settled();
  equations_.settle_signals(nullptr, inputs_, state_);
  if (partner_transport) {
    inputs_.loads.resize(static_cast<std::size_t>(mechanism_.model.body_count()));
    coupled_ =
        std::make_unique<CoupledRun>(scene, mechanism_, equations_, kinematics(), t_end, *partner_transport, resume);
    walls_ = coupled_->walls();
    set_walls(walls_, mechanism_);
  }
  collisions_ = std::make_unique<CollisionWatch>(scene, mechanism_, walls_, drawn);
  for (const std::string& note : collisions_->notes()) assembly_.notes.push_back(note);
  if (collisions_->watches_nothing()) collisions_.reset();
}

// Walls that the script has taken away hold nothing any more.
void Simulation::look_for_collisions() {
  if (coupled_ && !coupled_->gone_walls().empty()) {
    const std::vector<std::string>& gone = coupled_->gone_walls();
    walls_.erase(std::remove_if(walls_.begin(), walls_.end(),
                                [&](const StaticWall& wall) {
                                  return std::find(gone.begin(), gone.end(), wall.name) != gone.end();
                                }),
                 walls_.end());
    set_walls(walls_, mechanism_);
    if (collisions_) collisions_->forget_walls(gone);
  }
  if (collisions_) collisions_->look(subject(), sampler_.sample());
}

void Simulation::start_settled() {
  const Settled settled = settle(scene_, assembly_options(scene_), integrator_options(scene_.solver, false));
  state_.q = settled.state.q;
  state_.z = settled.state.z;
  equations_.saddle().project(state_);  // velocities of prescribed motions
  assembly_.notes.push_back("settled under the loads of the start: body \"" + settled.body + "\" moved most, by " +
                            number_text(settled.moved, 3) + " m; the largest acceleration left is " +
                            number_text(settled.acceleration, 3) + " m/s2 or rad/s2.");
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

// The next row of the history or sample of a controller.
double Simulation::next_stop() const {
  const double t = state_.time;
  const double tiny = 1e-9 * std::max(scene_.output.interval, 1e-6);
  const double next_row = (std::floor((t + tiny) / scene_.output.interval) + 1.0) * scene_.output.interval;
  return std::min({next_row, control_.next_sample(), t_end_});
}

void Simulation::check_finite() const {
  if (state_.q.allFinite() && state_.v.allFinite() && state_.z.allFinite()) return;
  throw NumericalError("t = " + std::to_string(state_.time) + " s: the state of the mechanism is not finite");
}

// Samples the controllers that are due, and remembers whether that has changed a voltage.
void Simulation::control() {
  const double due = control_.next_sample();
  const Eigen::VectorXd values = inputs_.values;
  control_.sample_due(sampler_.sample(), inputs_);
  if (control_.next_sample() > due) inputs_change_ = inputs_.values != values;
}

// started: on the clock on the wall [s].
bool Simulation::keep_now(const Keeper& keep, bool quietly, double started) {
  if (!quietly) {
    checkpoints_.take_turn(state_.time);
    integrator_->forget();
  }
  const double begun = wall_clock();
  times_.total = begun - started;
  if (!coupled_) keep.begin(window_);
  const bool done = !coupled_ || coupled_->wait_until_kept();
  done ? keep.finish() : keep.drop();
  times_.keeping += wall_clock() - begun;
  return done;
}

void Simulation::run(const std::function<void(const Sample&)>& observe, const volatile std::sig_atomic_t& interrupted,
                     const Keeper& keep) {
  const double started = wall_clock() - times_.total;
  const Sample& at = sampler_.sample();  // always of the present state
  if (!resumed_) equations_.saddle().accelerations(state_, inputs_, rates_);
  take_sample();
  if (collisions_) collisions_->begin(at.kinematics);
  if (!resumed_) let_events_happen();
  if (!resumed_) observe(at);
  checked_ = state_;

  // Without grains a window ends only where a voltage changes: rows and samples are read on the way. While each sample
  // changes it, windows end at samples, so that no step is cut.
  double on_the_way = 0.0;        // wall time of rows in a window [s]
  double last_row = state_.time;  // [s]
  const auto overdue = [&] { return keep.overdue && keep.overdue(); };
  Rows rows;
  if (!coupled_) {
    rows.next = [&](double) { return next_stop(); };
    rows.on_row = [&](const State& state, const Eigen::VectorXd& rates) {
      const double row_started = wall_clock();
      state_ = state;
      rates_ = rates;
      check_finite();
      ++window_;
      take_sample();
      look_for_collisions();
      if (event_holds()) {
        event_ahead_ = true;
        --window_;
        return false;
      }
      times_.total = row_started - started;
      observe(at);
      if (overdue()) keep_now(keep, true, started);
      control();
      last_row = state_.time;
      on_the_way += wall_clock() - row_started;
      return interrupted == 0 && !inputs_change_;
    };
  }

  // By a signal to this program, or to a rank of LIGGGHTS.
  const auto asked_to_end = [&] { return interrupted != 0 || (coupled_ && coupled_->asked_to_end()); };
  const auto due = [&](double time) { return checkpoints_.is_due(time) || asked_to_end(); };
  const auto set_at = [&](double end) {
    if (!keep || !(due(end) || overdue())) return WantedSet{};
    return WantedSet{keep.begin(window_ + 1), !due(end)};
  };

  // What the grains need not wait for: rows and inputs.
  bool untold = false;  // the sample
  const auto tell = [&] {
    if (!untold) return;
    untold = false;
    times_.total = wall_clock() - started;
    observe(at);
  };
  const auto sample_controllers = [&] {
    const double control_started = wall_clock();
    control();
    times_.control += wall_clock() - control_started;
  };
  const auto meanwhile = [&] {
    const double begun = wall_clock();
    tell();
    sample_controllers();
    times_.beside += wall_clock() - begun;
  };
  const auto exchange = [&] {
    try {
      return coupled_->begin_window(state_, at.kinematics, set_at, meanwhile, inputs_);
    } catch (...) {
      tell();  // the last row of a run that the grains have left
      throw;
    }
  };

  while (!finished()) {
    // Checkpoint: where the grains' side has kept itself as well.
    bool kept = false;
    if (keep && (coupled_ ? coupled_->keeps() : due(state_.time))) {
      tell();
      kept = keep_now(keep, coupled_ && coupled_->keeps_quietly(), started);
    }
    if (asked_to_end() && (kept || !keep)) break;

    // Window: with grains motion goes out and the mean load comes in.
    if (!coupled_) sample_controllers();
    const double t_end =
        coupled_
            ? exchange()
            : std::min({inputs_change_ ? control_.next_sample() : t_end_, t_end_, keep ? checkpoints_.next() : t_end_});
    if (coupled_ && coupled_->script_has_ended()) break;

    // Integrate, and check.
    const double mbd_started = wall_clock();
    on_the_way = 0.0;
    State state = state_;
    integrator_->advance(state, t_end, inputs_, rows);
    state_ = state;
    rates_ = integrator_->end_rates();
    times_.mbd += wall_clock() - mbd_started - on_the_way;
    check_finite();
    // A row has ended the window, and was observed.
    if (!event_ahead_ && state_.time < t_end && state_.time == last_row) continue;
    ++window_;

    // Observe.
    take_sample();
    look_for_collisions();
    if (event_ahead_ || event_holds()) find_event();
    if (coupled_) coupled_->end_window(state_, at.kinematics);
    untold = true;
    if (!coupled_) tell();
  }
  tell();
  if (coupled_ && finished()) coupled_->close();
}

}  // namespace footfall
