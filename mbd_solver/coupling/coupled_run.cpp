#include "mbd_solver/coupling/coupled_run.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "coupler/base/errors.h"
#include "mbd_solver/coupling/fast_modes.h"
#include "mbd_solver/coupling/fill_motion.h"
#include "mbd_solver/coupling/flight_time.h"
#include "mbd_solver/coupling/tangent.h"
#include "mbd_solver/model/up_direction.h"

namespace footfall {
namespace {

std::string scheme_name(SchemeKind kind) {
  switch (kind) {
    case SchemeKind::kFrozen: return "frozen";
    case SchemeKind::kCss: return "css";
    case SchemeKind::kQuadratic: return "quadratic";
    case SchemeKind::kTangent: return "tangent";
    case SchemeKind::kCssTrapezoid: break;
  }
  return std::string(kDefaultScheme);
}

// A number that the scene states for the script, 0 when it does not.
double stated(const Scene& scene, const std::string& name) {
  const auto found = scene.particles->variables.find(name);
  if (found == scene.particles->variables.end()) return 0.0;
  char* end = nullptr;
  const double value = std::strtod(found->second.c_str(), &end);
  return *end == '\0' ? value : 0.0;
}

DemTerms terms_of(const Scene& scene, double t_end) {
  DemTerms terms;
  terms.scheme = scheme_name(scene.coupling.scheme);
  terms.t_end = t_end;
  terms.n_max = scene.coupling.max_substeps;
  terms.max_dt = scene.particles->max_time_step;
  terms.expected_dt = stated(scene, "dt");
  terms.expected_n = static_cast<int>(stated(scene, "every"));
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

CoupledRun::CoupledRun(const Scene& scene, const Mechanism& mechanism, const Kinematics& start, double t_end,
                       Transport& transport)
    : mechanism_(mechanism),
      t_end_(t_end),
      up_(up_direction(scene.gravity)),
      scheme_(make_scheme(scheme_name(scene.coupling.scheme))),
      partner_(transport, bodies_with_boundary(mechanism, start), terms_of(scene, t_end), scene.coupling.timeout),
      agreement_{partner_.dt(), partner_.substeps(), partner_.coupled(), scheme_.get()} {
  std::vector<std::string> names;
  std::vector<double> masses;
  double weight = std::numeric_limits<double>::infinity();  // of the lightest body [N]
  for (const int i : agreement_.boundaries) {
    const auto boundary = static_cast<std::size_t>(i);
    const BodyBoundary& entry = mechanism.boundaries[boundary];
    const Body& body = mechanism.model.body(entry.body);
    BodyMotion motion(entry.boundary.mode_count());
    fill_motion(start.of(entry.body), motion);
    const bool known = !mechanism.placement.sites.empty();
    bodies_.push_back({entry, body, known ? &mechanism.placement.sites[boundary] : nullptr,
                       PredictedWindow(*scheme_, motion), motion, motion, MeanLoad(motion.mode_count()),
                       entry.boundary.rho0().colwise().norm().maxCoeff()});
    motion_.bodies.push_back(motion);
    names.push_back(entry.boundary.name());
    masses.push_back(body.mass());
    weight = std::min(weight, body.mass() * scene.gravity.norm());
  }
  work_received_.resize(bodies_.size());
  watch_ = std::make_unique<CouplingWatch>(std::move(names), masses, scene.coupling);
  sample_.omega_h = watch_->omega_h();
  if (agreement_.substeps > 0) return;
  choice_ = std::make_unique<WindowChoice>(scene.coupling, agreement_.dt, weight);
  choice_bodies_.resize(bodies_.size());
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    choice_bodies_[k].mass = masses[k];
    choice_bodies_[k].flight =
        flight_time(bodies_[k].start, bodies_[k].entry.boundary, mechanism.placement, up_, bodies_[k].site);
  }
  choice_->start(choice_bodies_);
}

double CoupledRun::begin_window(const State& state, const Kinematics& kinematics, const StoredEnergy& stored,
                                Inputs& inputs) {
  const double dt = agreement_.dt;
  const int left = static_cast<int>(std::lround((t_end_ - state.time) / dt));
  motion_.time = state.time;
  motion_.n = std::max(1, std::min(wanted_substeps(), left));
  motion_.last_window = left <= motion_.n;
  const double H = motion_.n * dt;

  // The energy at the start; of a mechanism that starts at rest the largest kinetic energy so far.
  if (motion_.window == 0) reference_energy_ = stored.total() - stored.gravity;
  reference_energy_ = std::max(reference_energy_, stored.kinetic);
  work_before_ = state.load_work;

  for (Coupled& body : bodies_) fill_motion(kinematics.of(body.entry.body), body.start);
  choose_paths(H);
  const Load& load = partner_.exchange(motion_);
  dem_seconds_ += load.wall_seconds;
  receive(load, H, inputs);
  return motion_.last_window ? t_end_ : state.time + H;
}

void CoupledRun::end_window(const State& state, const Kinematics& kinematics, const Inputs& inputs) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const int body = bodies_[k].entry.body;
    fill_motion(kinematics.of(body), bodies_[k].end);
    work_received_[k] = state.load_work(body) - work_before_(body);
  }
  const double pending = pending_interface_work(state.time, motion_.n * agreement_.dt, inputs);
  watch_->window(state.time, state.time - motion_.time, motion_.n, partner_.load(), work_received_, reference_energy_,
                 pending);
  if (choice_) choose_window();
  sample_.substeps = motion_.n;
  sample_.estimate = choice_ ? choice_->estimate() : 0.0;
  sample_.energy_residual = watch_->energy_residual();
  sample_.omega_h = watch_->omega_h();
  waited_ = partner_.seconds_waited();
  last_substeps_ = motion_.n;
  ++motion_.window;
}

// n of the next window, and up to which omega H it needs no warning.
void CoupledRun::choose_window() {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Coupled& body = bodies_[k];
    const BodyLoad& load = partner_.load().bodies[k];
    // Before its first contact it flies to the grains below it.
    const LandingSite* site = watch_->largest_omega_h()[k] == 0.0 ? body.site : nullptr;
    const Vector6d gap = body.predicted.gap(body.end);
    WindowChoice::Body& seen = choice_bodies_[k];
    seen.flight = flight_time(body.end, body.entry.boundary, mechanism_.placement, up_, site);
    seen.stiffness = load.contact_stiffness;
    seen.force = load.mean.F_W;
    seen.place = body.predicted.r_mean();
    seen.gap = gap.head<3>().norm() + gap.tail<3>().norm() * body.reach;
  }
  choice_->observe(motion_.n, choice_bodies_);
  for (std::size_t k = 0; k < bodies_.size(); ++k) watch_->allow(k, choice_->allowed_omega_h(k));
}

// ---- what depends on the scheme ----

int CoupledRun::wanted_substeps() const {
  if (scheme_->wants_tangent() && motion_.window == 0) return 1;  // to learn the slopes of contacts that stand already
  return choice_ ? choice_->substeps() : agreement_.substeps;
}

// What the scheme makes of the states at the window's start: the path that each boundary takes in the grains.
void CoupledRun::choose_paths(double H) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Coupled& body = bodies_[k];
    BodyMotion& motion = motion_.bodies[k];
    motion = body.start;
    if (scheme_->wants_tangent()) {  // the velocity that the window is expected to have in the mean
      const std::vector<BodyLoad>& loads = partner_.load().bodies;
      const ContactTangent slope =
          loads.empty() || loads[k].tangent.empty() ? ContactTangent{} : loads[k].tangent.front();
      const Vector6d v = mean_velocity(body.body, motion, slope, H);
      motion.dr = v.head<3>();
      motion.w = v.tail<3>();
      if (motion.mode_count() > 0) motion.da += 0.5 * H * motion.dda;
    }
    if (body.body.mode_count() > 0) slow_down_fast_modes(body.start, body.body.modal()->stiffness, H, motion);
    body.predicted.begin(motion, motion_.n, agreement_.dt);
  }
}

void CoupledRun::receive(const Load& load, double H, Inputs& inputs) const {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Coupled& body = bodies_[k];
    const MeanLoad& mean = load.bodies[k].mean;
    if (!mean.F_W.allFinite() || !mean.T_B.allFinite() || !mean.Q_a.allFinite())
      throw NumericalError("t = " + std::to_string(motion_.time) + " s: the load of the grains on body " +
                           watch_->names()[k] +
                           " is not finite: the bed has blown up; use a smaller timestep in the script");
    ExternalLoad& external = inputs.loads[static_cast<std::size_t>(body.entry.body)];
    external.F_W = mean.F_W;
    external.T_B = mean.T_B;
    if (mean.Q_a.size() > 0) external.Q_a = mean.Q_a;
    if (load.bodies[k].tangent.empty()) continue;
    const double omega_h = std::sqrt(std::max(0.0, load.bodies[k].contact_stiffness) / body.body.mass()) * H;
    external.tangent = tangent_load(load.bodies[k].tangent.front(), body.predicted, omega_h, H);
  }
}

double CoupledRun::pending_interface_work(double time, double H, const Inputs& inputs) {
  const double ratio = last_substeps_ > 0 ? static_cast<double>(motion_.n) / last_substeps_ : 0.0;
  double work = 0.0;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Coupled& body = bodies_[k];
    const BodyLoad& load = partner_.load().bodies[k];
    if (load.tangent.empty()) {
      work += pending_work(load.mean, body.last_load, ratio, body.predicted, body.end);
    } else {
      work += pending_work(load.mean, load.tangent.front(), body.predicted, body.end);
      const TangentLoad& reacted = *inputs.loads[static_cast<std::size_t>(body.entry.body)].tangent;
      watch_->count_surplus(k, time, surplus_impulse(reacted, body.start, body.end, H), H * load.mean.F_W.norm());
    }
    body.last_load = load.mean;
  }
  return work;
}

}  // namespace footfall
