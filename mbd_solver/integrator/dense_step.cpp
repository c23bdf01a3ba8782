// States follow from the stages with the weights of the extension, just as the step's end follows with
// the weights of the method.

#include "mbd_solver/integrator/dense_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace footfall {
namespace {

constexpr double kNearEnd = 1e-9;  // of a step
constexpr int kMostHalvings = 60;  // in the search for the change of a mode

}  // namespace

DenseStep::DenseStep(Equations& equations, const StepData& step) : equations_(equations), step_(step) {
  rates_ = known_ = step.y;
  forget();
}

void DenseStep::forget() { start_before_.time = start_.time = -std::numeric_limits<double>::infinity(); }

void DenseStep::begin(const State& start, double h) {
  std::swap(start_before_, start_);
  start_ = start;
  h_ = h;
}

State& DenseStep::at(double time) {
  const int m = equations_.layout().lambda0();
  const DenseWeights w(*step_.tableau, (time - start_.time) / h_);
  state_ = start_;
  state_.time = time;
  known_ = step_.y;
  rates_.setZero();
  for (std::size_t i = 0; i <= step_.last(); ++i) {
    known_.head(m) += (h_ * w.b[i]) * step_.K[i].head(m);
    rates_ += w.slope[i] * step_.K[i];
    add_work(step_.energy[i], h_ * w.b[i], state_);
  }
  equations_.layout().unpack(known_, state_);
  return state_;
}

// The first crossing of zero that the middle or the end of the step shows, from above; behind it
// the mode no longer fits.
double DenseStep::time_of_switch(double end, const Inputs& inputs) {
  const auto value = [&](double time) { return equations_.mode_value(at(time), inputs); };
  double before = start_.time, after = 0.5 * (start_.time + end);
  double at_after = value(after);
  if (at_after >= 0.0) {
    before = std::exchange(after, end);
    at_after = value(end);
    if (at_after >= 0.0) return HUGE_VAL;
  }
  double at_before = before == start_.time ? std::max(equations_.mode_value(start_, inputs), 0.0) : value(before);
  // Regula falsi (Illinois), with bisection where it does not halve the bracket.
  for (int i = 0; i < kMostHalvings && after - before > kNearEnd * h_; ++i) {
    const double share = i % 3 == 2 ? 0.5 : at_before / (at_before - at_after);
    const double middle = before + std::clamp(share, 0.01, 0.99) * (after - before);
    if (middle <= before || middle >= after) break;
    const double now = value(middle);
    (now < 0.0 ? after : before) = middle;
    (now < 0.0 ? at_after : at_before) = now;
    if (now < 0.0) at_before *= 0.5;
  }
  return after;
}

}  // namespace footfall
