// Kinetic damping: integrate with tight tolerances, find the maximum of the kinetic energy with a parabola through three
// samples, stop there, repeat. Functions of time are frozen at their initial values.

#include "mbd_solver/session/settle.h"

#include <algorithm>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/assemble/time_functions.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

constexpr double kAtRest = 1e-7;                                      // of the initial accelerations, or of gravity
constexpr double kRoundOff = 1e-11;                                   // of the joint forces, over the smallest mass
constexpr double kFirst = 1e-3;                                       // [s]: first sample of the kinetic energy
constexpr double kLongest = 1000.0;                                   // [s] of motion
constexpr double kRtol = 1e-8, kAtol = 1e-12, kAtolVelocity = 1e-10;  // small motions count
constexpr int kMaxStops = 2000;
constexpr double kMostTurns = 300.0;  // of a body, of which a motor turns one for ever
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

// Calls visit(name of the coordinate's forces, its friction) for all joints.
template <class Visit>
void for_each_friction(Scene& scene, const Visit& visit) {
  for (JointSpec& joint : scene.joints)
    for (const auto& [coordinate, kind] :
         {std::pair{&joint.angle, Coordinate::kAngle}, std::pair{&joint.displacement, Coordinate::kDisplacement},
          std::pair{&joint.displacement_x, Coordinate::kDisplacementX},
          std::pair{&joint.displacement_y, Coordinate::kDisplacementY}})
      if (*coordinate && (*coordinate)->friction)
        visit("joint/" + joint.name + "/" + std::string(name_of(kind)), *(*coordinate)->friction);
}

// The scene with the constant loads of the start, and without velocities. Friction at rest is as in the scene in
// coordinates whose load exceeds it; in others it bears what a load takes up that is there at once.
Scene frozen(Scene scene, const std::vector<std::string>& sliding) {
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
  for_each_friction(scene, [&](const std::string& name, JointFrictionParameters& friction) {
    friction.damping_ratio = kStickDamping;
    if (std::find(sliding.begin(), sliding.end(), name) == sliding.end())
      friction.breakaway = kOvershoot * friction.breakaway.value_or(friction.coulomb);
  });
  for (JointSpec& joint : scene.joints) {
    if (!joint.motion) continue;
    for (std::optional<TimeFunctionSpec>* f :
         {&joint.motion->x, &joint.motion->y, &joint.motion->z, &joint.motion->rotation})
      freeze(*f, TableShape::kSpline);
  }
  return scene;
}

class Relaxation {
 public:
  Relaxation(const Mechanism& mechanism, const Assembly& assembly, const State& from, const IntegratorOptions& options)
      : equations_(mechanism.model, assembly), rates_(Eigen::VectorXd::Zero(equations_.layout().size())) {
    integrator_ = make_integrator("one_step", equations_, options);
    inputs_.values = mechanism.inputs;
    state_ = assembly.state;
    state_.q = from.q;
    state_.z = from.z;
    state_.angles = from.angles;
    equations_.settle_signals(nullptr, inputs_, state_);
    equations_.switch_modes(inputs_, state_);
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

  // Of the body that turns fastest, all motions together [-]; its number.
  double turns() const { return turned_ / (2.0 * kPi); }
  int turning_body() const { return turning_body_; }

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
      turned_ += fastest_turn(next) * h;
      if (turns() > kMostTurns) {
        state_ = next;
        return next.time;
      }
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
    state_ = samples[2];
    return budget;
  }

 private:
  double fastest_turn(const State& state) {  // [rad/s]
    double fastest = 0.0;
    for (int i = 0; i < equations_.model().body_count(); ++i) {
      const double w = state.v.segment<3>(equations_.layout().body_v[i] + 3).norm();
      if (w <= fastest) continue;
      fastest = w;
      turning_body_ = i;
    }
    return fastest;
  }
  double kinetic(const State& state) {
    Eigen::VectorXd y(equations_.layout().size());
    equations_.layout().pack(state, Eigen::VectorXd::Zero(equations_.layout().row_count), y);
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
  double turned_ = 0.0;  // [rad]
  int turning_body_ = 0;
};

std::vector<std::string> frictions(Scene scene) {
  std::vector<std::string> names;
  for_each_friction(scene, [&](const std::string& name, const JointFrictionParameters&) { names.push_back(name); });
  return names;
}

// The names of forces whose friction does not bear its load: these change their mode.
std::vector<std::string> overloaded(Equations& equations, const Inputs& inputs, State state) {
  const Eigen::VectorXd before = state.z;
  equations.switch_modes(inputs, state);
  std::vector<std::string> names;
  for (int i = 0; i < equations.model().force_count(); ++i) {
    const int first = equations.layout().force_z[i];
    const int count = equations.model().force(i).state_count();
    if (state.z.segment(first, count) != before.segment(first, count))
      names.push_back(equations.model().force(i).name());
  }
  return names;
}

// The names of forces whose friction slips: its states are [z, s], its mode s is not 0.
std::vector<std::string> slipping(const Scene& scene, const Mechanism& mechanism, const State& state) {
  const std::vector<std::string> all = frictions(scene);
  const Layout layout(mechanism.model);
  std::vector<std::string> names;
  for (int i = 0; i < mechanism.model.force_count(); ++i) {
    const ForceElement& force = mechanism.model.force(i);
    if (std::find(all.begin(), all.end(), force.name()) != all.end() && state.z[layout.force_z[i] + 1] != 0.0)
      names.push_back(force.name());
  }
  return names;
}

// "joint/p/displacement" -> "joints.p.displacement"
std::string key_of(std::string name) {
  std::replace(name.begin(), name.end(), '/', '.');
  return "\"joints" + name.substr(std::string("joint").size()) + "\"";
}

// From `out` to rest.
void relax(const Scene& scene, const Mechanism& mechanism, const Assembly& assembly, const IntegratorOptions& tight,
           Settled& out) {
  Relaxation relaxation(mechanism, assembly, out.state, tight);
  const double enough = std::max(kAtRest * std::max(relaxation.acceleration(), scene.gravity.norm()),
                                 relaxation.round_off(mechanism.model));
  int stops = 0;
  while (relaxation.acceleration() > enough) {
    out.time += relaxation.to_next_stop(kLongest - out.time);
    const bool spins = relaxation.turns() > kMostTurns;
    if (out.time < kLongest && !spins && ++stops < kMaxStops) continue;
    std::vector<std::string> keys;
    for (const std::string& name : slipping(scene, mechanism, relaxation.state())) keys.push_back(key_of(name));
    throw InputError(
        code::kNotSettled,
        scene.file + ":" + std::to_string(scene.initial.source.line_of("settle")) +
            ": initial.settle: the mechanism does not come to rest: after " + number_text(out.time, 3) +
            " s of motion its largest acceleration is " + number_text(relaxation.acceleration(), 3) +
            " m/s2 or rad/s2" +
            (spins ? " and body \"" + mechanism.model.body(relaxation.turning_body()).name() + "\" has turned " +
                         number_text(relaxation.turns(), 3) + " times: what drives it does so for ever. "
                   : ". ") +
            (keys.empty() ? "Support every body against gravity, or remove settle."
                          : "The load exceeds the breakaway friction of " + joined(keys) +
                                ": support what slides there, increase its friction, or remove settle."));
  }
  out.state = relaxation.state();
  out.acceleration = relaxation.acceleration();
}

}  // namespace

Settled settle(const Scene& scene, const AssemblyOptions& options, const IntegratorOptions& integrator) {
  IntegratorOptions tight = integrator;
  tight.rtol = std::min(tight.rtol, kRtol);
  tight.atol = std::min(tight.atol, kAtol);
  tight.atol_velocity = std::min(tight.atol_velocity, kAtolVelocity);
  tight.max_step = 0.0;
  const Mechanism mechanism = build_mechanism(frozen(scene, {}));
  const Assembly assembly = assemble(mechanism.model, options);
  Settled out;
  out.state = assembly.state;
  relax(scene, mechanism, assembly, tight, out);
  // Coordinates that their friction does not hold there slide on, until it does.
  if (const std::vector<std::string> all = frictions(scene); !all.empty()) {
    const Mechanism truly = build_mechanism(frozen(scene, all));
    Equations equations(truly.model, assembly);
    Inputs inputs;
    inputs.values = truly.inputs;
    std::vector<std::string> sliding;
    for (;;) {
      const std::size_t known = sliding.size();
      for (const std::string& name : overloaded(equations, inputs, out.state))
        if (std::find(sliding.begin(), sliding.end(), name) == sliding.end()) sliding.push_back(name);
      if (sliding.size() == known) break;
      relax(scene, build_mechanism(frozen(scene, sliding)), assembly, tight, out);
    }
  }
  const Layout layout(mechanism.model);
  for (int i = 0; i < mechanism.model.body_count(); ++i) {
    const int q = layout.body_q[i];
    const double distance = (out.state.q.segment<3>(q) - assembly.state.q.segment<3>(q)).norm();
    if (distance < out.moved) continue;
    out.moved = distance;
    out.body = mechanism.model.body(i).name();
  }
  return out;
}

}  // namespace footfall
