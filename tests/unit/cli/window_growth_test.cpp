// mbd_solver/cli/experiments/window_growth.h: growth per window from the values of a motion.
#include <gtest/gtest.h>

#include <cmath>

#include "mbd_solver/cli/experiments/window_growth.h"

namespace footfall {
namespace {

std::vector<double> sampled(int count, double (*f)(int)) {
  std::vector<double> v;
  for (int k = 0; k < count; ++k) v.push_back(f(k));
  return v;
}

TEST(GrowthOfSeries, OscillationThatNeitherGrowsNorDecays) {
  EXPECT_NEAR(growth_of_series(sampled(200, [](int k) { return std::cos(0.3 * k + 0.1); })), 1.0, 1e-9);
}

TEST(GrowthOfSeries, OscillationThatDecaysAlthoughItPassesThroughZero) {
  EXPECT_NEAR(growth_of_series(sampled(60, [](int k) { return std::pow(0.8, k) * std::cos(1.3 * k); })), 0.8, 1e-9);
}

TEST(GrowthOfSeries, AlternatingGrowthBesideADecayingPart) {
  EXPECT_NEAR(growth_of_series(sampled(6, [](int k) { return std::pow(-97.0, k) + 5.0 * std::pow(0.5, k); })), 97.0,
              1e-3);
}

TEST(GrowthOfSeries, TooShortAMotionTellsNothing) { EXPECT_TRUE(std::isnan(growth_of_series({1.0, 2.0, 4.0}))); }

}  // namespace
}  // namespace footfall
