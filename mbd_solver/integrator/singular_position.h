#pragma once
// When a mechanism comes to a singular position (theory 2.4), from the determinant of its saddle matrix at three times.
// Before such a position a place that is off by d puts the rates off by d over the square of the time left, however smooth
// the motion is: a step over it has to know where it is.

#include <array>

namespace footfall {

struct Nearness {
  double time = 0.0;             // [s]
  double log_determinant = 0.0;  // of the saddle matrix, with respect to any constant
};

// Its time [s]; infinity where none is to be expected within kAhead spans after the newest. Oldest first.
double singular_time(const std::array<Nearness, 3>& seen);

}  // namespace footfall
