#pragma once
// The clock on the wall: never set back, its zero means nothing. Two readings make a duration.

#include <chrono>

namespace footfall {

// [s]
inline double wall_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace footfall
