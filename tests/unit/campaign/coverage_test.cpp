// Every interval that a campaign prints, in 200 drawn campaigns each: how often it has the true number. Prints the table of
// docs/data/coverage.txt (remake/coverage.sh). Shares of 95 % of 200 scatter by 1.5 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "mbd_solver/campaign/sampling.h"
#include "mbd_solver/campaign/statistics.h"
#include "tests/unit/campaign/drawn_parameters.h"

namespace footfall {
namespace coverage {  // its functions have names of other tests

using Numbers = std::vector<double>;

constexpr int kCampaigns = 200, kRuns = 200;
constexpr double kLeast = 0.95 - 3.0 * 0.0154;  // of a claim of 95 %, three deviations
const Numbers kProbabilities = {0.005, 0.05, 0.5};

// Counts how often an interval holds, and its mean width.
class Row {
 public:
  Row(std::string interval, std::string of) : interval_(std::move(interval)), of_(std::move(of)) {}
  void add(double low, double truth, double high) {
    held_ += low <= truth && truth <= high ? 1 : 0;
    width_ += (high - low) / kCampaigns;
  }
  ~Row() {
    char width[32] = "-";  // of one side
    if (std::isfinite(width_)) std::snprintf(width, sizeof width, "%.3g", width_);
    std::printf("| %s | %s | %.1f | %s |\n", interval_.c_str(), of_.c_str(), 100.0 * held_ / kCampaigns, width);
    EXPECT_GE(static_cast<double>(held_) / kCampaigns, kLeast) << interval_ << ", " << of_;
  }

 private:
  std::string interval_, of_;
  int held_ = 0;
  double width_ = 0.0;
};

std::string percent(double p) {
  char text[32];
  std::snprintf(text, sizeof text, "%g %%", 100.0 * p);
  return text;
}

std::mt19937_64 engine_of(int campaign) { return std::mt19937_64(static_cast<std::uint64_t>(campaign + 1)); }

// An exponential number: skewed, and with known quantiles -log(1 - share).
Numbers sorted_exponentials(std::mt19937_64& engine) {
  std::exponential_distribution<double> draw(1.0);
  Numbers values(kRuns);
  for (double& value : values) value = draw(engine);
  std::sort(values.begin(), values.end());
  return values;
}

TEST(CoverageOf, ProbabilitiesAndTheirBounds) {
  for (const double p : kProbabilities) {
    Row two_sided("probability", percent(p)), bound("at most, one-sided", percent(p)),
        unknown("probability, a tenth of the runs without result", percent(p));
    for (int k = 0; k < kCampaigns; ++k) {
      std::mt19937_64 engine = engine_of(k);
      std::uniform_real_distribution<double> draw;
      Tally all, some;
      for (int i = 0; i < kRuns; ++i) {
        const int outcome = draw(engine) < p ? 1 : 0;
        all.add(outcome);
        some.add(i % 10 == 0 ? -1 : outcome);
      }
      const Probability found = all.probability(), part = some.probability();
      two_sided.add(found.low, p, found.high);
      bound.add(0.0, p, upper_bound(static_cast<double>(all.hits), kRuns));
      unknown.add(part.low, p, part.high);
    }
  }
}

TEST(CoverageOf, QuantilesAndToleranceLimits) {
  for (const double share : {0.05, 0.5, 0.95, 0.99}) {
    Row row("percentile", percent(share));
    for (int k = 0; k < kCampaigns; ++k) {
      std::mt19937_64 engine = engine_of(k);
      const Numbers values = sorted_exponentials(engine);
      const auto [low, high] = quantile_bounds(kRuns, share);
      row.add(low < 0 ? 0.0 : values[low], -std::log1p(-share), high >= kRuns ? HUGE_VAL : values[high]);
    }
  }
  Row above("tolerance limit: 95 % of the runs are below", "95 %"), below("tolerance limit: 95 % are above", "95 %");
  const std::size_t place = tolerance_place(kRuns, kToleranceShare);
  for (int k = 0; k < kCampaigns; ++k) {
    std::mt19937_64 engine = engine_of(k);
    const Numbers values = sorted_exponentials(engine);
    above.add(0.0, -std::log1p(-kToleranceShare), values[place]);
    below.add(values[kRuns - 1 - place], -std::log(kToleranceShare), HUGE_VAL);
  }
}

// Both cases read the same draws: half of what decides is common to them.
TEST(CoverageOf, PairedDifferences) {
  for (const double p : kProbabilities) {
    const double second = p < 0.5 ? 2.0 * p : 0.6;
    Row row("difference of two cases, " + percent(second) + " less", percent(p));
    for (int k = 0; k < kCampaigns; ++k) {
      std::mt19937_64 engine = engine_of(k);
      std::uniform_real_distribution<double> draw;
      PairTally pairs;
      for (int i = 0; i < kRuns; ++i) {
        const double common = draw(engine), own = draw(engine);
        const bool alike = draw(engine) < 0.5;
        pairs.add(common < p ? 1 : 0, (alike ? common : own) < second ? 1 : 0);
      }
      const Probability difference = pairs.difference();
      row.add(difference.low, second - p, difference.high);
    }
  }
  Row row("median of the differences of a figure", "0.3");
  for (int k = 0; k < kCampaigns; ++k) {
    std::mt19937_64 engine = engine_of(k);
    std::normal_distribution<double> draw;
    Numbers differences;
    for (int i = 0; i < kRuns; ++i) differences.push_back(0.3 + draw(engine) - 0.5 * draw(engine));
    std::sort(differences.begin(), differences.end());
    const auto [low, high] = quantile_bounds(kRuns, 0.5);
    row.add(differences[low], 0.3, differences[high]);
  }
}

// y = a + 2 b + a c and a noise that nothing explains: of three inputs uniform in -1 to 1 the variances are 1/3, 4/3, 1/9. With
// more noise a campaign has rank correlations instead.
TEST(CoverageOf, SobolIndices) {
  for (const double noise : {0.01, 0.1, 0.15}) {  // share of the variance
    const double explained = 1.0 / 3.0 + 4.0 / 3.0 + 1.0 / 9.0, all = explained / (1.0 - noise);
    const Numbers first = {1.0 / 3.0 / all, 4.0 / 3.0 / all, 0.0},
                  total = {4.0 / 9.0 / all, 4.0 / 3.0 / all, 1.0 / 9.0 / all};
    std::vector<std::vector<std::pair<double, double>>> alone, with;
    for (int k = 0; k < kCampaigns; ++k) {
      std::mt19937_64 engine = engine_of(k);
      std::normal_distribution<double> draw(0.0, std::sqrt(noise * all));
      const Draws draws(drawn_sweep({uniform("a", -1.0, 1.0), uniform("b", -1.0, 1.0), uniform("c", -1.0, 1.0)}, kRuns,
                                    Design::kRandom, k + 1));
      std::vector<Numbers> x;
      Numbers y;
      for (std::size_t i = 0; i < draws.count(); ++i) {
        const Numbers& v = draws.values(i);
        x.push_back(draws.positions(i));
        y.push_back(v[0] + 2.0 * v[1] + v[0] * v[2] + draw(engine));
      }
      const Sensitivity s = sobol_indices(x, y);
      alone.push_back(s.first_interval);
      with.push_back(s.total_interval);
    }
    const std::string share = ", noise of " + percent(noise);
    for (std::size_t j = 0; j < 3; ++j) {
      Row one("Sobol' index of input " + std::to_string(j + 1) + ", alone" + share, percent(first[j]));
      for (const auto& intervals : alone) one.add(intervals[j].first, first[j], intervals[j].second);
      Row both("Sobol' index of input " + std::to_string(j + 1) + ", with interactions" + share, percent(total[j]));
      for (const auto& intervals : with) both.add(intervals[j].first, total[j], intervals[j].second);
    }
  }
}

}  // namespace coverage
}  // namespace footfall
