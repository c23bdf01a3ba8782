// Signals are evaluated in the order of the chain; rates follow once all values are known.

#include "mbd_solver/model/control/continuous_signals.h"

#include <set>

#include "coupler/base/errors.h"

namespace footfall {

double CoordinateSensor::value(const PairMotion& pair, double z) const {
  const double q = JointCoordinate(coordinate_, pair, m1_, m2_).value();
  return coordinate_ == Coordinate::kAngle ? nearest_turn(q, z) : q;
}

double CoordinateSensor::rate_of_state(const PairMotion& pair, double z) const {
  const JointCoordinate at(coordinate_, pair, m1_, m2_);
  return turn_counter_rate(at.rate(), nearest_turn(at.value(), z), z);
}

ContinuousSignals::ContinuousSignals(SignalChain chain, std::vector<SignalSource> sources,
                                     std::vector<std::unique_ptr<Sensor>> sensors)
    : chain_(std::move(chain)), sources_(std::move(sources)), sensors_(std::move(sensors)) {
  FOOTFALL_DEMAND(sources_.size() == chain_.names().size());
  for (const std::unique_ptr<Sensor>& sensor : sensors_) sensor_states_ += sensor->has_state() ? 1 : 0;
  measured_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(sensors_.size()));
  scratch_ = Eigen::VectorXd::Zero(state_count());
}

std::vector<int> ContinuousSignals::bodies() const {
  std::set<int> bodies;
  for (const std::unique_ptr<Sensor>& sensor : sensors_)
    for (const int body : sensor->bodies())
      if (body != kGround) bodies.insert(body);
  return {bodies.begin(), bodies.end()};
}

void ContinuousSignals::set_names(double t, const Eigen::Ref<const Eigen::VectorXd>& values) const {
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

double ContinuousSignals::output(std::size_t k, const Eigen::Ref<const Eigen::VectorXd>& states) const {
  const SignalBlock& block = *chain_.node(k).block;
  return block.passes_through() ? block.value(chain_.inputs(k), states) : block.value(states, states);
}

void ContinuousSignals::run(double t, const Eigen::Ref<const Eigen::VectorXd>& z, Eigen::Ref<Eigen::VectorXd> values,
                            Eigen::Ref<Eigen::VectorXd> dz) const {
  set_names(t, values);
  for (std::size_t k = 0; k < chain_.size(); ++k) {
    const SignalNode& node = chain_.node(k);
    const double y = chain_.active(k) ? output(k, z.segment(chain_.first_state(k), node.block->state_count())) : 0.0;
    chain_.put(k, y);
    values[node.place] = y;
  }
  for (std::size_t k = 0; k < chain_.size(); ++k) {
    const SignalBlock& block = *chain_.node(k).block;
    if (block.state_count() == 0) continue;
    auto rates = dz.segment(chain_.first_state(k), block.state_count());
    if (chain_.active(k)) {
      block.rates(chain_.inputs(k), z.segment(chain_.first_state(k), block.state_count()), rates);
    } else {
      rates.setZero();
    }
  }
}

void ContinuousSignals::start(double t, const Eigen::VectorXd* before, Eigen::Ref<Eigen::VectorXd> z,
                              Eigen::Ref<Eigen::VectorXd> values) const {
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
    throw NumericalError("t = " + std::to_string(t) + " s: " + error.what());
  }
}

}  // namespace footfall
