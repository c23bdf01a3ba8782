#pragma once
// Resistive force theory of dry granular media, with its printed coefficients: see rft_rig.cpp.

namespace footfall {

// Stress per depth along x and z, of generic media at scalar one [N/cm^3]. Positive against a motion along +x, and
// upwards.
struct RftAlpha {
  double z = 0.0, x = 0.0;
};
// beta, gamma in [-pi/2, pi/2] [rad]: of the plate to the horizontal, of the motion below the horizontal.
RftAlpha rft_alpha(double beta, double gamma);

// The mu in (0, 2] at which 3D-RFT's xi = weight (894 mu^3 - 386 mu^2 + 89 mu) is `xi`, weight = rho g [N/m^3]; NaN: none.
double friction_of_xi(double xi, double weight);

}  // namespace footfall
