// Boundaries that are known: one where there is one, whatever the inputs are, and none where there are no runs.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "mbd_solver/campaign/boundary.h"

namespace footfall {
namespace {

using Point = Boundary::Point;
using Draw = std::function<Point(double, double)>;  // of two independent standard normal numbers
using Event = std::function<bool(double, double)>;

Boundary fitted(const Draw& draw, const Event& event, int runs, std::uint64_t seed, bool two = true) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normally;
  std::vector<Point> points;
  std::vector<int> happened;
  for (int i = 0; i < runs; ++i) {
    const double a = normally(engine), b = normally(engine);
    points.push_back(draw(a, b));
    if (!two) points.back()[1] = 0.0;
    happened.push_back(event(points.back()[0], points.back()[1]) ? 1 : 0);
  }
  return {points, happened, two, 0.5};
}

const Event kBelow = [](double x, double) { return x < 1.5; };
Draw correlated(double r) {
  return [r](double a, double b) { return Point{2.0 + 0.7 * a, r * a + std::sqrt(1.0 - r * r) * b}; };
}

// x is 2 with a deviation of 0.7: a fit of second degree has a second boundary near 3.3 in some campaigns, and with correlated
// inputs one in the corners where there are no runs.
TEST(Boundary, OfOneThresholdIsOneLineWhateverTheInputsAre) {
  constexpr double kNear = 0.3;  // of the spread of x: three times the distance of neighbouring runs at the threshold
  for (const double r : {0.0, 0.6, 0.9, 0.98})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Boundary boundary = fitted(correlated(r), kBelow, 300, seed);
      EXPECT_FALSE(boundary.curved());
      EXPECT_EQ(boundary.middle().size(), 1U) << "correlation " << r << ", seed " << seed;
      ASSERT_FALSE(boundary.crossings().empty());
      for (const Boundary::Crossing& at : boundary.crossings())
        EXPECT_NEAR(at.x, 1.5, kNear) << "correlation " << r << ", seed " << seed << ", y = " << at.y;
    }
}

TEST(Boundary, OfOneThresholdInOneNumberIsOnePoint) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Boundary::Crossing> at = fitted(correlated(0.0), kBelow, 200, seed, false).crossings();
    ASSERT_EQ(at.size(), 1U) << seed;
    EXPECT_NEAR(at[0].x, 1.5, 0.1) << seed;
  }
}

TEST(Boundary, ThatIsACircleIsCurvedAndHasBothOfItsSides) {
  const Event inside = [](double x, double y) { return x * x + y * y < 1.0; };
  const Draw square = [](double a, double b) { return Point{2.0 * std::erf(a), 2.0 * std::erf(b)}; };
  const Boundary boundary = fitted(square, inside, 400, 1);
  EXPECT_TRUE(boundary.curved());
  EXPECT_EQ(boundary.middle().size(), 2U);
  for (const Boundary::Crossing& at : boundary.crossings()) EXPECT_NEAR(std::hypot(at.x, at.y), 1.0, 0.25);
}

TEST(Boundary, OfFewerThanFiveRunsOnOneSideIsNotFitted) {
  EXPECT_FALSE(fitted(
                   correlated(0.0), [](double x, double) { return x < -9.0; }, 300, 1)
                   .fitted());
}

// The band of 95 %, of a threshold with noise, whose boundary is known: 200 campaigns.
TEST(Boundary, IsWithinItsBandInNinetyFiveOfAHundredCampaigns) {
  constexpr int kCampaigns = 200;
  constexpr double kScatter = 0.031;  // two deviations of a share of 95 % of 200
  int within = 0;
  for (std::uint64_t seed = 1; seed <= kCampaigns; ++seed) {
    // P(event | x) = 1 / (1 + exp(4 (x - 1.5))): a uniform number below it.
    std::mt19937_64 engine(seed + 1000);
    std::uniform_real_distribution<double> uniformly;
    const Event noisy = [&](double x, double) { return uniformly(engine) < 1.0 / (1.0 + std::exp(4.0 * (x - 1.5))); };
    const std::vector<Boundary::Crossing> at = fitted(correlated(0.0), noisy, 200, seed, false).crossings();
    within += at.size() == 1 && at[0].low <= 1.5 && 1.5 <= at[0].high ? 1 : 0;
  }
  EXPECT_GE(within, (0.95 - kScatter) * kCampaigns);
}

}  // namespace
}  // namespace footfall
