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
  int stages;           // the explicit first one included
  int order;            // of y(t + h)
  int estimated_order;  // q: the error estimate is O(h^(q + 1))
  double gamma;
  std::array<double, kMostStages> c;                           // times of the stages, in steps
  std::array<std::array<double, kMostStages>, kMostStages> a;  // below the diagonal; the last row is b
  std::array<double, kMostStages> error;                       // b - b^, b^ the embedded weights
  std::array<double, kMostStages> quartic;                     // d of the continuous extension (dense_step.h)
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

}  // namespace footfall
