// The windows of all coupled bodies: BodyWindow makes the motion and applies the load, ContactMass gives the mass that
// contacts meet, CouplingWatch checks the result, WindowChoice sets the next length. Clocks show who waited for whom.

#include "mbd_solver/coupling/coupled_run.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/messages.h"
#include "coupler/schemes/registry.h"
#include "mbd_solver/coupling/codes.h"
#include "mbd_solver/coupling/window_choice.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

// The mass that contacts meet changes slowly with the attitude of the mechanism; computed in every window it would cost
// run time.
constexpr int kMassInterval = 10;   // windows
constexpr double kSameTime = 1e-6;  // of a DEM step: round-off of a time

// A number that the scene passes to the script; 0: none.
double script_variable(const Scene& scene, const std::string& name) {
  const auto found = scene.particles->variables.find(name);
  if (found == scene.particles->variables.end()) return 0.0;
  char* end = nullptr;
  const double value = read_number(found->second.c_str(), &end);
  return *end == '\0' ? value : 0.0;
}

std::vector<std::string> bodies_stopped_by_walls(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const ContactEntry& entry : mechanism.contacts)
    if (entry.walls != nullptr)
      names.push_back(mechanism.model.body(entry.force.of(mechanism.model).bodies()[0]).name());
  return names;
}

DemTerms terms_of(const Scene& scene, const Mechanism& mechanism, double t_end, const std::string& resume) {
  DemTerms terms;
  terms.scheme = scene.coupling.scheme;
  terms.t_end = t_end;
  terms.gravity = scene.gravity;
  terms.held_by_walls = bodies_stopped_by_walls(mechanism);
  terms.outflow = scene.particles->outflow;
  terms.resume = resume;
  terms.n_max = scene.coupling.max_substeps;
  terms.max_dt = scene.particles->max_time_step;
  terms.expected_dt = script_variable(scene, "dt");
  terms.expected_n = static_cast<int>(std::min(script_variable(scene, "every"), 1.0 * std::numeric_limits<int>::max()));
  return terms;
}

// Every body with a boundary; the script may couple fewer.
std::vector<CoupledBody> bodies_with_boundary(const Mechanism& mechanism, const Kinematics& start) {
  std::vector<CoupledBody> bodies;
  for (const BodyBoundary& entry : mechanism.boundaries) {
    bodies.push_back({entry.boundary, BodyMotion(entry.boundary.mode_count())});
    fill_motion(start.of(entry.body), bodies.back().initial);
  }
  return bodies;
}

}  // namespace

template <>
inline constexpr auto kFields<CouplingSample> =
    kFieldsOf<&CouplingSample::substeps, &CouplingSample::estimate, &CouplingSample::energy_residual,
              &CouplingSample::omega_h, &CouplingSample::changes>;

CoupledRun::CoupledRun(const Scene& scene, const Mechanism& mechanism, const Assembly& assembly, Equations& equations,
                       const Kinematics& start, double t_end, Transport& transport, const std::string& resume)
    : mechanism_(mechanism),
      equations_(equations),
      gravity_(scene.gravity),
      up_(up_direction(scene.gravity)),
      scheme_(make_scheme(scene.coupling.scheme)),
      partner_(transport, bodies_with_boundary(mechanism, start), terms_of(scene, mechanism, t_end, resume),
               scene.coupling.timeout),
      agreement_{partner_.dt(), partner_.substeps(), partner_.coupled(), scheme_.get()} {
  std::vector<std::string> names;
  std::vector<double> masses;
  double weight = std::numeric_limits<double>::infinity();  // of the lightest body [N]
  for (const int i : agreement_.boundaries) {
    const std::size_t boundary = i;
    const BodyBoundary& entry = mechanism.boundaries[boundary];
    const Body& body = mechanism.model.body(entry.body);
    BodyMotion motion(entry.boundary.mode_count());
    fill_motion(start.of(entry.body), motion);
    const bool known = !mechanism.placement.sites.empty();
    bodies_.push_back({entry, body, known ? &mechanism.placement.sites[boundary] : nullptr,
                       BodyWindow(*scheme_, body, motion), ContactMass(equations, entry.body, entry.boundary), motion,
                       entry.boundary.rho0().colwise().norm().maxCoeff()});
    motion_.bodies.push_back(motion);
    names.push_back(entry.boundary.name());
    masses.push_back(body.mass());
    weight = std::min(weight, body.mass() * scene.gravity.norm());
  }
  std::vector<int> bodies;
  for (const Coupled& body : bodies_) bodies.push_back(body.entry.body);
  known_motion_ = std::make_unique<KnownMotion>(mechanism.model, assembly, assembly.state, std::move(bodies));
  watched_.resize(bodies_.size());
  watch_ = std::make_unique<CouplingWatch>(names, scene.coupling, *scheme_, coupling_advice(scene, chooses_windows()));
  for (const std::string& warning : partner_.warnings()) watch_->warn(warning);
  sample_.omega_h = watch_->omega_h();
  choice_ = std::make_unique<WindowChoice>(scene.coupling, agreement_.dt, weight,
                                           OmegaHLimit(*scheme_, scene.coupling.warn_omega_h));
  choice_bodies_.resize(bodies_.size());
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    choice_bodies_[k].mass = masses[k];
    if (!chooses_windows()) continue;
    choice_bodies_[k].flight =
        flight_time(bodies_[k].end, bodies_[k].entry.boundary, mechanism.placement, up_, bodies_[k].site);
  }
  choice_->start(choice_bodies_);
}

void CoupledRun::visit(Archive& archive) {
  archive("window", motion_.window);
  archive("n", motion_.n);
  archive("restarts", restarts_);
  for (Coupled& body : bodies_) {
    archive(body.entry.boundary.name().c_str(), body.window);
    archive("contact_mass", body.contact_mass);
    archive("mass_age", body.mass_age);
  }
  archive("partner", partner_);
  archive("watch", *watch_);
  archive("choice", *choice_);
  archive("sample", sample_);
  archive("dem_seconds", times_.dem);
  archive("waited_seconds", times_.waited);
  archive("exchange_seconds", times_.exchange);
  archive("overlapped_seconds", times_.overlapped);
}

int CoupledRun::wanted_substeps() const {
  if (!chooses_windows()) return agreement_.substeps;
  return restarts_ ? 1 : choice_->substeps();
}

double CoupledRun::exchange(const State& state, const Kinematics& kinematics, double stop, double last,
                            const std::function<CheckpointRequest(double t_end)>& checkpoint_at,
                            const std::function<void()>& meanwhile, Inputs& inputs) {
  const double dt = agreement_.dt;
  const double left = std::round((last - state.time) / dt);  // DEM steps, possibly more than an integer holds
  motion_.time = state.time;
  const int most = scheme_->substeps(wanted_substeps(), motion_.window), before = motion_.n;
  restarts_ = false;
  const double until = std::min(left, std::ceil((stop - state.time) / dt - kSameTime));
  motion_.n = until < most ? std::max(1, static_cast<int>(until)) : most;
  motion_.last_window = left <= motion_.n;
  // In the last window the boundary comes to the prediction: work that is pending then will never be done. Not so in a much shorter
  // one, where it would catch up so fast that the damping of contacts gives a spike.
  motion_.closing = motion_.last_window && 2 * motion_.n >= before ? motion_.n : std::max(motion_.n, before);
  const double t_end = motion_.last_window ? last : state.time + motion_.n * dt;
  const CheckpointRequest request = checkpoint_at(t_end);
  motion_.checkpoint = request.folder;
  motion_.undisturbed = request.undisturbed;
  work_before_ = state.load_work;
  motion_.paths = known_motion_->paths(state, motion_.n, dt);
  const KnownPath unknown;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    fill_motion(kinematics.of(bodies_[k].entry.body), motion_.bodies[k]);
    bodies_[k].window.begin(motion_.n, dt, motion_.bodies[k], motion_.closing,
                            motion_.paths.empty() ? unknown : motion_.paths[k]);
  }
  if (partner_.requires_masses()) {
    motion_.inverse_masses.clear();
    for (const Coupled& body : bodies_) motion_.inverse_masses.push_back(1.0 / body.contact_mass.last());
  }
  const double worked = wall_clock() - exchanged_;
  const Load& load = partner_.exchange(motion_, [&] {
    meanwhile();
    prepare_masses(state);
  });
  exchanged_ = wall_clock();
  if (script_has_ended()) return state.time;
  for (const std::string& warning : load.warnings) watch_->warn(warning);
  times_.dem += load.wall_seconds;
  times_.waited += load.waited_seconds;
  times_.exchange += std::max(0.0, load.waited_seconds - worked);
  times_.overlapped += std::max(0.0, worked - load.waited_seconds);
  receive(load, inputs);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const std::size_t body = bodies_[k].entry.body;
    Coupled& coupled = bodies_[k];
    const bool touched = !inputs.loads[body].F_W.isZero(0.0);
    if (!touched || coupled.mass_age >= kMassInterval) coupled.mass_age = 0;
    const bool anew = coupled.mass_age == 0 || !coupled.contact_mass.solves_equations();
    watched_[k].mass =
        anew ? coupled.contact_mass.along(inputs.loads[body], state, motion_.n * dt) : coupled.contact_mass.last();
    if (touched) ++coupled.mass_age;
  }
  return t_end;
}

// Contact masses that are due need the factors at the window's start.
void CoupledRun::prepare_masses(const State& state) {
  for (const Coupled& body : bodies_)
    if (body.mass_age >= kMassInterval && body.contact_mass.solves_equations())
      return equations_.saddle().factor_at(state);
}

void CoupledRun::settle_work(State& state) const {
  for (const Coupled& body : bodies_) {
    if (!body.window.is_known()) continue;
    const int i = body.entry.body;
    const double missing = body.window.work() - (state.load_work(i) - work_before_(i));
    state.load_work(i) += missing;
    state.supplied[Supply::kMotion] -= missing;
  }
}

void CoupledRun::end_window(const State& state, const Kinematics& kinematics) {
  for (Coupled& body : bodies_) fill_motion(kinematics.of(body.entry.body), body.end);
  choose_window();
  observe(state);
  sample_.substeps = motion_.n;
  sample_.estimate = choice_->estimate();
  sample_.energy_residual = watch_->energy_residual();
  sample_.omega_h = watch_->omega_h();
  sample_.changes = partner_.load().changes;
  ++motion_.window;
}

// end_window has counted the window already.
bool CoupledRun::wait_for_checkpoint() { return partner_.wait_for_checkpoint(motion_.window - 1); }

// The force error of this window, and n of the next one.
void CoupledRun::choose_window() {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Coupled& body = bodies_[k];
    const BodyLoad& load = partner_.load().bodies[k];
    // Without carried gaps, which belong to earlier windows.
    const Vector6d gap = body.window.path().gap(body.end) + body.window.path().left_open;
    WindowChoice::Body& measured = choice_bodies_[k];
    if (chooses_windows()) {
      // Before its first contact only the grains below it count.
      const LandingSite* site = watch_->largest_omega_h(k) == 0.0 ? body.site : nullptr;
      measured.flight =
          flight_time(body.end, body.entry.boundary, mechanism_.placement, up_, site, known_motion_->is_known(k));
    }
    measured.mass = watched_[k].mass;
    measured.stiffness = load.contact_stiffness;
    measured.force = load.mean.F_W;
    measured.place = body.window.path().r_mean;
    measured.gap = gap.head<3>().norm() + gap.tail<3>().norm() * body.reach;
    measured.grain_omega2 = load.grain_omega2;
  }
  choice_->observe(motion_.n, choice_bodies_);
  for (std::size_t k = 0; k < bodies_.size(); ++k) watched_[k].force_error = choice_->force_error(k);
}

void CoupledRun::receive(const Load& load, Inputs& inputs) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Coupled& body = bodies_[k];
    if (const std::string place = first_not_finite(load.bodies[k]); !place.empty())
      throw NumericalError(code::kGrainLoadNotFinite,
                           "t = " + plain_text(motion_.time) + " s: the load of the grains on body " + watch_->name(k) +
                               " is not finite (" + place +
                               "): the bed has become unstable; use a smaller time step of the grains");
    body.window.apply(load.bodies[k], inputs.loads[body.entry.body]);
  }
}

void CoupledRun::observe(const State& state) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Coupled& body = bodies_[k];
    watched_[k].work_received = state.load_work(body.entry.body) - work_before_(body.entry.body);
    watched_[k].pending = body.window.pending_work(body.end);
    watched_[k].pending_modes = body.window.pending_modal_work(body.end);
    watched_[k].gravity = body.body.mass() * gravity_.dot(body.end.r - motion_.bodies[k].r);
    watched_[k].kinetic = 0.5 * body.body.mass() * body.end.dr.squaredNorm();
    watched_[k].speed = body.end.dr.norm();
    if (const std::optional<Eigen::Vector3d> surplus = body.window.surplus_impulse(body.end))
      watch_->add_surplus_impulse(k, state.time, *surplus,
                                  body.window.length() * partner_.load().bodies[k].mean.F_W.norm());
  }
  watch_->observe({state.time, state.time - motion_.time, motion_.n, motion_.last_window}, partner_.load(), watched_);
}

}  // namespace footfall
