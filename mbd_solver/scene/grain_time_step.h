#pragma once
// Times that limit the time step of grains: theory 5.

namespace footfall {

struct ElasticGrain {
  double radius;   // r [m]
  double density;  // rho [kg/m3]
  double young;    // E [Pa]
  double poisson;  // nu [-]
};

// Rayleigh time of a grain [s]:
//   pi r sqrt(rho / G) / (0.1631 nu + 0.8766),  G = E / (2 (1 + nu))
double rayleigh_time(const ElasticGrain& grain);

// Duration of a Hertz contact of two equal grains at the impact speed `speed` [m/s] > 0 [s]:
//   2.87 (m*^2 / (r* E*^2 speed))^(1/5),  m* = m / 2, r* = r / 2, E* = E / (2 (1 - nu^2))
double hertz_time(const ElasticGrain& grain, double speed);

// The value > 0 rounded down to two digits: 8.84e-5 -> 8.8e-5.
double rounded_down(double value);

}  // namespace footfall
