// While no sample changes an input, windows need not end at samples: change() reports it.

#include "mbd_solver/session/loop/sampled_inputs.h"

#include "coupler/base/clock.h"
#include "mbd_solver/session/loop/solver_options.h"

namespace footfall {

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
