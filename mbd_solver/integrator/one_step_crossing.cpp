// Steps over singular positions (theory 2.4). Before such a position a place that is off by d puts the rates off by d over the
// square of the time left, however smooth the motion is. So the step over it is a long one, chosen such that no stage comes
// near the position.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mbd_solver/integrator/one_step.h"

namespace footfall {
namespace {

// Steps that fail in a row, or in turn with others, have come near a singular position: a failure counts kFailure, a step
// that succeeds takes one away, and beyond kTrouble the next kCareful steps start without any drift.
constexpr int kFailure = 2, kTrouble = 2, kCareful = 20;
constexpr double kAhead = 8.0;  // of the steps before: a position farther away is not looked for
// A step over a position may be longer than the error of its motion allows by kLong. Half the gap between two stages in which
// the position lies is at least kGap of the step. A step before it ends with kClear of itself left.
constexpr double kLong = 2.0, kGap = 0.08, kClear = 0.5;
constexpr int kHalvings = 20;

}  // namespace

bool OneStep::finds_another_step(double h, double planned, const Inputs& inputs, State& state) {
  trouble_ += kFailure;
  if (!options_.projection) return false;
  if (careful_ > 0) {
    if (planned == h) return false;
    ++crossings_;
    return planned_step(state.time, h) < planned;
  }
  if (trouble_ <= kTrouble) return false;
  careful_ = kCareful;
  start_clean(inputs, state);
  look_ahead(state);
  return planned_step(state.time, h) != h;
}

// k singular values fade evenly, and the determinant with their squares: its logarithm is 2 k ln(time left) + constant. k is
// a whole number, which forgives what else changes the determinant a little.
void OneStep::look_ahead(const State& state) {
  singular_time_ = std::numeric_limits<double>::infinity();
  const double b = state.time - start_.time, b_before = start_.time - start_before_.time;
  if (!options_.error_control || !(h_before_ > 0.0) || !std::isfinite(b_before)) return;
  const double at_start = equations_.log_determinant(start_);
  const double before = equations_.log_determinant(start_before_) - at_start;
  const double fall = at_start - equations_.log_determinant(state);
  if (!std::isfinite(fall) || !std::isfinite(before)) return;
  // Both falls of k = 1 with a time D left; their ratio grows with D.
  const auto first = [&](double D) { return 2.0 * std::log1p(b_before / (D + b)); };
  const auto second = [&](double D) { return 2.0 * std::log1p(b / D); };
  double low = 0.0, high = kAhead * b;
  if (!(before > 0.0) || before * second(high) >= fall * first(high)) return;
  for (int i = 0; i < kHalvings; ++i) {
    const double D = 0.5 * (low + high);
    (before * second(D) < fall * first(D) ? high : low) = D;
  }
  const double k = std::max(1.0, std::round(fall / second(high)));
  singular_time_ = state.time + b / std::expm1(0.5 * fall / k);
}

double OneStep::planned_step(double t, double h) const {
  const double left = singular_time_ - t;
  if (!(left > 0.0) || left > kLong * h) return h;
  const double longest = options_.max_step > 0.0 ? std::min(kLong * h, options_.max_step) : kLong * h;
  // Places of the position in the step, in the middle between two stages: long steps first.
  std::array<double, kMostStages> c = tableau_.c;
  for (std::size_t i = static_cast<std::size_t>(tableau_.stages); i < c.size(); ++i) c[i] = 1.0;
  std::sort(c.begin(), c.end());
  int failed = crossings_;
  for (std::size_t i = 1; i < c.size(); ++i) {
    const double place = 0.5 * (c[i - 1] + c[i]);
    if (0.5 * (c[i] - c[i - 1]) < kGap || left / place > longest || failed-- > 0) continue;
    return left / place;
  }
  return std::min(h, left / (1.0 + kClear));
}

}  // namespace footfall
