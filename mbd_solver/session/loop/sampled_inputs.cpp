// While no sample changes an input, windows need not end at samples: change() reports it.

#include "mbd_solver/session/loop/sampled_inputs.h"

#include <cmath>
#include <limits>

#include "coupler/base/clock.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/session/loop/moving_mechanism.h"

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

SampledInputs::SampledInputs(MovingMechanism& moving)
    : moving_(moving), control_(moving.mechanism(), moving.subject()) {}

void SampledInputs::begin() {
  const Scene& scene = moving_.scene();
  stiff_signals_ =
      std::make_unique<StiffSignals>(scene, moving_.mechanism(), moving_.assembly(), baumgarte_of(scene.solver));
  if (stiff_signals_->empty()) stiff_signals_.reset();
  moving_.inputs().values = moving_.mechanism().inputs;
  change_ = std::isfinite(control_.next_sample());  // otherwise nothing is sampled, and rows do not end a window
}

void SampledInputs::sample_due() {
  const double started = wall_clock(), due = control_.next_sample();
  Inputs& inputs = moving_.inputs();
  const Eigen::VectorXd values = inputs.values;
  control_.sample_due(moving_.sample(), inputs);
  if (control_.next_sample() > due) {
    change_ = inputs.values != values;
    if (stiff_signals_) stiff_signals_->observe(moving_.state(), inputs);
  }
  moving_.times().control += wall_clock() - started;
}

void SampledInputs::sample_at_start() {
  for (const SignalSpec& signal : moving_.scene().signals)
    if (signal.kind == SignalKind::kHost) return;
  const Inputs& inputs = moving_.inputs();
  const double now = moving_.state().time;
  if (moving_.corners().next(now, inputs.values).before <= now) return;
  const Eigen::VectorXd before = inputs.values;
  sample_due();
  if (inputs.values != before) moving_.renew();
}

std::vector<std::string> SampledInputs::warnings() const {
  return stiff_signals_ ? stiff_signals_->warnings() : std::vector<std::string>();
}

}  // namespace footfall
