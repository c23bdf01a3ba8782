#include "liggghts_fix/beam_hertz.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace footfall {
namespace {

// Hertz' elliptic contact [Johnson 1985, 4.2], exact: semi-axes a > b of the patch, e^2 = 1 - (b/a)^2, curvatures 1/r
// along the beam and 1/rho across, K and E complete elliptic integrals, P = 3 F / (4 pi E*):
//   r / rho = ((a/b)^2 E - K) / (K - E),   a^3 = 4 r P (K - E) / e^2,   overlap = 2 P K / a
double exact(double r, double R) {
  const double wanted = 1.0 + r / R;  // r / rho
  const auto ratio = [](double k) {   // k = b / a
    const double e = std::sqrt(1.0 - k * k), K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
    return (E / (k * k) - K) / (K - E);
  };
  double low = 1e-4, high = 1.0 - 1e-6;
  for (int i = 0; i < 200; ++i) {
    const double k = 0.5 * (low + high);
    (ratio(k) > wanted ? low : high) = k;
  }
  const double k = low, e = std::sqrt(1.0 - k * k), K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
  const double a = std::cbrt(4.0 * r * (K - E) / (e * e)), overlap = 2.0 * K / a;  // at P = 1
  const double F = 4.0 * M_PI / 3.0;                                               // of E* = 1
  return F / (4.0 / 3.0 * std::sqrt(r) * std::pow(overlap, 1.5));
}

TEST(BeamHertz, IsHertzOnAPlaneForAThickBeam) {
  EXPECT_NEAR(hertz_on_side(0.02, 1e6), 1.0, 1e-6);
  EXPECT_NEAR(hertz_on_end(0.02, 1e6), 1.0, 1e-6);
}

TEST(BeamHertz, IsHertzEllipticContactOnTheSide) {
  double worst = 0.0;
  for (const double R : {50.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.02}) {
    const double error = hertz_on_side(1.0, R) / exact(1.0, R) - 1.0;
    std::printf("R / r %g: share %.5f, error %.2g\n", R, exact(1.0, R), error);
    worst = std::max(worst, std::abs(error));
  }
  EXPECT_LT(worst, 0.006);  // of the closed form
}

TEST(BeamHertz, IsTwoSpheresAtTheEnd) { EXPECT_NEAR(hertz_on_end(0.02, 0.02), std::sqrt(0.5), 1e-15); }

}  // namespace
}  // namespace footfall
