#pragma once
// The model problem of a coupling: one body on one linear contact with a grain at rest, undamped, in units of the body's
// mass and of the window: m = 1, H = 1, so that K = (omega H)^2. theory 7.7.

#include <Eigen/Core>

namespace footfall {

class Scheme;

// z = [x, v, a (last acceleration sent), s (position of the boundary), p (its velocity)].
using MapState = Eigen::Matrix<double, 5, 1>;

struct PointMotion {
  double x = 0.0, v = 0.0;
};

// Exact solution after a time 1 of x'' = -K x - D v + f.
PointMotion exact_flow(double K, double D, double f, const PointMotion& start);

// Growth per window (theory 7.7): the spectral radius of the scheme's window map, which is linear in z. Above 1 the
// scheme creates energy.
double predicted_growth(const Scheme& scheme, double omega_h, int n);

}  // namespace footfall
