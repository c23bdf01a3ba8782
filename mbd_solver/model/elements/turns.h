// How an element that acts in an angle counts whole turns: an inner state z follows the angle, dz = q' + kFollow (q - z).
#pragma once

namespace footfall {

constexpr double kFollow = 10.0;  // [1/s]: the error of z as an integral fades within some 0.1 s

}  // namespace footfall
