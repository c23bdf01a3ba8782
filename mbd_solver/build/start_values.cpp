// The expressions of signals at the start of a run: one without a value there is told before anything runs.

#include <algorithm>
#include <set>

#include "coupler/base/errors.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

// The run moves nothing before it starts, and changes no velocity.
bool starts_as_drawn(const Scene& scene) {
  const InitialSpec& initial = scene.initial;
  if (initial.settle || !initial.joints.empty()) return false;
  if (scene.joints.empty()) return true;
  const bool moves = !initial.velocity.isZero(0.0) || !initial.angular_velocity.isZero(0.0) || !initial.bodies.empty();
  return !moves && std::none_of(scene.joints.begin(), scene.joints.end(), [](const JointSpec& j) { return j.motion; });
}

BodyKinematics motion_as_drawn(const Model& model, int body) {
  BodyKinematics out;
  if (body == kGround) return out;
  const BodyState& state = model.initial(body);
  out.ground = false;
  out.modes = model.body(body).mode_count();
  out.r = state.r;
  out.L = state.L;
  out.A = rotation_matrix(state.L);
  out.dr = state.dr;
  out.w = state.w;
  out.a = out.da = out.dda = Eigen::VectorXd::Zero(out.modes);
  return out;
}

double value_as_drawn(const Model& model, const Sensor& sensor) {
  const std::array<int, 2> bodies = sensor.bodies();
  const BodyKinematics a = motion_as_drawn(model, bodies[0]), b = motion_as_drawn(model, bodies[1]);
  return sensor.value({{&a, &b}}, 0.0);
}

class StartValues {
 public:
  StartValues(const Mechanism& mechanism, bool as_drawn)
      : mechanism_(mechanism), as_drawn_(as_drawn), voltages_(mechanism.voltages) {}

  // Its nodes in their order, those whose names are known.
  void evaluate(const SignalChain& chain) {
    for (std::size_t i = 0; i < chain.names().size(); ++i) {
      const std::optional<double> value = value_of(chain.names()[i]);
      if (!value) unknown_.insert(chain.names()[i]);
      chain.set(i, value.value_or(0.0));
    }
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const SignalNode& node = chain.node(k);
      double y = 0.0;
      if (!is_known(node)) {
        unknown_.insert("signal." + node.name);
      } else if (chain.works(k)) {
        Eigen::VectorXd z = Eigen::VectorXd::Zero(node.block->state_count());
        chain.settle(k, z);
        const Eigen::VectorXd& u = chain.inputs(k);
        if (!node.block->passes_through()) {
          y = node.block->value(z, z);
        } else {
          y = node.period > 0.0 ? node.block->sample(u, node.period, z) : node.block->value(u, z);
        }
      }
      chain.put(k, y);
      voltages_(node.place) = y;
    }
  }

 private:
  // Nothing for what the run alone knows: controllers, accelerations, forces, contacts, and what reads them.
  std::optional<double> value_of(const std::string& name) const {
    if (unknown_.count(name) > 0) return std::nullopt;
    if (name == "time" || name == "state.since") return 0.0;
    if (const std::optional<SignalSource> source = signal_source(mechanism_, name)) {
      if (name.rfind("signal.", 0) != 0 && name.rfind("state.", 0) != 0) return std::nullopt;
      return voltages_(static_cast<Eigen::Index>(source->index));
    }
    const std::unique_ptr<Sensor> sensor = as_drawn_ ? sensor_of(mechanism_, name) : nullptr;
    if (!sensor) return std::nullopt;
    return value_as_drawn(mechanism_.model, *sensor);
  }
  bool is_known(const SignalNode& node) const {
    for (const std::string& input : node.inputs)
      for (const std::string& name : Expression::names_in(input))
        if (unknown_.count(name) > 0) return false;
    return true;
  }

  const Mechanism& mechanism_;
  bool as_drawn_;
  Eigen::VectorXd voltages_;
  std::set<std::string> unknown_;
};

}  // namespace

void demand_values_at_start(const Scene& scene, bool is_placed, Mechanism& mechanism) {
  if (scene.signals.empty()) return;
  StartValues values(mechanism, is_placed && starts_as_drawn(scene));
  try {
    if (const ContinuousSignals* const continuous = mechanism.model.signals()) values.evaluate(continuous->chain());
    if (!mechanism.sampled.empty()) values.evaluate(SignalChain(std::move(mechanism.sampled)));
  } catch (const NumericalError& error) {
    throw InputError(error.what());
  }
}

}  // namespace footfall
