#include "mbd_solver/run/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/scheme.h"
#include "mbd_solver/coupling/fast_modes.h"
#include "mbd_solver/coupling/tangent.h"
#include "mbd_solver/model/elements/rigid_plane.h"

namespace footfall {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Eigen::Vector3d up_direction(const Eigen::Vector3d& gravity) {
  return gravity.norm() > 0.0 ? Eigen::Vector3d(-gravity.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

Baumgarte baumgarte(const SolverSpec& spec) {
  if (spec.drift == DriftKind::kProjection) return {};
  return {spec.baumgarte_velocity, spec.baumgarte_position};
}

// With grains the windows are short and their own error is of second order; without, the fifth order has the longer steps.
int order_of(OneStepMethod method, bool with_grains) {
  switch (method) {
    case OneStepMethod::kAuto: return with_grains ? 2 : 5;
    case OneStepMethod::kTrBdf2: return 2;
    case OneStepMethod::kEsdirk5: return 5;
  }
  FOOTFALL_DEMAND(false);
  return 0;
}

IntegratorOptions integrator_options(const SolverSpec& spec, bool with_grains) {
  IntegratorOptions options;
  options.order = order_of(spec.method, with_grains);
  options.rtol = spec.rtol;
  options.atol = spec.atol;
  options.atol_velocity = 100.0 * spec.atol;
  options.max_step = spec.max_step;
  options.error_control = spec.error_control;
  options.projection = spec.drift == DriftKind::kProjection;
  return options;
}

std::string scheme_name(SchemeKind kind) {
  switch (kind) {
    case SchemeKind::kFrozen: return "frozen";
    case SchemeKind::kCss: return "css";
    case SchemeKind::kQuadratic: return "quadratic";
    case SchemeKind::kTangent: return "tangent";
    default: return std::string(kDefaultScheme);
  }
}

// A number that the scene states for the script, 0 when it does not.
double stated(const Scene& scene, const std::string& name) {
  const auto found = scene.particles->variables.find(name);
  if (found == scene.particles->variables.end()) return 0.0;
  char* end = nullptr;
  const double value = std::strtod(found->second.c_str(), &end);
  return *end == '\0' ? value : 0.0;
}

}  // namespace

Simulation::Simulation(const Scene& scene, double t_end, Transport* partner_transport)
    : scene_(scene),
      t_end_(t_end),
      mechanism_(build_mechanism(scene)),
      assembly_(assemble(mechanism_.model)),
      equations_(std::make_unique<Equations>(mechanism_.model, assembly_, baumgarte(scene.solver))),
      integrator_(make_integrator(scene.solver.integrator == IntegratorKind::kIda ? "ida" : "one_step", *equations_,
                                  integrator_options(scene.solver, partner_transport != nullptr))),
      control_(mechanism_.controllers, mechanism_.struts, up_direction(scene.gravity)),
      state_(assembly_.state),
      rates_(Eigen::VectorXd::Zero(equations_->layout().size())),
      y_(Eigen::VectorXd::Zero(equations_->layout().size())) {
  const auto bodies = static_cast<std::size_t>(mechanism_.model.body_count());
  for (std::size_t i = 0; i < bodies; ++i)
    contact_.emplace_back(mechanism_.model.body(static_cast<int>(i)).mode_count());
  inputs_.voltages = mechanism_.voltages;
  if (!partner_transport) return;

  inputs_.loads.resize(bodies);
  std::vector<CoupledBody> coupled;
  for (const BodyBoundary& entry : mechanism_.boundaries) {
    BodyMotion motion(entry.boundary.mode_count());
    fill_motion(entry.body, motion);
    coupled.push_back({entry.boundary, motion});
  }
  DemTerms terms;
  terms.scheme = scheme_name(scene.coupling.scheme);
  terms.t_end = t_end_;
  terms.n_max = scene.coupling.max_substeps;
  terms.max_dt = scene.particles->max_time_step;
  terms.expected_dt = stated(scene, "dt");
  terms.expected_n = static_cast<int>(stated(scene, "every"));
  partner_ = std::make_unique<DemPartner>(*partner_transport, std::move(coupled), terms, scene.coupling.timeout);
  std::vector<std::string> names;
  std::vector<double> masses;
  for (const int i : partner_->coupled()) {
    const BodyBoundary& entry = mechanism_.boundaries[static_cast<std::size_t>(i)];
    names.push_back(entry.boundary.name());
    masses.push_back(mechanism_.model.body(entry.body).mass());
    motion_.bodies.emplace_back(entry.boundary.mode_count());
  }
  watch_ = std::make_unique<CouplingWatch>(std::move(names), std::move(masses), scene.coupling);
  prepare_windows();
}

void Simulation::prepare_windows() {
  scheme_ = make_scheme(scheme_name(scene_.coupling.scheme));
  const bool chosen = partner_->substeps() == 0;
  for (std::size_t k = 0; k < motion_.bodies.size(); ++k) {
    const int body = mechanism_.boundaries[static_cast<std::size_t>(partner_->coupled()[k])].body;
    fill_motion(body, motion_.bodies[k]);
    predicted_.emplace_back(*scheme_, motion_.bodies[k]);
    last_loads_.emplace_back(motion_.bodies[k].mode_count());
    windows_of_bodies_.emplace_back();
    windows_of_bodies_.back().mass = mechanism_.model.body(body).mass();
  }
  if (!chosen) return;
  double weight = std::numeric_limits<double>::infinity();
  for (const WindowChoice::Body& body : windows_of_bodies_)
    weight = std::min(weight, body.mass * scene_.gravity.norm());
  choice_ = std::make_unique<WindowChoice>(scene_.coupling, partner_->dt(), weight);
  choose_window(true);
}

// Falling at its present speed. 0 when it may touch a grain now, or when nobody said how high the grains stand.
double Simulation::time_of_flight(std::size_t k, const BodyMotion& motion) const {
  const auto boundary = static_cast<std::size_t>(partner_->coupled()[k]);
  const BodyBoundary& entry = mechanism_.boundaries[boundary];
  if (!mechanism_.placement.ground_known) return 0.0;
  const Eigen::Vector3d up = up_direction(scene_.gravity);
  const Eigen::Matrix3Xd& rho0 = entry.boundary.rho0();
  const double lowest = up.dot(motion.r) + (up.transpose() * motion.rotation() * rho0).minCoeff();
  const double reach = rho0.colwise().norm().maxCoeff();
  const double speed = motion.w.norm() * reach - up.dot(motion.dr);
  double radius = 0.0;  // of beams
  for (const BeamSegment& segment : entry.boundary.segments()) radius = std::max(radius, segment.radius);
  double ground = mechanism_.placement.ground_height;
  if (!mechanism_.placement.sites.empty() && watch_->largest_omega_h()[k] == 0.0) {
    // Before its first contact it flies to the grains below it, as long as it stays above them.
    const LandingSite& site = mechanism_.placement.sites[boundary];
    const Eigen::Vector3d way = motion.r - site.r;
    const double turned = Eigen::AngleAxisd(site.R_WB.transpose() * motion.rotation()).angle();
    if ((way - up * up.dot(way)).norm() + turned * reach < site.stray && std::isfinite(site.height))
      ground = site.height;
  }
  const double height = lowest - radius - ground;
  if (height <= 0.0) return 0.0;
  return speed > 0.0 ? height / speed : std::numeric_limits<double>::infinity();
}

void Simulation::choose_window(bool first) {
  for (std::size_t k = 0; k < motion_.bodies.size(); ++k) {
    const BodyBoundary& entry = mechanism_.boundaries[static_cast<std::size_t>(partner_->coupled()[k])];
    BodyMotion& motion = motion_.bodies[k];
    fill_motion(entry.body, motion);
    WindowChoice::Body& body = windows_of_bodies_[k];
    body.flight = time_of_flight(k, motion);
    if (first) continue;
    const BodyLoad& load = partner_->load().bodies[k];
    body.stiffness = load.contact_stiffness;
    body.force = load.mean.F_W;
    body.place = predicted_[k].r_mean();
    const Vector6d gap = predicted_[k].gap(motion);
    body.gap = gap.head<3>().norm() + gap.tail<3>().norm() * entry.boundary.rho0().colwise().norm().maxCoeff();
  }
  if (first) {
    choice_->start(windows_of_bodies_);
  } else {
    choice_->observe(motion_.n, windows_of_bodies_);
  }
}

bool Simulation::finished() const { return state_.time >= t_end_ * (1.0 - 1e-12); }

double Simulation::next_stop() const {
  const double t = state_.time;
  const double tiny = 1e-9 * std::max(scene_.output.interval, 1e-6);
  const double next_row = (std::floor((t + tiny) / scene_.output.interval) + 1.0) * scene_.output.interval;
  return std::min({next_row, control_.next_sample(), t_end_});
}

void Simulation::fill_motion(int body, BodyMotion& motion) const {
  const Layout& layout = equations_->layout();
  const auto i = static_cast<std::size_t>(body);
  const Eigen::Index q = layout.body_q[i], v = layout.body_v[i], s = motion.mode_count();
  motion.r = state_.q.segment<3>(q);
  motion.L = state_.q.segment<4>(q + 3);
  motion.dr = state_.v.segment<3>(v);
  motion.w = state_.v.segment<3>(v + 3);
  const Eigen::Index dv = layout.v0() + v;
  motion.ddr = rates_.segment<3>(dv);
  motion.dw = rates_.segment<3>(dv + 3);
  if (s == 0) return;
  motion.a = state_.q.segment(q + 7, s);
  motion.da = state_.v.segment(v + 6, s);
  motion.dda = rates_.segment(dv + 6, s);
}

double Simulation::pending_interface_work() {
  double work = 0.0;
  const double ratio = last_substeps_ > 0 ? static_cast<double>(motion_.n) / last_substeps_ : 0.0;
  last_substeps_ = motion_.n;
  for (std::size_t k = 0; k < motion_.bodies.size(); ++k) {
    fill_motion(mechanism_.boundaries[static_cast<std::size_t>(partner_->coupled()[k])].body, motion_.bodies[k]);
    const BodyLoad& load = partner_->load().bodies[k];
    work += load.tangent.empty() ? pending_work(load.mean, last_loads_[k], ratio, predicted_[k], motion_.bodies[k])
                                 : pending_work(load.mean, load.tangent.front(), predicted_[k], motion_.bodies[k]);
    last_loads_[k] = load.mean;
    if (load.tangent.empty()) continue;
    const int body = mechanism_.boundaries[static_cast<std::size_t>(partner_->coupled()[k])].body;
    const double H = motion_.n * partner_->dt();
    watch_->count_surplus(
        k, state_.time,
        surplus_impulse(*inputs_.loads[static_cast<std::size_t>(body)].tangent, starts_[k], motion_.bodies[k], H),
        H * load.mean.F_W.norm());
  }
  return work;
}

// The path of scheme `tangent` runs at the velocity that the window is expected to have in the mean.
void Simulation::soften_paths(double H) {
  for (std::size_t k = 0; k < motion_.bodies.size(); ++k) {
    const std::vector<BodyLoad>& loads = partner_->load().bodies;
    const ContactTangent slope =
        loads.empty() || loads[k].tangent.empty() ? ContactTangent{} : loads[k].tangent.front();
    BodyMotion& motion = motion_.bodies[k];
    const int body = mechanism_.boundaries[static_cast<std::size_t>(partner_->coupled()[k])].body;
    const Vector6d v = mean_velocity(mechanism_.model.body(body), motion, slope, H);
    motion.dr = v.head<3>();
    motion.w = v.tail<3>();
    if (motion.mode_count() > 0) motion.da += 0.5 * H * motion.dda;
  }
}

double Simulation::exchange_window() {
  const double dt = partner_->dt();
  const int left = static_cast<int>(std::lround((t_end_ - state_.time) / dt));
  motion_.window = window_;
  motion_.time = state_.time;
  int n = choice_ ? choice_->substeps() : partner_->substeps();
  if (choice_)
    for (std::size_t k = 0; k < motion_.bodies.size(); ++k) watch_->allow(k, choice_->allowed_omega_h(k));
  if (scheme_->wants_tangent() && window_ == 0) n = 1;  // to learn the slopes of contacts that stand already
  motion_.n = std::max(1, std::min(n, left));
  motion_.last_window = left <= motion_.n;
  for (std::size_t k = 0; k < motion_.bodies.size(); ++k)
    fill_motion(mechanism_.boundaries[static_cast<std::size_t>(partner_->coupled()[k])].body, motion_.bodies[k]);
  starts_ = motion_.bodies;
  if (scheme_->wants_tangent()) soften_paths(motion_.n * dt);
  for (std::size_t k = 0; k < motion_.bodies.size(); ++k) {
    const Body& body =
        mechanism_.model.body(mechanism_.boundaries[static_cast<std::size_t>(partner_->coupled()[k])].body);
    if (body.mode_count() > 0)
      slow_down_fast_modes(starts_[k], body.modal()->stiffness, motion_.n * dt, motion_.bodies[k]);
  }
  for (std::size_t k = 0; k < predicted_.size(); ++k) predicted_[k].begin(motion_.bodies[k], motion_.n, dt);
  const Load& load = partner_->exchange(motion_);
  times_.dem += load.wall_seconds;
  particles_ = static_cast<long>(load.particles);
  for (std::size_t k = 0; k < motion_.bodies.size(); ++k) {
    const int body = mechanism_.boundaries[static_cast<std::size_t>(partner_->coupled()[k])].body;
    ExternalLoad& external = inputs_.loads[static_cast<std::size_t>(body)];
    const MeanLoad& mean = load.bodies[k].mean;
    if (!mean.F_W.allFinite() || !mean.T_B.allFinite() || !mean.Q_a.allFinite())
      throw NumericalError("t = " + std::to_string(state_.time) + " s: the load of the grains on body " +
                           watch_->names()[k] +
                           " is not finite: the bed has blown up; use a smaller timestep in the script");
    external.F_W = mean.F_W;
    external.T_B = mean.T_B;
    if (mean.Q_a.size() > 0) external.Q_a = mean.Q_a;
    if (load.bodies[k].tangent.empty()) continue;
    const double H = motion_.n * dt;
    const double omega_h =
        std::sqrt(std::max(0.0, load.bodies[k].contact_stiffness) / mechanism_.model.body(body).mass()) * H;
    external.tangent = tangent_load(load.bodies[k].tangent.front(), predicted_[k], omega_h, H);
  }
  return motion_.last_window ? t_end_ : state_.time + motion_.n * dt;
}

void Simulation::update_contact() {
  equations_->load(state_);
  for (std::size_t i = 0; i < inputs_.loads.size(); ++i) {
    contact_[i].F_W = inputs_.loads[i].F_W;
    contact_[i].T_W = equations_->motion(static_cast<int>(i)).A * inputs_.loads[i].T_B;
  }
  for (std::size_t k = 0; k < mechanism_.planes.size(); ++k) {
    const auto& plane = static_cast<const RigidPlane&>(mechanism_.model.force(mechanism_.planes[k]));
    const Vector6d wrench = plane.wrench(equations_->element_input(mechanism_.planes[k], state_, inputs_));
    GeneralizedForce& contact = contact_[static_cast<std::size_t>(mechanism_.plane_bodies[k])];
    contact.F_W = wrench.head<3>();
    contact.T_W = wrench.tail<3>();
  }
}

void Simulation::check_finite() const {
  if (state_.q.allFinite() && state_.v.allFinite() && state_.z.allFinite()) return;
  throw NumericalError("t = " + std::to_string(state_.time) + " s: the state of the mechanism is not finite");
}

void Simulation::run(const std::function<void(const Sample&)>& observe, const volatile std::sig_atomic_t& interrupted) {
  const double started = now();
  bool reported = false;  // the present state
  const auto report = [&] {
    reported = true;
    update_contact();
    equations_->pack(state_, rates_.tail(equations_->layout().row_count), y_);
    equations_->energy(state_.time, y_, inputs_, energy_);
    times_.total = now() - started;
    if (partner_) times_.waiting = partner_->seconds_waited();
    observe({state_, energy_, rates_, contact_, inputs_, watch_.get(), window_, motion_.n,
             choice_ ? choice_->estimate() : 0.0});
  };
  equations_->accelerations(state_, inputs_, rates_);
  report();
  const double start_energy = energy_.stored.total() - energy_.stored.gravity;
  double reference_energy = start_energy;  // of a mechanism that starts at rest: the largest kinetic energy so far

  std::vector<double> work_received(motion_.bodies.size());
  // Without grains a window ends only where a voltage changes: rows and samples are read on the way. While each sample
  // changes it, windows end at samples, so that no step is cut.
  bool voltages_move = true;
  double on_the_way = 0.0;  // wall time of rows [s]
  Rows rows;
  if (!partner_) {
    rows.next = [&](double) { return next_stop(); };
    rows.on_row = [&](const State& state, const Eigen::VectorXd& rates) {
      const double row_started = now();
      state_ = state;
      rates_ = rates;
      check_finite();
      ++window_;
      report();
      const Eigen::VectorXd voltages = inputs_.voltages;
      if (!control_.empty()) control_.sample_due(state_, *equations_, rates_, inputs_);
      on_the_way += now() - row_started;
      voltages_move = inputs_.voltages != voltages;
      return interrupted == 0 && !voltages_move;
    };
  }
  while (!finished() && interrupted == 0) {
    reported = false;
    const double control_started = now();
    if (!control_.empty()) {
      const double due = control_.next_sample();
      const Eigen::VectorXd voltages = inputs_.voltages;
      control_.sample_due(state_, *equations_, rates_, inputs_);
      if (control_.next_sample() > due) voltages_move = inputs_.voltages != voltages;
    }
    times_.control += now() - control_started;

    const double t0 = state_.time;
    const Eigen::VectorXd work_before = state_.load_work;
    const double t1 = partner_ ? exchange_window() : voltages_move ? std::min(control_.next_sample(), t_end_) : t_end_;
    const double mbd_started = now();
    on_the_way = 0.0;
    State state = state_;
    integrator_->advance(state, t1, inputs_, rows);
    times_.mbd += now() - mbd_started - on_the_way;
    state_ = state;
    rates_ = integrator_->end_rates();
    check_finite();
    if (reported && state_.time < t1) continue;  // at a row that ended the window
    ++window_;
    if (partner_) {
      for (std::size_t k = 0; k < work_received.size(); ++k) {
        const int body = mechanism_.boundaries[static_cast<std::size_t>(partner_->coupled()[k])].body;
        work_received[k] = state_.load_work(body) - work_before(body);
      }
      reference_energy = std::max(reference_energy, energy_.stored.kinetic);
      watch_->window(state_.time, t1 - t0, motion_.n, partner_->load(), work_received, reference_energy,
                     pending_interface_work());
      if (choice_) choose_window(false);
    }
    report();
  }
  if (partner_ && finished()) partner_->close();
}

}  // namespace footfall
