// Rayleigh time and Hertz contact time.
#include "mbd_solver/scene/grain_time_step.h"

#include <cmath>

#include "mbd_solver/base/pi.h"

namespace footfall {

double rayleigh_time(const ElasticGrain& g) {
  const double shear = g.young / (2.0 * (1.0 + g.poisson));
  return kPi * g.radius * std::sqrt(g.density / shear) / (0.1631 * g.poisson + 0.8766);
}

double hertz_time(const ElasticGrain& g, double speed) {
  const double mass = 0.5 * g.density * 4.0 / 3.0 * kPi * g.radius * g.radius * g.radius;
  const double young = g.young / (2.0 * (1.0 - g.poisson * g.poisson));
  return 2.87 * std::pow(mass * mass / (0.5 * g.radius * young * young * speed), 0.2);
}

double rounded_down(double value) {
  constexpr double kRoundOff = 1e-9;  // 8.8e-5 remains 8.8e-5
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::floor(value / unit + kRoundOff) * unit;
}

}  // namespace footfall
