#pragma once
// The simplest problem of a coupling: one body on one linear contact with a grain that stands, no damping, in units of
// the body's mass and of the window: m = 1, H = 1, so that K = (omega H)^2. theory 7.7.

#include <Eigen/Core>

namespace footfall {

class Scheme;

// z = [x, v, a (last acceleration sent), s (where the boundary stands), p (its velocity there)].
using MapState = Eigen::Matrix<double, 5, 1>;

struct PointMotion {
  double x = 0.0, v = 0.0;
};

// Exact solution after a time 1 of x'' = -K x - D v + f.
PointMotion exact_flow(double K, double D, double f, const PointMotion& start);

// Growth per window as theory 7.7 has it: the spectral radius of the scheme's window map, which is linear in z. Above 1 the scheme
// makes energy.
double predicted_growth(const Scheme& scheme, double omega_h, int n);

}  // namespace footfall
