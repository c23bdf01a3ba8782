// Rare events with closed forms: of 1e-3 and 1e-4 with at most 2000 runs, in 2 to 10 inputs.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "mbd_solver/campaign/subset_search.h"

namespace footfall {
namespace {

using Numbers = std::vector<double>;

// The standard normal number with this share below it, by Newton's method.
double normal(double share) {
  double u = 0.0;
  for (int k = 0; k < 60; ++k) {  // some ten steps
    const double missing = share - 0.5 * std::erfc(-u / std::sqrt(2.0)),
                 density = std::exp(-0.5 * u * u) / 2.5066282746;
    u += std::max(-0.5, std::min(0.5, missing / std::max(density, 1e-12)));
    if (std::abs(missing) < 1e-14) break;
  }
  return u;
}

struct Rare {
  const char* name;
  std::size_t inputs;
  std::function<double(const Numbers&)> g;  // of standard normal numbers
  double threshold, exact;
};

double sum(const Numbers& u) {
  double all = 0.0;
  for (const double one : u) all += one;
  return all / std::sqrt(static_cast<double>(u.size()));
}

const std::vector<Rare> kEvents = {
    {"plane, 2", 2, sum, 3.719016, 1e-4},
    {"plane, 10", 10, sum, 3.719016, 1e-4},
    {"plane, 10, 1e-3", 10, sum, 3.090232, 1e-3},
    {"two sides", 3, [](const Numbers& u) { return std::abs(u[0]); }, 3.890592, 1e-4},
    {"corner", 2, [](const Numbers& u) { return std::min(u[0], u[1]); }, 2.326348, 1e-4},
};

TEST(SubsetSearch, FindsRareProbabilitiesOfClosedFormsWithTwoThousandRuns) {
  constexpr int kCampaigns = 200, kRuns = 2000;
  constexpr double kScatter = 0.031;  // two deviations of a share of 95 % of 200
  for (const Rare& event : kEvents) {
    double held = 0.0, mean = 0.0;
    for (std::uint64_t seed = 1; seed <= kCampaigns; ++seed) {
      SubsetSearch search(event.inputs, kRuns, event.threshold, seed);
      std::size_t runs = 0;
      for (std::vector<Numbers> points = search.next({}); !points.empty();) {
        Numbers values;
        for (Numbers& point : points) {
          for (double& one : point) one = normal(one);
          values.push_back(event.g(point));
        }
        runs += points.size();
        points = search.next(values);
      }
      EXPECT_LE(runs, static_cast<std::size_t>(kRuns));
      const RareProbability p = search.result();
      held += p.low <= event.exact && event.exact <= p.high ? 1.0 / kCampaigns : 0.0;
      mean += p.value / kCampaigns;
    }
    EXPECT_GE(held, 0.95 - kScatter) << event.name;
    EXPECT_NEAR(mean, event.exact, 0.15 * event.exact) << event.name;  // four deviations: 0.5 over the root of 200
  }
}

TEST(SubsetSearch, IsTheSameForTheSameSeedAndTakesNoNumberForTheEvent) {
  const auto of = [](std::uint64_t seed, double share_without) {
    SubsetSearch search(2, 500, 2.0, seed);
    std::vector<double> values;
    std::vector<Numbers> points = search.next({});
    for (std::size_t i = 0; i < points.size(); ++i)
      values.push_back(points[i][0] < share_without ? std::numeric_limits<double>::quiet_NaN() : 0.0);
    search.next(values);
    return std::pair{points, search.levels().front()};
  };
  EXPECT_EQ(of(1, 0.0).first, of(1, 0.0).first);
  EXPECT_NE(of(1, 0.0).first, of(2, 0.0).first);
  EXPECT_NEAR(of(1, 0.3).second.share, 0.3, 0.15);  // of 100 runs, three deviations
  EXPECT_EQ(of(1, 0.0).second.share, 0.0);
}

}  // namespace
}  // namespace footfall
