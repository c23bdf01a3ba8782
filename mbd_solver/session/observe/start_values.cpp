// Evaluates signals and conditions for the assembled mechanism, before grains act. Whatever depends on controllers, on the
// settled state or on the script is unknown here and is checked by the run.

#include "mbd_solver/session/observe/start_values.h"

#include <algorithm>
#include <functional>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/observe/carry_over.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/observe/requirements.h"
#include "mbd_solver/session/observe/sampler.h"

namespace footfall {
namespace {

// The mechanism at the beginning of a run: joints closed, no contact with grains.
class StartedMechanism {
 public:
  StartedMechanism(const Scene& scene, const Mechanism& mechanism)
      : assembly_(assemble(mechanism.model, assembly_options(scene, mechanism.model))),
        equations_(mechanism.model, assembly_),
        state_(assembly_.state),
        rates_(Eigen::VectorXd::Zero(equations_.layout().size())),
        sampler_({scene, mechanism, equations_.layout()}, equations_, state_, rates_, inputs_),
        still_(mechanism.model) {
    inputs_.values = mechanism.inputs;
    still_.load(equations_.layout(), state_.q, state_.v, Eigen::VectorXd());
  }

  // For sensors of positions and velocities.
  double measure(const Sensor& sensor) const {
    return measured_by(sensor, Instant{still_, equations_.layout(), equations_.model(), state_.z}, 0.0);
  }
  // With accelerations and forces; null where a law is undefined.
  const Sample* sample() {
    try {
      equations_.settle_signals(nullptr, inputs_, state_);
      equations_.saddle().accelerations(state_, inputs_, rates_);
      sampler_.update(0, false, nullptr);
      return &sampler_.sample();
    } catch (const NumericalError&) {
      return nullptr;
    }
  }

 private:
  Assembly assembly_;
  Equations equations_;
  State state_;
  Inputs inputs_;
  Eigen::VectorXd rates_;
  Sampler sampler_;
  Kinematics still_;  // without accelerations
};

class StartValues {
 public:
  using Measured =
      std::function<std::optional<double>(std::size_t name)>;  // other than inputs; none: unknown before the run

  StartValues(const Scene& scene, const Mechanism& mechanism)
      : scene_(scene), mechanism_(mechanism), values_(mechanism.inputs) {}

  const Eigen::VectorXd& inputs() const { return values_; }

  // Nodes in their order, those with known names.
  void evaluate(SignalChain& chain, const Measured& measured) {
    set_names(chain, measured);
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const SignalNode& node = chain.node(k);
      double y = 0.0;
      if (!is_known(chain, k) || node.block->runs_apart() || (state_may_change_ && !node.states.empty())) {
        unknown_.insert("signal." + node.name);
      } else if (chain.active(k)) {
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
      values_(node.place) = y;
    }
  }

  // Conditions in the first state. A condition that is true, or unknown, may change the state at once.
  void evaluate_conditions(SignalChain& conditions, const Measured& measured) {
    set_names(conditions, measured);
    for (const EventSpec& event : scene_.events) {
      const std::string& first = scene_.states.front().name;
      const bool applies = event.from.empty()
                               ? event.to != first
                               : std::find(event.from.begin(), event.from.end(), first) != event.from.end();
      if (!applies) continue;
      std::size_t k = 0;
      while (conditions.node(k).name != event.name) ++k;
      const bool known = is_known(conditions, k), holds = known && conditions.inputs(k)[0] != 0.0;
      state_may_change_ = state_may_change_ || holds || !known;
      if (holds) break;
    }
    if (!state_may_change_) return;
    for (const StateSpec& state : scene_.states) unknown_.insert("state." + state.name);
  }

 private:
  void set_names(SignalChain& chain, const Measured& measured) {
    for (std::size_t i = 0; i < chain.names().size(); ++i) {
      const std::optional<double> value = value_of(chain.names()[i], [&] { return measured(i); });
      if (!value) unknown_.insert(chain.names()[i]);
      chain.set(i, value.value_or(0.0));
    }
  }
  // None for outputs of controllers, and for what depends on unknown values.
  template <class Measure>
  std::optional<double> value_of(const std::string& name, Measure measure) const {
    if (unknown_.count(name) > 0) return std::nullopt;
    if (name == "time" || name == "state.since") return 0.0;
    if (const std::optional<SignalSource> source = signal_source(mechanism_, name)) {
      if (name.rfind("signal.", 0) != 0 && name.rfind("state.", 0) != 0) return std::nullopt;
      return values_(static_cast<Eigen::Index>(source->index));
    }
    return measure();
  }
  bool is_known(const SignalChain& chain, std::size_t k) const {
    for (const std::size_t name : chain.reads(k).names)
      if (unknown_.count(chain.names()[name]) > 0) return false;
    for (const std::size_t other : chain.reads(k).nodes)
      if (unknown_.count("signal." + chain.node(other).name) > 0) return false;
    return true;
  }

  const Scene& scene_;
  const Mechanism& mechanism_;
  Eigen::VectorXd values_;
  std::set<std::string> unknown_;
  bool state_may_change_ = false;
};

// Walls of the script are known to LIGGGHTS only; a settled start is known to the run only.
bool start_is_known(const Scene& scene, const Mechanism& mechanism) {
  return !scene.initial.settle && std::none_of(mechanism.contacts.begin(), mechanism.contacts.end(),
                                               [](const ContactEntry& entry) { return entry.walls != nullptr; });
}

}  // namespace

AssemblyOptions assembly_options(const Scene& scene, const Model& model) {
  AssemblyOptions options;
  if (!scene.initial.from.empty())
    options.carry = [&scene, &model](const Layout& layout, State& state) {
      carry_over(scene, model, layout, state, nullptr);
    };
  options.gap_tolerance = std::max(options.gap_tolerance, scene.initial.largest_gap);
  for (const InitialJointSpec& given : scene.initial.joints) {
    const int joint = scene.joint_index(given.name);
    for (const Coordinate choice : coordinates_of(scene.joints[joint].type))
      if (given.value(choice)) options.start.push_back({joint, choice, *given.value(choice)});
  }
  return options;
}

void require_values_at_start(const Scene& scene, bool is_placed, Mechanism& mechanism) {
  const Layout layout(mechanism.model);
  StartedMechanism start(scene, mechanism);  // assembled as a run does, which refuses what does not fit
  if (scene.landing) LandingWatch({scene, mechanism, layout});
  if (!scene.requirements.empty()) Requirements(scene, Observation({scene, mechanism, layout}).names());
  if (scene.signals.empty() && scene.events.empty()) return;
  SignalChain sampled = chain_of_signals(scene, std::move(mechanism.sampled));
  SignalChain conditions(conditions_of(scene));
  std::vector<std::string> names = sampled.names();
  names.insert(names.end(), conditions.names().begin(), conditions.names().end());
  Readings readings(names, {scene, mechanism, layout});

  const bool is_known = is_placed && start_is_known(scene, mechanism);
  StartValues values(scene, mechanism);
  try {
    if (const ContinuousSignals* const continuous = mechanism.model.signals()) {
      SignalChain chain = continuous->chain();
      values.evaluate(chain, [&](std::size_t name) -> std::optional<double> {
        if (!is_known) return std::nullopt;
        return start.measure(*sensor_of(mechanism, chain.names()[name]));
      });
    }
    const Sample* const sample = is_known ? start.sample() : nullptr;
    if (sample) readings.update(*sample);
    const auto read = [&](std::size_t name) -> std::optional<double> {
      if (!sample) return std::nullopt;
      return readings.value(name, *sample, values.inputs());
    };
    values.evaluate_conditions(conditions, [&](std::size_t name) { return read(sampled.names().size() + name); });
    values.evaluate(sampled, read);
  } catch (const NumericalError& error) {
    throw InputError(error.what());
  }
}

std::vector<std::string> unset_signals(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const SignalSpec& signal : scene.signals)
    if (signal.kind == SignalKind::kHost)
      warnings.push_back(with_code(
          code::kUnsetSignal, place_of(scene.file, signal.source) + "a signal of kind host keeps its initial value, " +
                                  number_text(signal.initial.value_or(0.0)) +
                                  ", in a run from the command line; lead the scene from a program (Python, an "
                                  "FMU), or give the signal another kind"));
  return warnings;
}

}  // namespace footfall
