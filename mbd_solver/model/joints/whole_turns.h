#pragma once
// An angle that goes on over any number of turns. A state z only tells how many whole turns there are; theory 3.6.
//   q = alpha + 2 pi round((z - alpha) / 2 pi),  z' = q' + kTurnFollow (q - z),  z = 0 at the start,  alpha in (-pi, pi]

#include <cmath>

#include "coupler/base/pi.h"

namespace footfall {

constexpr double kTurnFollow = 10.0;  // [1/s]: the error of z as an integral fades within some 0.1 s

inline double nearest_turn(double alpha, double z) { return alpha + 2.0 * kPi * std::round((z - alpha) / (2.0 * kPi)); }
inline double turn_counter_rate(double rate, double q, double z) { return rate + kTurnFollow * (q - z); }

}  // namespace footfall
