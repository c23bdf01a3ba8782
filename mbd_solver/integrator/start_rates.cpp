// The rates of a state under given loads are the solution of the saddle system.

#include "mbd_solver/integrator/start_rates.h"

#include <algorithm>

namespace footfall {
namespace {

// Rates are corrected until the correction changes a step by less than this share of the tolerance.
constexpr double kRateError = 1e-4;
constexpr int kMostCorrections = 4;

}  // namespace

StartRates::StartRates(Equations& equations, const IntegratorOptions& options, StepData& step, ErrorNorm& norm,
                       IntegratorStatistics& statistics)
    : equations_(equations), options_(options), step_(step), norm_(norm), statistics_(statistics) {
  change_ = rates_ = left_ = step.y;
}

void StartRates::start_window(const Inputs& inputs, const State& state) {
  if (!follow(inputs, state)) {
    equations_.saddle().stage_rates(state, inputs, step_.K[0]);
    ++statistics_.factorizations;
    keep_resting_rows();
  }
  pack(inputs, state);
}

void StartRates::renew(const Inputs& inputs, const State& state) {
  equations_.saddle().forget();
  equations_.saddle().stage_rates(state, inputs, step_.K[0]);
  ++statistics_.factorizations;
  keep_resting_rows();
  pack(inputs, state);
}

void StartRates::pack(const Inputs& inputs, const State& state) {
  equations_.layout().pack(state, step_.K[0].tail(equations_.layout().row_count), step_.y);
  equations_.powers(state.time, step_.y, inputs, step_.energy[0]);
}

bool StartRates::follow(const Inputs& inputs, const State& state) {
  if (state.time != left_time_ || !(state.step > 0.0)) return false;
  const int m = equations_.layout().lambda0();
  equations_.layout().pack(state, rates_.tail(equations_.layout().row_count), step_.y);
  if (step_.y.head(m) != left_.head(m)) return false;
  step_.K[0] = rates_;
  norm_.set(step_.y);
  const double step = options_.max_step > 0.0 ? std::min(state.step, options_.max_step) : state.step;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostCorrections; ++i) {
    if (!equations_.saddle().correct_rates(state, inputs, step_.K[0], change_)) return false;
    ++statistics_.residuals;
    change_ *= step;
    const double size = norm_(change_);
    if (size <= kRateError) return true;
    if (!(size < 0.1 * last)) return false;
    // The remaining error relates to this correction as this one to the previous one.
    if (size * (size / last) <= kRateError && i > 0) return true;
    last = size;
  }
  return false;
}

void StartRates::follow_resting_rows(double t) {
  const long changes = equations_.saddle().resting_row_changes();
  if (changes == resting_row_changes_) return;
  resting_row_changes_ = changes;
  const int rows = equations_.layout().row_count;
  equations_.saddle().multipliers_without_resting_rows(t, step_.y, step_.K[0].tail(rows));
}

void StartRates::end_window(const State& state) {
  const int rows = equations_.layout().row_count;
  rates_ = step_.K[0];
  equations_.saddle().smallest_multipliers(state, rates_.tail(rows));
  left_time_ = state.time;
  equations_.layout().pack(state, rates_.tail(rows), left_);
}

}  // namespace footfall
