// mbd_solver/model/laws/cubic_spline.h

#include "mbd_solver/model/laws/cubic_spline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"

namespace footfall {
namespace {

CubicSpline spline_of_cosine(int pieces) {
  std::vector<double> x, y;
  for (int i = 0; i <= pieces; ++i) {
    x.push_back(0.3 + 2.0 * kPi * i / pieces);
    y.push_back(i == pieces ? y.front() : std::cos(x.back()));
  }
  return CubicSpline("cosine", x, y, CubicSpline::Ends::kClosed);
}

double largest_error(const CubicSpline& spline) {
  double worst = 0.0;
  for (double x = -20.0; x < 20.0; x += 0.0137) worst = std::max(worst, std::abs(spline.at(x).value - std::cos(x)));
  return worst;
}

TEST(CubicSpline, ThatIsClosedIsOfFourthOrderOverAllTurns) {
  const double coarse = largest_error(spline_of_cosine(20)), fine = largest_error(spline_of_cosine(40));
  EXPECT_LT(fine, 1e-5);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.2);
}

TEST(CubicSpline, HasTheDerivativesOfItsValueAndGoesOnThroughTheSeam) {
  const CubicSpline closed = spline_of_cosine(12);
  const CubicSpline natural("n", {-1.0, 0.2, 0.5, 2.0}, {0.3, -1.0, 0.4, 0.1});
  const double h = 1e-5;
  for (const CubicSpline* spline : {&closed, &natural})
    for (double x = -3.01; x < 9.0; x += 0.0731) {
      const CubicSpline::Value before = spline->at(x - h), at = spline->at(x), after = spline->at(x + h);
      EXPECT_NEAR((after.value - before.value) / (2.0 * h), at.slope, 1e-8) << x;
      EXPECT_NEAR((after.slope - before.slope) / (2.0 * h), at.curvature, 2e-4) << x;
      if (before.third == after.third) {
        EXPECT_NEAR((after.curvature - before.curvature) / (2.0 * h), at.third, 1e-5) << x;
      }
    }
  const CubicSpline::Value left = closed.at(0.3 - 1e-9), right = closed.at(0.3 + 1e-9);
  EXPECT_NEAR(left.slope, right.slope, 1e-8);
  EXPECT_NEAR(left.curvature, right.curvature, 1e-7);
}

TEST(CubicSpline, RefusesPlacesThatDoNotRise) {
  EXPECT_THROW(CubicSpline("c", {0.0, 1.0, 1.0}, {0.0, 1.0, 2.0}), InputError);
  EXPECT_THROW(CubicSpline("c", {0.0}, {0.0}), InputError);
}

}  // namespace
}  // namespace footfall
