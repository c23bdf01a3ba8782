// Kinetic damping: integrate with tight tolerances, find the maximum of the kinetic energy with a parabola through three
// samples, stop there, repeat. Functions of time are frozen at their initial values.

#include "mbd_solver/run/settle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/build/time_functions.h"
#include "mbd_solver/run/codes.h"

namespace footfall {
namespace {

constexpr double kAtRest = 1e-7;                                      // of the initial accelerations, or of gravity
constexpr double kRoundOff = 1e-11;                                   // of the joint forces, over the smallest mass
constexpr double kFirst = 1e-3;                                       // [s]: first sample of the kinetic energy
constexpr double kLongest = 1000.0;                                   // [s] of motion
constexpr double kRtol = 1e-8, kAtol = 1e-12, kAtolVelocity = 1e-10;  // small motions count
constexpr int kMaxStops = 2000;
// Of joints that stick: an overdamped coordinate has no maximum of kinetic energy at its equilibrium.
constexpr double kStickDamping = 0.02;
constexpr double kOvershoot = 2.0;  // of a load that such a coordinate takes up, over the load at rest
constexpr int kSamples = 12;        // until the maximum of the kinetic energy

void freeze(TimeFunctionSpec& f, TableShape shape) {
  const double now = time_function(f, shape)->at(0.0).value;
  const std::string signal = f.signal;
  f = TimeFunctionSpec{};
  f.polynomial = {now};
  f.signal = signal;
}
void freeze(std::optional<TimeFunctionSpec>& f, TableShape shape) {
  if (f) freeze(*f, shape);
}

// The scene with constant loads, those of the start, and without velocities.
Scene frozen(Scene scene) {
  scene.initial.velocity.setZero();
  scene.initial.angular_velocity.setZero();
  scene.initial.bodies.clear();
  for (ForceSpec& force : scene.forces) {
    freeze(force.force, TableShape::kLines);
    freeze(force.torque, TableShape::kLines);
  }
  for (DriveSpec& drive : scene.drives) {
    freeze(drive.command, command_shape(drive.motor.kind));
    drive.stick_damping = kStickDamping;
  }
  for (JointSpec& joint : scene.joints) {
    for (std::optional<CoordinateSpec>* c :
         {&joint.angle, &joint.displacement, &joint.displacement_x, &joint.displacement_y})
      if (*c && (*c)->friction) {
        JointFrictionParameters& friction = *(*c)->friction;
        friction.damping_ratio = kStickDamping;
        friction.breakaway = kOvershoot * friction.breakaway.value_or(friction.coulomb);
      }
    if (!joint.motion) continue;
    for (std::optional<TimeFunctionSpec>* f :
         {&joint.motion->x, &joint.motion->y, &joint.motion->z, &joint.motion->rotation})
      freeze(*f, TableShape::kSpline);
  }
  return scene;
}

class Relaxation {
 public:
  Relaxation(const Mechanism& mechanism, const Assembly& assembly, const IntegratorOptions& options)
      : equations_(mechanism.model, assembly), rates_(Eigen::VectorXd::Zero(equations_.layout().size())) {
    integrator_ = make_integrator("one_step", equations_, options);
    inputs_.values = mechanism.inputs;
    state_ = assembly.state;
    equations_.settle_signals(nullptr, inputs_, state_);
    stop();
  }
  const State& state() const { return state_; }
  double acceleration() const {
    return rates_.segment(equations_.layout().v0(), equations_.layout().v_size).lpNorm<Eigen::Infinity>();
  }

  // Accelerations that are round-off of the present joint forces.
  double round_off(const Model& model) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < model.body_count(); ++i) least = std::min(least, model.body(i).mass());
    return kRoundOff * rates_.tail(equations_.layout().row_count).lpNorm<Eigen::Infinity>() / least;
  }

  // Moves to the next maximum of the kinetic energy and stops there. Returns the duration [s].
  double to_next_stop(double budget) {
    // Samples of the kinetic energy: so many at equal intervals, then at twice these.
    State samples[3];
    double energy[3] = {0.0, 0.0, 0.0};
    int count = 0;
    const auto add = [&](const State& state) {
      std::rotate(samples, samples + 1, samples + 3);
      std::rotate(energy, energy + 1, energy + 3);
      samples[2] = state;
      energy[2] = kinetic(state);
      ++count;
    };
    double h = interval_;
    add(state_);
    while (samples[2].time < budget) {
      State next = samples[2];
      integrator_->advance(next, next.time + h, inputs_);
      add(next);
      if (energy[2] < energy[1]) {
        // Maximum of the parabola through three samples, between the first and the last.
        const double bend = energy[0] - 2.0 * energy[1] + energy[2];
        const bool three = count >= 3 && bend < 0.0;
        const double s = three ? std::clamp(0.5 * (energy[0] - energy[2]) / bend, -1.0, 1.0) : 0.0;
        const double taken = next.time, top = samples[1].time + h * s;
        state_ = s < 0.0 ? samples[0] : samples[1];
        if (top > state_.time) integrator_->advance(state_, top, inputs_);
        interval_ = std::max(state_.time, 0.1 * h) / kSamples;
        stop();
        return taken;
      }
      if (count <= 2 * kSamples) continue;
      h *= 2.0;
      count = 1;  // a parabola needs equal intervals
    }
    return budget;
  }

 private:
  double kinetic(const State& state) {
    Eigen::VectorXd y(equations_.layout().size());
    equations_.pack(state, Eigen::VectorXd::Zero(equations_.layout().row_count), y);
    equations_.energy(state.time, y, inputs_, energy_);
    return energy_.stored[Stored::kKinetic];
  }
  void stop() {
    state_.v.setZero();
    state_.time = 0.0;
    state_.step = 0.0;
    integrator_->forget();
    equations_.saddle().accelerations(state_, inputs_, rates_);
  }

  Equations equations_;
  std::unique_ptr<Integrator> integrator_;
  Inputs inputs_;
  State state_;
  Eigen::VectorXd rates_;
  EnergySample energy_;
  double interval_ = kFirst;
};

}  // namespace

Settled settle(const Scene& scene, const AssemblyOptions& options, const IntegratorOptions& integrator) {
  const Scene still = frozen(scene);
  const Mechanism mechanism = build_mechanism(still);
  const Assembly assembly = assemble(mechanism.model, options);
  IntegratorOptions tight = integrator;
  tight.rtol = std::min(tight.rtol, kRtol);
  tight.atol = std::min(tight.atol, kAtol);
  tight.atol_velocity = std::min(tight.atol_velocity, kAtolVelocity);
  tight.max_step = 0.0;
  Relaxation relaxation(mechanism, assembly, tight);
  const double enough = std::max(kAtRest * std::max(relaxation.acceleration(), scene.gravity.norm()),
                                 relaxation.round_off(mechanism.model));
  Settled out;
  int stops = 0;
  while (relaxation.acceleration() > enough) {
    out.time += relaxation.to_next_stop(kLongest - out.time);
    if (out.time >= kLongest || ++stops >= kMaxStops)
      throw InputError(code::kNotSettled, scene.file + ":" + std::to_string(scene.initial.source.line_of("settle")) +
                                              ": initial.settle: the mechanism does not come to rest: after " +
                                              number_text(out.time, 3) + " s of motion its largest acceleration is " +
                                              number_text(relaxation.acceleration(), 3) +
                                              " m/s2 or rad/s2. Support every body against gravity, or remove settle.");
  }
  out.state = relaxation.state();
  out.acceleration = relaxation.acceleration();
  const Layout layout(mechanism.model);
  for (int i = 0; i < mechanism.model.body_count(); ++i) {
    const int q = layout.body_q[static_cast<std::size_t>(i)];
    const double distance = (out.state.q.segment<3>(q) - assembly.state.q.segment<3>(q)).norm();
    if (distance < out.moved) continue;
    out.moved = distance;
    out.body = mechanism.model.body(i).name();
  }
  return out;
}

}  // namespace footfall
