#pragma once
// The model problem of a coupling: one body on one linear contact with a grain at rest, undamped, in units of the body's
// mass and of the window: m = 1, H = 1, so that K = (omega H)^2. theory 7.7.

#include <Eigen/Core>
#include <vector>

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

// Largest omega H, at most `most`, up to which a contact that closes and opens again, half an oscillation of pi / omega H windows,
// gains no more than `gain` of its energy [-]: growth^(2 pi / omega H) <= 1 + gain.
double largest_omega_h(const Scheme& scheme, int n, double gain, double most = 2.0);

// The limit of omega H in windows of n DEM steps: the user's limit, or the lower limit that the energy gain kContactGain sets.
class OmegaHLimit {
 public:
  static constexpr double kContactGain = 0.02;  // [-]

  // The scheme must outlive this. given: of the user.
  OmegaHLimit(const Scheme& scheme, double given) : scheme_(&scheme), given_(given) {}
  double at(int n);
  // The largest n, at least 1, with omega n dt <= share at(n). omega_dt: of one DEM step.
  int substeps(double omega_dt, int most, double share = 1.0);

 private:
  const Scheme* scheme_;
  double given_;
  std::vector<double> known_;  // by n; 0: not computed yet
};

}  // namespace footfall
