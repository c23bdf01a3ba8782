#include "mbd_solver/model/controllers/acceleration_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

constexpr double kTwoPi = 6.28318530717958647692;

TEST(AccelerationFilter, StepResponseIsThatOfTheAnalogueFilter) {
  const double f = 50.0, T = 1e-3;
  AccelerationFilter filter("test", f, T);
  filter.sample(0.0);
  for (int k = 1; k <= 40; ++k) {
    filter.sample(10.0);
    EXPECT_NEAR(filter.acceleration(), 10.0 * (1.0 - std::exp(-kTwoPi * f * T * k)), 1e-12);
  }
}

TEST(AccelerationFilter, StartsAtTheFirstSampleWithoutJerk) {
  AccelerationFilter filter("test", 50.0, 1e-3);
  filter.sample(-1.63);
  EXPECT_EQ(filter.acceleration(), -1.63);
  EXPECT_EQ(filter.jerk(), 0.0);
}

// A ramp of slope s: y lags by the constant s T (1 - g) / g, g = 1 - exp(-2 pi f T), and the jerk is s. For T
// -> 0 the lag time is the 1 / (2 pi f) of the analogue filter.
TEST(AccelerationFilter, FollowsARampWithItsLagAndGivesItsSlope) {
  const double slope = 400.0, f = 50.0;
  for (double T : {1e-3, 1e-4}) {
    AccelerationFilter filter("test", f, T);
    double a = 0.0;
    for (int k = 0; k * T < 0.2; ++k) filter.sample(a = slope * k * T);
    const double g = 1.0 - std::exp(-kTwoPi * f * T);
    EXPECT_NEAR(a - filter.acceleration(), slope * T * (1.0 - g) / g, 1e-9);
    EXPECT_NEAR((a - filter.acceleration()) / slope, 1.0 / (kTwoPi * f), 0.5 * T + 1e-5);
    EXPECT_NEAR(filter.jerk(), slope, 1e-9);
  }
}

TEST(AccelerationFilter, FrequencyZeroPassesEverything) {
  AccelerationFilter filter("test", 0.0, 1e-3);
  filter.sample(1.0);
  filter.sample(3.0);
  EXPECT_EQ(filter.acceleration(), 3.0);
  EXPECT_EQ(filter.jerk(), 2000.0);
}

TEST(AccelerationFilter, ContinuesToTheBitAfterRestore) {
  AccelerationFilter one("test", 50.0, 1e-3), two("test", 50.0, 1e-3);
  one.sample(3.0);
  one.sample(7.0);
  Eigen::VectorXd memory(AccelerationFilter::kMemory);
  one.save(memory);
  two.restore(memory);
  EXPECT_EQ(two.jerk(), one.jerk());
  one.sample(-2.0);
  two.sample(-2.0);
  EXPECT_EQ(one.acceleration(), two.acceleration());
  EXPECT_EQ(one.jerk(), two.jerk());
}

TEST(AccelerationFilter, RefusesNonsense) {
  EXPECT_THROW(AccelerationFilter("test", -1.0, 1e-3), InputError);
  EXPECT_THROW(AccelerationFilter("test", 50.0, 0.0), InputError);
}

}  // namespace
}  // namespace footfall
