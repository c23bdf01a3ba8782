#include "mbd_solver/run/simulation.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "mbd_solver/coupling/fast_modes.h"
#include "mbd_solver/model/elements/rigid_plane.h"

namespace footfall {
namespace {

Baumgarte baumgarte(const SolverSpec& spec) {
  if (spec.drift == DriftKind::kProjection) return {};
  return {spec.baumgarte_velocity, spec.baumgarte_position};
}

IntegratorOptions integrator_options(const SolverSpec& spec) {
  IntegratorOptions options;
  options.rtol = spec.rtol;
  options.atol = spec.atol;
  options.atol_velocity = 100.0 * spec.atol;
  options.max_step = spec.max_step;
  options.error_control = spec.error_control;
  options.projection = spec.drift == DriftKind::kProjection;
  return options;
}

}  // namespace

Simulation::Simulation(const Scene& scene, double t_end, Transport* partner_transport)
    : scene_(scene),
      t_end_(t_end),
      mechanism_(build_mechanism(scene)),
      assembly_(assemble(mechanism_.model)),
      equations_(mechanism_.model, assembly_, baumgarte(scene.solver)),
      integrator_(
          make_integrator(std::string(name_of(scene.solver.integrator)), equations_, integrator_options(scene.solver))),
      state_(assembly_.state),
      rates_(Eigen::VectorXd::Zero(equations_.layout().size())),
      control_(mechanism_.controllers, {scene_, mechanism_, equations_.layout()}),
      sampler_({scene_, mechanism_, equations_.layout()}, equations_, state_, rates_, inputs_) {
  inputs_.voltages = mechanism_.voltages;
  if (!partner_transport) return;
  inputs_.loads.resize(static_cast<std::size_t>(mechanism_.model.body_count()));
  coupled_ = std::make_unique<CoupledRun>(scene, mechanism_, kinematics(), t_end, *partner_transport);
}

Subject Simulation::subject() const {
  return {scene_, mechanism_, equations_.layout(), coupled_ ? &coupled_->agreement() : nullptr};
}

Kinematics Simulation::kinematics() const {
  Kinematics kinematics(mechanism_.model);
  kinematics.load(equations_.layout(), state_.q, state_.v, Eigen::VectorXd());
  return kinematics;
}

bool Simulation::finished() const { return state_.time >= t_end_ * (1.0 - 1e-12); }

// Rows of the history and samples of controllers lie at ends of windows.
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

void Simulation::run(const std::function<void(const Sample&)>& observe, const volatile std::sig_atomic_t& interrupted) {
  const double started = wall_clock();
  const Sample& at = sampler_.sample();  // always of the last window's end
  equations_.accelerations(state_, inputs_, rates_);
  take_sample();
  observe(at);

  while (!finished() && interrupted == 0) {
    // Control: the voltages of the window.
    const double control_started = wall_clock();
    control_.sample_due(at, inputs_);
    times_.control += wall_clock() - control_started;

    // Window: with grains motion goes out and the mean load comes in, without it goes to the next stop.
    const double t_end =
        coupled_ ? coupled_->begin_window(state_, at.kinematics, at.energy.stored, inputs_) : next_stop();

    // Integrate, and check.
    const double mbd_started = wall_clock();
    integrator_->advance(state_, t_end, inputs_);
    rates_ = integrator_->end_rates();
    times_.mbd += wall_clock() - mbd_started;
    check_finite();
    ++window_;

    // Observe.
    take_sample();
    if (coupled_) coupled_->end_window(state_, at.kinematics);
    times_.total = wall_clock() - started;
    observe(at);
  }
  if (coupled_ && finished()) coupled_->close();
}

}  // namespace footfall
