#include "mbd_solver/integrator/singular_position.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall {
namespace {

constexpr double kAhead = 8.0;  // of the span before: a position farther away is not looked for
constexpr int kHalvings = 20;

}  // namespace

// k singular values fade evenly, and the determinant with their squares: its logarithm is 2 k ln(time left) + constant. k is
// a whole number, which forgives what else changes the determinant a little.
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

}  // namespace footfall
