#pragma once
// Coefficients of a diagonally implicit Runge-Kutta method whose first stage is explicit (ESDIRK), L-stable and stiffly
// accurate: the last stage is the new state, and its rates are the first rates of the next step.
//   Y_i = y + h sum_j a_ij K_j,  a_ii = gamma for i > 0,  a_last,j = b_j,  y(t + h) = Y_last

#include <array>
#include <string_view>

namespace footfall {

constexpr int kMostStages = 7;

struct Tableau {
  std::string_view name;
  int stages;           // including the explicit first one
  int order;            // of y(t + h)
  int estimated_order;  // q: the error estimate is O(h^(q + 1))
  double gamma;
  std::array<double, kMostStages> c;                           // times of the stages, in steps
  std::array<std::array<double, kMostStages>, kMostStages> a;  // below the diagonal; the last row is b
  std::array<double, kMostStages> error;                       // b - b^, b^ the embedded weights
  std::array<double, kMostStages> quartic;                     // d of the continuous extension (DenseWeights)
  int last() const { return stages - 1; }
};

// Second order, three stages (Hosea and Shampine 1996).
const Tableau& tr_bdf2();
// Third order, four stages: the implicit part of ARK3(2)4L[2]SA (Kennedy and Carpenter 2003).
const Tableau& esdirk3();
// Fifth order, seven stages: ESDIRK5(4)7L[2]SA2 (Kennedy and Carpenter 2019).
const Tableau& esdirk5();
// 2, 3 or 5.
const Tableau& tableau_of_order(int order);

// Continuous extension: states within a step from its ends and stages, without another solve. theta in [0, 1]:
//   x(theta)  = x_0 + h sum_i b_i(theta) K_i        x: q, v, z and the time integrals of powers
//   x'(theta) = sum_i b_i'(theta) K_i               also the multipliers, which are part of K
//   b_i(theta) = theta^2 (3 - 2 theta) b_i + theta (1 - theta)^2 [i = 0] - theta^2 (1 - theta) [i = last]
//              + theta^2 (1 - theta)^2 d_i
// Hermite's cubic through both ends, and a bubble that makes it exact to fourth order:
//   sum d = sum d c = sum d c^2 = 0,  sum d c^3 = 1/4,  sum_ij d_i a_ij c_j^2 = 1/12      d of smallest norm
// The error of x is O(h^5), of the size of the error estimate, and O(h^4) if d = 0 (TR-BDF2, whose steps have errors of
// O(h^3)). x and x' are continuous from step to step.
struct DenseWeights {
  DenseWeights(const Tableau& tableau, double theta) {
    const double rest = 1.0 - theta;
    const std::size_t last = static_cast<std::size_t>(tableau.last());
    for (std::size_t i = 0; i <= last; ++i) {
      const double b_i = i < last ? tableau.a[last][i] : tableau.gamma, d_i = tableau.quartic[i];
      b[i] = theta * theta * ((3.0 - 2.0 * theta) * b_i + rest * rest * d_i);
      slope[i] = 2.0 * theta * rest * (3.0 * b_i + (1.0 - 2.0 * theta) * d_i);
    }
    b[0] += theta * rest * rest;
    slope[0] += rest * (1.0 - 3.0 * theta);
    b[last] -= theta * theta * rest;
    slope[last] += theta * (3.0 * theta - 2.0);
  }
  std::array<double, kMostStages> b{}, slope{};
};

// Lagrange polynomial k through the first `count` of `nodes`, at theta.
template <std::size_t kSize>
double lagrange(const std::array<double, kSize>& nodes, std::size_t count, std::size_t k, double theta) {
  double value = 1.0;
  for (std::size_t j = 0; j < count; ++j)
    if (j != k) value *= (theta - nodes[j]) / (nodes[k] - nodes[j]);
  return value;
}

}  // namespace footfall
