#include "mbd_solver/model/laws/monotone_curve.h"

#include "coupler/base/errors.h"
#include "tests/unit/laws/law_checks.h"

namespace footfall {
namespace {

using namespace law_checks;

TEST(MonotoneCurve, PassesThroughItsPointsAndNeverTurnsBetweenThem) {
  const std::vector<double> x{0.0, 0.1, 0.5, 0.55, 1.0}, y{0.0, 0.0, 10.0, 10.1, 10.1};
  const MonotoneCurve curve("test", x, y);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(curve.value(x[i]), y[i], 1e-14);
  for (int i = 0; i < 2000; ++i) EXPECT_LE(curve.value(i / 2000.0), curve.value((i + 1) / 2000.0) + 1e-14);
  EXPECT_EQ(curve.value(-1.0), 0.0);
  EXPECT_EQ(curve.value(2.0), 10.1);
}

TEST(MonotoneCurve, SlopeIsContinuousAndThatOfTheValue) {
  const MonotoneCurve curve("test", {0.0, 0.2, 0.5, 1.0}, {1.0, 2.0, 2.5, 7.0});
  for (double x : {0.05, 0.19, 0.3, 0.7, 0.99}) {
    const double h = 1e-6;  // the difference is exact to h^2
    EXPECT_NEAR(curve.slope(x), (curve.value(x + h) - curve.value(x - h)) / (2 * h), 1e-8);
  }
  for (double node : {0.2, 0.5}) EXPECT_NEAR(curve.slope(node - 1e-9), curve.slope(node + 1e-9), 1e-6);
  EXPECT_GT(curve.slope(0.0), 0.0);
  EXPECT_GT(curve.slope(1.0), 0.0);
}

TEST(MonotoneCurve, IsExactOnAStraightLine) {
  const MonotoneCurve curve("test", {0.0, 0.3, 1.0}, {2.0, 2.9, 5.0});
  for (double x : {0.1, 0.3, 0.77}) EXPECT_NEAR(curve.value(x), 2.0 + 3.0 * x, 1e-14);
}

TEST(MonotoneCurve, RefusesTablesThatDoNotRise) {
  EXPECT_THROW(MonotoneCurve("t", {0.0, 0.0}, {1.0, 2.0}), InputError);
  EXPECT_THROW(MonotoneCurve("t", {0.0}, {1.0}), InputError);
  EXPECT_THROW(MonotoneCurve("t", {0.0, 1.0}, {1.0}), InputError);
  EXPECT_THROW(MonotoneCurve("t", {0.0, 1.0}, {1.0, std::nan("")}), InputError);
}

}  // namespace
}  // namespace footfall
