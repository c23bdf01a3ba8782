// Drift at the end of a step, and in singular positions (theory 2.4).
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/integrator/one_step.h"

namespace footfall {
namespace {

// Drift [in absolute tolerances] that stays within a window; states that are handed out have none.
constexpr double kDrift = 0.1;
constexpr double kOpen = 1e3;  // error of a step whose end does not close

// A window that goes on where the last one ended starts from its rates, corrected with factors of the saddle matrix that are
// at hand, until the correction changes a step by less than this share of the tolerance.
constexpr double kRateError = 1e-4;
constexpr int kMostCorrections = 4;

}  // namespace

// Where drift is far enough, or a singular position near, projection is a part of the step.
bool OneStep::close_end(double t) {
  closed_ = false;
  if (!options_.projection) return true;
  equations_.unpack(Y_[last()], end_);
  end_.time = t;
  const Drift drift = equations_.saddle().drift(end_);
  closed_ = careful_ > 0 || drift.position > kDrift * options_.atol || drift.velocity > kDrift * options_.atol_velocity;
  if (!closed_) return true;
  if (careful_ > 0) equations_.saddle().forget();  // pivots that a row of the output has chosen shall not turn the motion
  try {
    end_drift_ = equations_.saddle().project(end_, SaddleSystem::Close::kFully);
  } catch (const NumericalError& error) {   // a joint that does not close
    const std::string said = error.what();  // "t = ... s: ..."; the time is told once
    complaint_ = said.substr(said.find(": ") + 2);
    error_ = kOpen;
    return false;
  }
  const Layout& layout = equations_.layout();
  F_.head(layout.q_size) = end_.q - Y_[last()].head(layout.q_size);
  F_.segment(layout.v0(), layout.v_size) = end_.v - Y_[last()].segment(layout.v0(), layout.v_size);
  F_.segment(layout.z0(), layout.z_size).setZero();
  if (!options_.error_control || !norm_.far(F_)) return true;
  error_ = norm_(F_);
  worst_ = norm_.worst(F_);
  complaint_ = "near a position in which conditions of joints become dependent, drift of " +
               number_text(drift.velocity, 3) + " m/s could be removed only by changing " +
               equations_.entry_name(worst_) + " by " + number_text(std::abs(F_[worst_]), 3) +
               ". Try a larger rtol: longer steps pass over the position.";
  return false;
}

void OneStep::start_clean(const Inputs& inputs, State& state) {
  equations_.saddle().forget();  // likewise
  statistics_.count(equations_.saddle().project(state, SaddleSystem::Close::kFully));
  renew_rates(inputs, state);
  looked_time_ = std::numeric_limits<double>::quiet_NaN();
}

void OneStep::start_window(const Inputs& inputs, const State& state) {
  if (!follow_rates(inputs, state)) {
    equations_.saddle().stage_rates(state, inputs, K_[0]);
    ++statistics_.factorizations;
    rest_choices_ = equations_.saddle().resting_row_changes();
  }
  equations_.pack(state, K_[0].tail(equations_.layout().row_count), y_);
  equations_.powers(state.time, y_, inputs, energy_[0]);
}

bool OneStep::follow_rates(const Inputs& inputs, const State& state) {
  if (state.time != left_time_ || !(state.step > 0.0)) return false;
  const int m = equations_.layout().lambda0();
  equations_.pack(state, rates_.tail(equations_.layout().row_count), y_);
  if (y_.head(m) != left_.head(m)) return false;
  K_[0] = rates_;
  norm_.set(y_);
  const double step = options_.max_step > 0.0 ? std::min(state.step, options_.max_step) : state.step;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostCorrections; ++i) {
    if (!equations_.saddle().correct_rates(state, inputs, K_[0], change_)) return false;
    ++statistics_.residuals;
    change_ *= step;
    const double size = norm_(change_);
    if (size <= kRateError) return true;
    if (!(size < 0.1 * last)) return false;
    // What is still missing is as small against this correction as this one is against the one before.
    if (size * (size / last) <= kRateError && i > 0) return true;
    last = size;
  }
  return false;
}

void OneStep::renew_rates(const Inputs& inputs, const State& state) {
  equations_.saddle().forget();
  equations_.saddle().stage_rates(state, inputs, K_[0]);
  ++statistics_.factorizations;
  rest_choices_ = equations_.saddle().resting_row_changes();
  equations_.pack(state, K_[0].tail(equations_.layout().row_count), y_);
  equations_.powers(state.time, y_, inputs, energy_[0]);
}

}  // namespace footfall
