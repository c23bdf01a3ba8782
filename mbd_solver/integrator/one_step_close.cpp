// Drift at the end of a step, and in singular positions (theory 2.4).
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/integrator/one_step.h"

namespace footfall {
namespace {

// Drift [in absolute tolerances] that stays within a window; states that are handed out have none.
constexpr double kDrift = 0.1;
// A step whose end projection moves by more than both is one that has failed.
constexpr double kFar = 1e3;        // [tolerances]
constexpr double kFarthest = 1e-6;  // [m, rad, m/s, rad/s]

}  // namespace

// Where drift is far enough, or a singular position near, projection is a part of the step.
bool OneStep::close_end(double t) {
  closed_ = false;
  if (!options_.projection) return true;
  equations_.unpack(Y_.back(), end_);
  end_.time = t;
  const Equations::Drift drift = equations_.drift(end_);
  closed_ = careful_ > 0 || drift.position > kDrift * options_.atol || drift.velocity > kDrift * options_.atol_velocity;
  if (!closed_) return true;
  try {
    end_drift_ = equations_.project(end_, careful_ > 0 ? Equations::Close::kFully : Equations::Close::kAsPromised);
  } catch (const NumericalError& error) {  // a joint that does not close
    complaint_ = error.what();
    error_ = kFar;
    return false;
  }
  // In a singular position a little drift is far from any velocity that fits: to remove it would take energy away.
  const Layout& layout = equations_.layout();
  F_.head(layout.q_size) = end_.q - Y_.back().head(layout.q_size);
  F_.segment(layout.v0(), layout.v_size) = end_.v - Y_.back().segment(layout.v0(), layout.v_size);
  F_.segment(layout.z0(), layout.z_size).setZero();
  const double moved = norm_(F_);
  if (moved <= kFar || F_.head(layout.lambda0()).lpNorm<Eigen::Infinity>() <= kFarthest) return true;
  error_ = moved;
  worst_ = norm_.worst(F_);
  complaint_ = "near a position in which conditions of joints become dependent, drift of " +
               number_text(drift.velocity, 3) + " m/s could be removed only by changing " +
               equations_.entry_name(worst_) + " by " + number_text(std::abs(F_[worst_]), 3) +
               ". Try a larger rtol: longer steps pass over the position.";
  return false;
}

void OneStep::start_clean(const Inputs& inputs, State& state) {
  statistics_.count(equations_.project(state, Equations::Close::kFully));
  renew_rates(inputs, state);
}

void OneStep::renew_rates(const Inputs& inputs, const State& state) {
  equations_.accelerations(state, inputs, K_[0]);
  ++statistics_.factorizations;
  equations_.pack(state, K_[0].tail(equations_.layout().row_count), y_);
  equations_.energy(state.time, y_, inputs, energy_[0]);
}

}  // namespace footfall
