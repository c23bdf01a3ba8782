// Steps over singular positions (singular_position.h, theory 2.4): the step over such a position is a long one, chosen such
// that no stage comes near it.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mbd_solver/integrator/one_step.h"
#include "mbd_solver/integrator/singular_position.h"

namespace footfall {
namespace {

// Steps that fail in a row, or in turn with others, have come near a singular position: a failure counts kFailure, a step
// that succeeds takes one away, and beyond kTrouble the next kCareful steps start without any drift.
constexpr int kFailure = 2, kTrouble = 2, kCareful = 20;
// Where no conditions of joints follow from others they do so only if a position is expected within kInSight of the step that
// failed: others fail at contacts and stops.
constexpr double kInSight = 8.0;
// A step over a position may be longer than the error of its motion allows by kLong. Half the gap between two stages in which
// the position lies is at least kGap of the step. A step before it ends with kClear of itself left.
constexpr double kLong = 2.0, kGap = 0.08, kClear = 0.5;

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
  if (!may_be_singular_) {
    look_ahead(state);
    if (!(singular_time_ - state.time < kInSight * h)) return false;
  }
  careful_ = kCareful;
  start_clean(inputs, state);
  look_ahead(state);
  return planned_step(state.time, h) != h;
}

void OneStep::look_ahead(const State& state) {
  if (state.time == looked_time_) return;  // the last step failed as well
  looked_time_ = state.time;
  singular_time_ = std::numeric_limits<double>::infinity();
  if (!options_.error_control || !(h_before_ > 0.0) || !std::isfinite(start_before_.time)) return;
  const auto nearness = [&](const State& at) { return Nearness{at.time, equations_.saddle().log_determinant(at)}; };
  singular_time_ = singular_time({nearness(start_before_), nearness(start_), nearness(state)});
}

double OneStep::planned_step(double t, double h) const {
  const double left = singular_time_ - t;
  if (!(left > 0.0) || left > kLong * h) return h;
  const double longest = options_.max_step > 0.0 ? std::min(kLong * h, options_.max_step) : kLong * h;
  // Places of the position in the step, in the middle between two stages: long steps first.
  std::array<double, kMostStages> c = tableau_->c;
  for (std::size_t i = static_cast<std::size_t>(tableau_->stages); i < c.size(); ++i) c[i] = 1.0;
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
