#pragma once
// A spring that only pushes, once continuously differentiable: the contact law inside end stops and honeycomb
// cartridges.
//   force(d) = 0                        d <= 0
//            = k d^2 / (2 toe)          0 < d < toe
//            = k (d - toe/2)            d >= toe
// The toe replaces the kink of k max(0, d), so that an implicit solver meets no jump of stiffness when a gap
// closes. Its price is documented: far from the toe the force is that of a spring which starts toe/2 later.

#include <cmath>

namespace footfall {

struct OneSidedSpring {
  double stiffness;  // k > 0 [N/m]
  double toe;        // > 0 [m]

  // Force at penetration d [N], >= 0.
  double force(double d) const {
    if (d <= 0.0) return 0.0;
    return d < toe ? 0.5 * stiffness * d * d / toe : stiffness * (d - 0.5 * toe);
  }
  // d(force)/dd [N/m], >= 0.
  double slope(double d) const {
    if (d <= 0.0) return 0.0;
    return d < toe ? stiffness * d / toe : stiffness;
  }
  // Integral of the force from 0 to d [J], >= 0.
  double energy(double d) const {
    if (d <= 0.0) return 0.0;
    if (d < toe) return stiffness * d * d * d / (6.0 * toe);
    const double past = d - toe;
    return stiffness * (toe * toe / 6.0 + 0.5 * toe * past + 0.5 * past * past);
  }
  // The penetration that carries a given force >= 0 [m]: the inverse of force().
  double penetration(double f) const {
    if (f <= 0.0) return 0.0;
    const double at_toe = 0.5 * stiffness * toe;
    return f < at_toe ? std::sqrt(2.0 * toe * f / stiffness) : f / stiffness + 0.5 * toe;
  }
};

}  // namespace footfall
