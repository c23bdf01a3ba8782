// Signals are evaluated in the order of the chain; rates follow once all values are known.

#include "mbd_solver/model/control/continuous_signals.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"

namespace footfall {

const std::vector<int>& Sensor::further_bodies() const {
  static const std::vector<int> kNone;
  return kNone;
}

double CoordinateSensor::value(const ElementInput& in, double z) const {
  const double q = JointCoordinate(coordinate_, in.pair, m1_, m2_).value();
  return coordinate_ == Coordinate::kAngle ? nearest_turn(q, z) : q;
}

double CoordinateSensor::rate_of_state(const PairMotion& pair, double z) const {
  const JointCoordinate at(coordinate_, pair, m1_, m2_);
  return turn_counter_rate(at.rate(), nearest_turn(at.value(), z), z);
}

ContinuousSignals::ContinuousSignals(SignalChain chain, std::vector<SignalSource> sources,
                                     std::vector<std::unique_ptr<Sensor>> sensors)
    : chain_(std::move(chain)),
      sources_(std::move(sources)),
      sensors_(std::make_move_iterator(sensors.begin()), std::make_move_iterator(sensors.end())) {
  FOOTFALL_DEMAND(sources_.size() == chain_.names().size());
  for (const std::shared_ptr<const Sensor>& sensor : sensors_) {
    sensor_state_.push_back(sensor->has_state() ? chain_.state_count() + sensor_states_ : -1);
    sensor_states_ += sensor->has_state() ? 1 : 0;
  }
  name_of_sensor_.resize(sensors_.size());
  readers_of_sensor_.resize(sensors_.size());
  readers_.resize(chain_.size());
  for (std::size_t i = 0; i < sources_.size(); ++i)
    if (sources_[i].kind == SignalSource::Kind::kSensor) name_of_sensor_[sources_[i].index] = i;
  for (std::size_t k = 0; k < chain_.size(); ++k) {
    for (const std::size_t other : chain_.reads(k).nodes) readers_[other].push_back(k);
    for (const std::size_t i : chain_.reads(k).names)
      if (sources_[i].kind == SignalSource::Kind::kSensor) readers_of_sensor_[sources_[i].index].push_back(k);
  }
  measured_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(sensors_.size()));
  scratch_ = Eigen::VectorXd::Zero(state_count());
}

void ContinuousSignals::set_names(double t, const Eigen::Ref<const Eigen::VectorXd>& values) {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(sources_[i].index);
    switch (sources_[i].kind) {
      case SignalSource::Kind::kTime: chain_.set(i, t); break;
      case SignalSource::Kind::kPlace: chain_.set(i, values[index]); break;
      case SignalSource::Kind::kSince: chain_.set(i, t - values[index]); break;
      case SignalSource::Kind::kSensor: chain_.set(i, measured_[index]); break;
    }
  }
}

double ContinuousSignals::output(std::size_t k, const Eigen::Ref<const Eigen::VectorXd>& states) {
  const SignalBlock& block = *chain_.node(k).block;
  return block.passes_through() ? block.value(chain_.inputs(k), states) : block.value(states, states);
}

void ContinuousSignals::set_value(std::size_t k, const Eigen::Ref<const Eigen::VectorXd>& z,
                                  Eigen::Ref<Eigen::VectorXd> values) {
  const SignalNode& node = chain_.node(k);
  const double y = chain_.active(k) ? output(k, z.segment(chain_.first_state(k), node.block->state_count())) : 0.0;
  chain_.put(k, y);
  values[node.place] = y;
}

void ContinuousSignals::set_rates(std::size_t k, const Eigen::Ref<const Eigen::VectorXd>& z,
                                  Eigen::Ref<Eigen::VectorXd> dz) {
  const SignalBlock& block = *chain_.node(k).block;
  if (block.state_count() == 0) return;
  auto rates = dz.segment(chain_.first_state(k), block.state_count());
  if (chain_.active(k)) {
    block.rates(chain_.inputs(k), z.segment(chain_.first_state(k), block.state_count()), rates);
  } else {
    rates.setZero();
  }
}

// Breadth first. The value of a node that passes its inputs through changes with them, as do its rates; the value of
// any other node changes with its own states alone.
void ContinuousSignals::complete(Influence& influence, std::vector<bool>& visited) const {
  std::vector<std::size_t> changed = influence.nodes;  // in value
  for (const std::size_t k : changed) visited[k] = true;
  const auto visit = [&](std::size_t k) {
    if (visited[k]) return;
    visited[k] = true;
    influence.nodes.push_back(k);
    if (chain_.node(k).block->passes_through()) changed.push_back(k);
  };
  for (const std::size_t i : influence.sensors)
    for (const std::size_t k : readers_of_sensor_[i]) visit(k);
  for (std::size_t at = 0; at < changed.size(); ++at)
    for (const std::size_t k : readers_[changed[at]]) visit(k);
  std::sort(influence.nodes.begin(), influence.nodes.end());
  for (const std::size_t k : changed) influence.places.push_back(chain_.node(k).place);
  for (const std::size_t k : influence.nodes) {
    visited[k] = false;
    if (const int count = chain_.node(k).block->state_count(); count > 0)
      influence.rates.emplace_back(chain_.first_state(k), count);
  }
  for (const std::size_t i : influence.sensors)
    if (sensor_state_[i] >= 0) influence.rates.emplace_back(sensor_state_[i], 1);
}

std::vector<ContinuousSignals::Influence> ContinuousSignals::influences() const {
  std::map<int, Influence> of_bodies;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    std::set<int> bodies{sensors_[i]->bodies()[0], sensors_[i]->bodies()[1]};
    bodies.insert(sensors_[i]->further_bodies().begin(), sensors_[i]->further_bodies().end());
    for (const int body : bodies)
      if (body != kGround) of_bodies[body].sensors.push_back(i);
  }
  std::vector<Influence> out;
  for (auto& [body, influence] : of_bodies) {
    influence.body = body;
    out.push_back(std::move(influence));
  }
  for (std::size_t k = 0; k < chain_.size(); ++k) {
    Influence influence;
    influence.first_state = chain_.first_state(k);
    influence.state_count = chain_.node(k).block->state_count();
    influence.nodes = {k};
    if (influence.state_count > 0) out.push_back(std::move(influence));
  }
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    Influence influence;
    influence.first_state = sensor_state_[i];
    influence.state_count = 1;
    influence.sensors = {i};
    if (sensor_state_[i] >= 0) out.push_back(std::move(influence));
  }
  std::vector<bool> visited(chain_.size(), false);
  for (Influence& influence : out) complete(influence, visited);
  return out;
}

void ContinuousSignals::start(double t, const Eigen::VectorXd* before, Eigen::Ref<Eigen::VectorXd> z,
                              Eigen::Ref<Eigen::VectorXd> values) {
  std::vector<bool> was_active(chain_.size(), false);
  if (before) {
    set_names(t, *before);
    for (std::size_t k = 0; k < chain_.size(); ++k) was_active[k] = chain_.active(k);
  }
  set_names(t, values);
  const auto begin = [&](std::size_t k) {
    const SignalNode& node = chain_.node(k);
    Eigen::Ref<Eigen::VectorXd> states = z.segment(chain_.first_state(k), node.block->state_count());
    double y = 0.0;
    if (chain_.active(k)) {
      if (!was_active[k]) chain_.settle(k, states);
      y = output(k, states);
    }
    chain_.put(k, y);
    values[node.place] = y;
  };
  try {
    for (std::size_t k = 0; k < chain_.size(); ++k) begin(k);
  } catch (const NumericalError& error) {
    if (!before) throw InputError(error.what());  // at the start the scene is to be corrected
    throw NumericalError("t = " + plain_text(t) + " s: " + error.what());
  }
}

}  // namespace footfall
