#pragma once
// Wall-clock time. The clock is never set back; its zero has no meaning, so that only differences count.

#include <chrono>

namespace footfall {

// [s]
inline double wall_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace footfall
