#pragma once
// Disturbs inputs of tests in their last bits: FOOTFALL_LAST_BITS=K (1, 2, ...) in the environment multiplies each number by 1 or
// 1 +- 2^-52. What a test claims must not depend on it, as other processors and compilers differ by as much.

#include <cstdlib>
#include <random>

namespace footfall::test {

inline double last_bits(double x) {
  static const char* const seed = std::getenv("FOOTFALL_LAST_BITS");
  if (seed == nullptr) return x;
  static std::mt19937 random(static_cast<unsigned>(std::atoi(seed)));
  return x * (1.0 + 2.220446049250313e-16 * (static_cast<int>(random() % 3) - 1));
}

template <class Vector>
void disturb_last_bits(Vector& numbers) {
  for (auto& x : numbers) x = last_bits(x);
}

}  // namespace footfall::test
