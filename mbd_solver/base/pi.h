#pragma once
// The circle's circumference over its diameter.

namespace footfall {

inline constexpr double kPi = 3.14159265358979323846;

}  // namespace footfall
