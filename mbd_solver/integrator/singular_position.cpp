// The logarithm of the determinant falls with the remaining time as 2 k ln(time): two differences give time and k.

#include "mbd_solver/integrator/singular_position.h"

#include <algorithm>
#include <cmath>

namespace footfall {
namespace {

constexpr double kAhead = 8.0;  // spans within which a position is searched for
constexpr int kHalvings = 20;
// A failed step counts kFailure, a successful one subtracts one; beyond kTrouble the next kCareful steps start without drift.
constexpr int kFailure = 2, kTrouble = 2, kCareful = 20;
// Without redundant conditions a position matters only within kInSight of the failed step: other steps fail at contacts.
constexpr double kInSight = 8.0;
// A step over a position may exceed the step for the error of its motion by kLong. Half the gap between two stages around the
// position is at least kGap of the step. A step before it ends kClear of itself away.
constexpr double kLong = 2.0, kGap = 0.08, kClear = 0.5;

}  // namespace

// k singular values decrease evenly, and the determinant with their squares: its logarithm is 2 k ln(time left) + constant. k
// is a whole number, so that other small changes of the determinant do not matter.
double singular_time(const std::array<Nearness, 3>& seen) {
  const double never = std::numeric_limits<double>::infinity();
  const double b = seen[2].time - seen[1].time, b_before = seen[1].time - seen[0].time;
  if (!(b > 0.0) || !(b_before > 0.0) || !std::isfinite(b_before)) return never;
  const double before = seen[0].log_determinant - seen[1].log_determinant;
  const double fall = seen[1].log_determinant - seen[2].log_determinant;
  if (!std::isfinite(fall) || !std::isfinite(before)) return never;
  // Both falls of k = 1 with a time D left; their ratio grows with D.
  const auto first = [&](double D) { return 2.0 * std::log1p(b_before / (D + b)); };
  const auto second = [&](double D) { return 2.0 * std::log1p(b / D); };
  double low = 0.0, high = kAhead * b;
  if (!(before > 0.0) || before * second(high) >= fall * first(high)) return never;
  for (int i = 0; i < kHalvings; ++i) {
    const double D = 0.5 * (low + high);
    (before * second(D) < fall * first(D) ? high : low) = D;
  }
  const double k = std::max(1.0, std::round(fall / second(high)));
  return seen[2].time + b / std::expm1(0.5 * fall / k);
}

bool SingularCrossing::count_failure() {
  failures_ += kFailure;
  return failures_ > kTrouble;
}

void SingularCrossing::count_success() { failures_ = std::max(0, failures_ - 1); }

void SingularCrossing::begin_careful_steps() { careful_ = kCareful; }

void SingularCrossing::look_ahead(SaddleSystem& saddle, const State& before, const State& start, const State& now,
                                  bool possible) {
  if (now.time == looked_time_) return;  // the last step failed as well
  looked_time_ = now.time;
  time_ = std::numeric_limits<double>::infinity();
  if (!possible || !std::isfinite(before.time)) return;
  const auto nearness = [&](const State& at) { return Nearness{at.time, saddle.log_determinant(at)}; };
  time_ = singular_time({nearness(before), nearness(start), nearness(now)});
}

bool SingularCrossing::in_sight(double t, double h) const { return time_ - t < kInSight * h; }

double SingularCrossing::planned_step(const Tableau& tableau, double t, double h, double largest) const {
  const double left = time_ - t;
  if (!(left > 0.0) || left > kLong * h) return h;
  const double longest = largest > 0.0 ? std::min(kLong * h, largest) : kLong * h;
  // The position in the middle between two stages: long steps first.
  std::array<double, kMostStages> c = tableau.c;
  for (std::size_t i = static_cast<std::size_t>(tableau.stages); i < c.size(); ++i) c[i] = 1.0;
  std::sort(c.begin(), c.end());
  int failed = failed_crossings_;
  for (std::size_t i = 1; i < c.size(); ++i) {
    const double place = 0.5 * (c[i - 1] + c[i]);
    if (0.5 * (c[i] - c[i - 1]) < kGap || left / place > longest || failed-- > 0) continue;
    return left / place;
  }
  return std::min(h, left / (1.0 + kClear));
}

}  // namespace footfall
