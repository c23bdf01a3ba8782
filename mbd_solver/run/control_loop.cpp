#include "mbd_solver/run/control_loop.h"

#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "mbd_solver/model/elements/strut.h"

namespace footfall {

ControlLoop::ControlLoop(std::vector<ControllerEntry>& controllers, const std::vector<StrutEntry>& struts,
                         const Eigen::Vector3d& up)
    : controllers_(controllers), struts_(struts), up_(up), samples_(controllers.size(), 0) {}

double ControlLoop::next_sample() const {
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < controllers_.size(); ++i)
    next = std::min(next, static_cast<double>(samples_[i]) * controllers_[i].controller->period());
  return next;
}

ControllerMeasurement ControlLoop::measure(const ControllerEntry& entry, const State& state, Equations& equations,
                                           const Eigen::VectorXd& rates, const Inputs& inputs) const {
  const BodyKinematics& body = equations.motion(entry.body);
  const Layout& layout = equations.layout();
  const Eigen::Vector3d ddr = rates.segment<3>(layout.v0() + layout.body_v[static_cast<std::size_t>(entry.body)]);
  ControllerMeasurement m;
  m.time = state.time;
  m.acceleration = up_.dot(ddr);
  m.velocity = up_.dot(body.dr);
  // Signs of controller.h: positive when the side of positive x (pitch) or positive y (roll) sinks.
  m.pitch = -std::asin(std::clamp(up_.dot(body.A.col(0)), -1.0, 1.0));
  m.roll = -std::asin(std::clamp(up_.dot(body.A.col(1)), -1.0, 1.0));
  m.strut_rate.setZero(static_cast<Eigen::Index>(entry.struts.size()));
  for (std::size_t k = 0; k < entry.struts.size(); ++k) {
    if (entry.struts[k] < 0) continue;
    const int force = struts_[static_cast<std::size_t>(entry.struts[k])].force;
    const auto& strut = static_cast<const Strut&>(equations.model().force(force));
    m.strut_rate(static_cast<Eigen::Index>(k)) = strut.sample(equations.element_input(force, state, inputs)).rate;
  }
  return m;
}

void ControlLoop::sample_due(const State& state, Equations& equations, const Eigen::VectorXd& rates, Inputs& inputs) {
  bool loaded = false;
  for (std::size_t i = 0; i < controllers_.size(); ++i) {
    ControllerEntry& entry = controllers_[i];
    const double period = entry.controller->period();
    if (state.time < (static_cast<double>(samples_[i]) - 1e-6) * period) continue;
    if (!loaded) equations.load(state);
    loaded = true;
    const auto outputs = static_cast<Eigen::Index>(entry.outputs.size());
    Eigen::Ref<Eigen::VectorXd> voltages = inputs.voltages.segment(entry.first_voltage, outputs);
    const ControllerMeasurement measurement = measure(entry, state, equations, rates, inputs);
    if (measurement.acceleration > entry.touchdown_acceleration)
      entry.wakes_at = std::min(entry.wakes_at, state.time + entry.touchdown_delay);
    entry.controller->sample(measurement, voltages);  // asleep too: its filter follows
    if (state.time < entry.wakes_at - 1e-9) voltages.setZero();
    samples_[i] = static_cast<long>(std::floor(state.time / period + 1e-6)) + 1;
  }
}

}  // namespace footfall
