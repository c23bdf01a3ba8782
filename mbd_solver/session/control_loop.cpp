// Measures what a controller reads (acceleration and velocity of its body along gravity, pitch, roll, stroke rates) and
// samples every controller that is due. Before touchdown its outputs are 0.

#include "mbd_solver/session/control_loop.h"

#include <cmath>
#include <limits>

#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

ControlLoop::ControlLoop(Mechanism& mechanism, const Subject& subject)
    : controllers_(mechanism.controllers),
      subject_(subject),
      up_(up_direction(subject.scene.gravity)),
      samples_(controllers_.size(), 0) {
  if (!mechanism.sampled.empty() || !subject.scene.events.empty())
    signals_ = std::make_unique<SignalLoop>(std::move(mechanism.sampled), subject);
}

double ControlLoop::next_sample() const {
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < controllers_.size(); ++i)
    next = std::min(next, static_cast<double>(samples_[i]) * controllers_[i].controller->period());
  if (signals_) next = std::min(next, signals_->next_sample());
  return next;
}

ControllerMeasurement ControlLoop::measure(const ControllerEntry& entry, const Sample& sample) const {
  const BodyKinematics& body = sample.kinematics.of(entry.body);
  ControllerMeasurement m;
  m.time = sample.state.time;
  m.acceleration = up_.dot(body.ddr);
  m.velocity = up_.dot(body.dr);
  // Signs of controller.h: positive when the side of positive x (pitch) or positive y (roll) sinks.
  m.pitch = -std::asin(std::clamp(up_.dot(body.A.col(0)), -1.0, 1.0));
  m.roll = -std::asin(std::clamp(up_.dot(body.A.col(1)), -1.0, 1.0));
  m.strut_rate.setZero(static_cast<Eigen::Index>(entry.struts.size()));
  for (std::size_t k = 0; k < entry.struts.size(); ++k) {
    if (entry.struts[k] < 0) continue;
    const StrutEntry& strut = subject_.mechanism.struts[entry.struts[k]];
    m.strut_rate(static_cast<Eigen::Index>(k)) = sample_of(strut.force, subject_, sample).rate;
  }
  return m;
}

void ControlLoop::sample_due(const Sample& sample, Inputs& inputs) {
  const double time = sample.state.time;
  for (std::size_t i = 0; i < controllers_.size(); ++i) {
    ControllerEntry& entry = controllers_[i];
    const double period = entry.controller->period();
    if (time < (static_cast<double>(samples_[i]) - 1e-6) * period) continue;
    const auto outputs = static_cast<Eigen::Index>(entry.outputs.size());
    Eigen::Ref<Eigen::VectorXd> values = inputs.values.segment(entry.first_input, outputs);
    const ControllerMeasurement measurement = measure(entry, sample);
    if (measurement.acceleration > entry.touchdown_acceleration)
      entry.wakes_at = std::min(entry.wakes_at, time + entry.touchdown_delay);
    entry.controller->sample(measurement, values);  // before touchdown, too: its filter follows
    if (time < entry.wakes_at - 1e-9) values.setZero();
    samples_[i] = static_cast<long>(std::floor(time / period + 1e-6)) + 1;
  }
  if (signals_) signals_->sample_due(sample, inputs.values);
}

void ControlLoop::visit(Archive& archive) {
  archive("samples", samples_);
  for (ControllerEntry& entry : controllers_) {
    const std::string name = "controller." + entry.name;
    Eigen::VectorXd memory = entry.controller->memory();
    archive((name + ".memory").c_str(), memory);
    archive((name + ".wakes_at").c_str(), entry.wakes_at);
    if (archive.restores()) entry.controller->restore(memory);
  }
  if (signals_) archive("signals", *signals_);
}

}  // namespace footfall
