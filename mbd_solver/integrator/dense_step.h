#pragma once
// States within a step, from what is known at its two ends and at its stages: nothing is solved again. theta in [0, 1]:
//   x(theta) = (1 + 2 theta)(1 - theta)^2 x_0 + theta^2 (3 - 2 theta) x_1
//            + h theta (1 - theta)^2 x'_0 - h theta^2 (1 - theta) x'_1      x: q, v, z and the time integrals of powers
//   K(theta) = Lagrange's polynomial through three or four stages           K: dv, dz and the multipliers
// x is off by O(h^4), its rates are continuous from step to step.

#include <array>

#include "mbd_solver/dynamics/equations.h"

namespace footfall {

struct HermiteWeights {
  HermiteWeights(double theta, double h)
      : x0((1.0 + 2.0 * theta) * (1.0 - theta) * (1.0 - theta)),
        x1(theta * theta * (3.0 - 2.0 * theta)),
        dx0(h * theta * (1.0 - theta) * (1.0 - theta)),
        dx1(-h * theta * theta * (1.0 - theta)) {}
  double x0, x1, dx0, dx1;
};

// The time integrals of a State at theta, from those at both ends and the powers there.
inline void interpolate_work(const HermiteWeights& w, const State& start, const EnergySample& at_start,
                             const State& end, const EnergySample& at_end, State& out) {
  for (std::size_t k = 0; k < out.dissipated.by_kind.size(); ++k)
    out.dissipated.by_kind[k] = w.x0 * start.dissipated.by_kind[k] + w.x1 * end.dissipated.by_kind[k] +
                                w.dx0 * at_start.power.by_kind[k] + w.dx1 * at_end.power.by_kind[k];
  out.load_work =
      w.x0 * start.load_work + w.x1 * end.load_work + w.dx0 * at_start.load_power + w.dx1 * at_end.load_power;
  for (std::size_t k = 0; k < out.supplied.by_kind.size(); ++k)
    out.supplied.by_kind[k] = w.x0 * start.supplied.by_kind[k] + w.x1 * end.supplied.by_kind[k] +
                              w.dx0 * at_start.supplied.by_kind[k] + w.dx1 * at_end.supplied.by_kind[k];
}

// Lagrange's polynomial number k through the first `count` of `nodes`, at theta.
template <std::size_t kSize>
double lagrange(const std::array<double, kSize>& nodes, std::size_t count, std::size_t k, double theta) {
  double value = 1.0;
  for (std::size_t j = 0; j < count; ++j)
    if (j != k) value *= (theta - nodes[j]) / (nodes[k] - nodes[j]);
  return value;
}

}  // namespace footfall
