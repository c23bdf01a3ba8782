// Intervals hold as often as they say: exactly, from the binomial distribution, or in many drawn campaigns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "mbd_solver/campaign/sampling.h"
#include "mbd_solver/campaign/statistics.h"

namespace footfall {
namespace {

double binomial(int hits, int trials, double p) {
  return std::exp(std::lgamma(trials + 1.0) - std::lgamma(hits + 1.0) - std::lgamma(trials - hits + 1.0) +
                  hits * std::log(p) + (trials - hits) * std::log1p(-p));
}

// Coverage of an interval, exactly: sum of P(X = x) over the x whose interval has p.
double coverage(int trials, double p, const std::function<bool(int)>& has) {
  double sum = 0.0;
  for (int x = 0; x <= trials; ++x)
    if (has(x)) sum += binomial(x, trials, p);
  return sum;
}

// Exact for 400 probabilities from n p = 0.05 to 1/2, and for 0.5, 5 and 50 %. The interval of Wilson has 84 % at n p = 0.18.
TEST(IntervalsOfAProbability, HoldInAtLeastNinetyFiveOfAHundredCampaignsWhateverItIs) {
  constexpr double kRoundOff = 1e-9;
  for (const int trials : {20, 60, 200, 400, 1000}) {
    std::vector<Probability> intervals;
    for (int x = 0; x <= trials; ++x) intervals.push_back(clopper_pearson(x, trials));
    std::vector<double> probabilities = {0.005, 0.05, 0.5};
    for (int k = 0; k < 400; ++k)
      probabilities.push_back(std::exp(std::log(0.05 / trials) + k / 400.0 * std::log(0.5 * trials / 0.05)));
    for (const double p : probabilities) {
      const double held = coverage(trials, p, [&](int x) {
        const Probability& i = intervals[x];
        return i.low <= p && p <= i.high;
      });
      EXPECT_GE(held, 0.95 - kRoundOff) << trials << " runs, p = " << p;
    }
  }
}

TEST(IntervalsOfAProbability, HaveABoundWhereNothingOrAllHappened) {
  EXPECT_EQ(clopper_pearson(0.0, 100.0).low, 0.0);
  EXPECT_NEAR(clopper_pearson(0.0, 100.0).high, 1.0 - std::pow(0.025, 0.01), 1e-12);
  EXPECT_EQ(clopper_pearson(100.0, 100.0).high, 1.0);
  EXPECT_EQ(clopper_pearson(0.0, 0.0).high, 1.0);
}

TEST(Tally, OfRunsThatDoNotTellHasTheBoundsOfAllTheirOutcomes) {
  Tally tally;
  for (int k = 0; k < 100; ++k) tally.add(k < 10 ? 1 : k < 95 ? 0 : -1);
  EXPECT_EQ(tally.runs(), 100);
  EXPECT_DOUBLE_EQ(tally.least(), 0.10);
  EXPECT_DOUBLE_EQ(tally.most(), 0.15);
  EXPECT_DOUBLE_EQ(tally.probability().value, 10.0 / 95.0);
  EXPECT_DOUBLE_EQ(tally.probability().low, clopper_pearson(10.0, 100.0).low);
  EXPECT_DOUBLE_EQ(tally.probability().high, clopper_pearson(15.0, 100.0).high);
}

// One-sided: P(p <= bound) is at least 95 %, exactly.
TEST(UpperBounds, HoldInAtLeastNinetyFiveOfAHundredCampaigns) {
  for (const int trials : {20, 100, 400})
    for (const double p : {0.001, 0.005, 0.02, 0.05, 0.2, 0.5, 0.9}) {
      const double held = coverage(trials, p, [&](int x) { return p <= upper_bound(x, trials); });
      EXPECT_GE(held, 0.95 - 1e-9) << trials << " runs, p = " << p;
    }
  EXPECT_NEAR(upper_bound(0.0, 100.0), 1.0 - std::pow(0.05, 0.01), 1e-12);
  EXPECT_EQ(upper_bound(7.0, 7.0), 1.0);
}

// log(0.05) / log(1 - p) without a hit: 59 and 299; 93 with one [Conover 1999, A6].
TEST(Statements, TakeThePublishedNumbersOfRuns) {
  EXPECT_EQ(runs_for(0.05, 0), 59);
  EXPECT_EQ(runs_for(0.05, 1), 93);
  EXPECT_EQ(runs_for(0.01, 0), 299);
  EXPECT_EQ(hits_allowed(0.05, 58), -1);
  EXPECT_EQ(hits_allowed(0.05, 59), 0);
  EXPECT_EQ(hits_allowed(0.05, 93), 1);
}

// A campaign that ends as soon as all intervals are narrow enough: counts decide when, so that the share of intervals that
// hold is found exactly, by the chance of every count at every look.
TEST(IntervalsOfAProbability, HoldInCampaignsThatEndEarly) {
  constexpr int kFirst = 60, kEvery = 20, kMost = 1000;
  constexpr double kWidth = 0.1;
  for (const double p : {0.005, 0.05, 0.2, 0.5}) {
    std::vector<double> chance = {1.0};  // of each count of hits, of campaigns that are not ended
    double held = 0.0;
    for (int runs = 1; runs <= kMost; ++runs) {
      chance.push_back(0.0);
      for (std::size_t x = chance.size() - 1; x > 0; --x) chance[x] = chance[x] * (1.0 - p) + chance[x - 1] * p;
      chance[0] *= 1.0 - p;
      if (runs != kMost && (runs < kFirst || runs % kEvery != 0)) continue;
      for (std::size_t x = 0; x < chance.size(); ++x) {
        const Probability interval = clopper_pearson(static_cast<double>(x), runs);
        if (interval.width() > kWidth && runs != kMost) continue;
        if (interval.low <= p && p <= interval.high) held += chance[x];
        chance[x] = 0.0;
      }
    }
    EXPECT_GE(held, 0.945) << p;  // looking costs up to half a percent
  }
}

// Wilks: 59 values have a 95/95 limit, 58 have none. Coverage exactly: the k-th of n values is above the quantile q when at
// most k - 1 values are below it.
TEST(ToleranceLimits, AreThoseOfWilks) {
  EXPECT_EQ(tolerance_place(58, 0.95), 58U);
  EXPECT_EQ(tolerance_place(59, 0.95), 58U);
  EXPECT_EQ(tolerance_place(92, 0.95), 91U);
  EXPECT_EQ(tolerance_place(93, 0.95), 91U);
  for (const int count : {59, 100, 200, 500}) {
    const auto place = static_cast<int>(tolerance_place(count, 0.95));
    EXPECT_GE(coverage(count, 0.95, [&](int below) { return below <= place; }), 0.95 - 1e-9) << count;
    EXPECT_LT(coverage(count, 0.95, [&](int below) { return below <= place - 1; }), 0.95) << count;
  }
}

// Exactly, over all counts of pairs: b with the outcome in the first case only, c in the second only.
TEST(PairedDifferences, HoldInNinetyFiveOfAHundredCampaigns) {
  for (const int runs : {50, 100, 300})
    for (const auto& [p_b, p_c] :
         {std::pair{0.05, 0.05}, {0.02, 0.1}, {0.2, 0.1}, {0.3, 0.3}, {0.5, 0.05}, {0.005, 0.05}}) {
      double held = 0.0;
      for (int b = 0; b <= runs; ++b) {
        const double of_b = binomial(b, runs, p_b);
        if (of_b < 1e-9) continue;
        for (int c = 0; c <= runs - b; ++c) {
          const PairTally tally{0, b, c, runs - b - c, 0};
          const Probability d = tally.difference();
          if (d.low <= p_c - p_b && p_c - p_b <= d.high) held += of_b * binomial(c, runs - b, p_c / (1.0 - p_b));
        }
      }
      EXPECT_GE(held, 0.94) << runs << " pairs, " << p_b << ", " << p_c;
    }
}

TEST(PairedDifferences, HaveTheChanceOfMcNemarAndAreWidenedByPairsThatDoNotTell) {
  PairTally tally;
  for (int k = 0; k < 100; ++k) tally.add(k < 2 || k >= 90 ? 1 : 0, k < 10 || k >= 95 ? 1 : 0);
  EXPECT_EQ(tally.both, 7);
  EXPECT_EQ(tally.first_only, 5);
  EXPECT_EQ(tally.second_only, 8);
  EXPECT_EQ(tally.neither, 80);
  EXPECT_NEAR(tally.chance(), 0.5811, 5e-5);  // 2 P(X <= 5) of 13 trials: 2 * 2380 / 8192
  const Probability known = tally.difference();
  EXPECT_NEAR(known.value, 0.03, 1e-12);
  for (int k = 0; k < 10; ++k) tally.add(-1, 0);
  EXPECT_LT(tally.difference().low, known.low - 0.05);
  EXPECT_GT(tally.difference().high, known.high + 0.05);
}

// P(a + b / 2 > t) of normal numbers is 1 - Phi(t / s), s^2 = 5/4: per deviation of a it moves by phi(t / s) / s, and per
// logarithm of that deviation by phi(t / s) t / s^3. 200 campaigns of 1000 runs; the deviation of a share of 95 % is 1.5 %.
TEST(SlopesOfAProbability, AreThoseOfTheClosedFormWithinTheirIntervals) {
  constexpr int kCampaigns = 200, kRuns = 1000;
  constexpr double kScatter = 0.031;
  const double s = std::sqrt(1.25);
  for (const double level : {0.0, 1.6449}) {  // 50 and 5 %
    const double density = std::exp(-0.5 * level * level) / std::sqrt(2.0 * 3.14159265358979) / s, t = level * s;
    double held[4] = {}, bias[4] = {};
    for (int seed = 1; seed <= kCampaigns; ++seed) {
      std::mt19937_64 engine(static_cast<std::uint64_t>(seed));
      std::normal_distribution<double> normally;
      Eigen::MatrixXd x(kRuns, 2);
      Eigen::VectorXd y(kRuns);
      for (Eigen::Index i = 0; i < kRuns; ++i) {
        x.row(i) << 3.0 + 2.0 * normally(engine), -1.0 + 0.1 * normally(engine);
        y[i] = (x(i, 0) - 3.0) / 2.0 + 0.5 * (x(i, 1) + 1.0) / 0.1 > t ? 1.0 : 0.0;
      }
      const MomentSlopes slopes = moment_slopes(x, y, {{3.0, 2.0}, {-1.0, 0.1}});
      ASSERT_EQ(slopes.of_mean.size(), 2U);
      const double exact[] = {density, 0.5 * density, density * t / (s * s), 0.25 * density * t / (s * s)};
      for (std::size_t k = 0; k < 4; ++k) {
        const Probability& p = k < 2 ? slopes.of_mean[k] : slopes.of_deviation[k - 2];
        held[k] += p.low <= exact[k] && exact[k] <= p.high ? 1.0 / kCampaigns : 0.0;
        bias[k] += (p.value - exact[k]) / kCampaigns;
      }
    }
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_GE(held[k], 0.95 - kScatter) << level << ' ' << k;
      EXPECT_NEAR(bias[k], 0.0, 0.01) << level << ' ' << k;  // its deviation is 0.02 over the root of 200
    }
  }
}

// Two models of a and b, each in -1 to 1, the better one with noise e of deviation 1.
struct TwoModels {
  const char* name;
  std::function<bool(double a, double b, double e)> better;
  std::function<bool(double a, double b)> cheap;
};

bool cheap_line(double a, double b) { return a + 0.5 * b > 0.9; }

const std::vector<TwoModels> kModels = {
    {"wavy boundary", [](double a, double b, double) { return a + 0.5 * b + 0.12 * std::sin(4.0 * b) > 0.9; },
     cheap_line},
    {"far off", [](double a, double b, double) { return a + 0.5 * b > 0.3; },
     [](double a, double b) { return a + 0.5 * b > 1.1; }},
    {"island", [](double a, double b, double) { return cheap_line(a, b) || std::hypot(a + 0.5, b) < 0.15; },
     cheap_line},
    {"2 % anywhere", [](double a, double b, double e) { return cheap_line(a, b) || e > 2.05; }, cheap_line},
    {"10 % anywhere", [](double a, double b, double e) { return cheap_line(a, b) || e > 1.28; }, cheap_line},
    {"15 % anywhere", [](double a, double b, double e) { return cheap_line(a, b) || e > 1.036; }, cheap_line},
    {"noise", [](double a, double b, double e) { return a + 0.5 * b + 0.15 * e > 0.0; },
     [](double a, double b) { return a + 0.5 * b > 0.03; }},
    {"hardly ever", [](double a, double b, double e) { return a + 0.5 * b > 1.1 || e > 1.645; },
     [](double a, double b) { return a + 0.5 * b > 1.48; }},
};

struct Campaigns {
  double held = 0.0, above = 0.0, bias = 0.0;  // shares of campaigns; above: the truth is above the interval
};

// 400 campaigns of 500 runs, of which `checked` are repeated with the better model.
Campaigns campaigns_of(const TwoModels& models, int checked, double far) {
  constexpr int kCampaigns = 400, kRuns = 500, kMany = 400000;
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniformly(-1.0, 1.0);
  std::normal_distribution<double> normally;
  double truth = 0.0;
  const auto draw = [&](double& a, double& b) { a = uniformly(engine), b = uniformly(engine); };
  double a = 0.0, b = 0.0;
  for (int i = 0; i < kMany; ++i) {
    draw(a, b);
    truth += models.better(a, b, normally(engine)) ? 1.0 / kMany : 0.0;
  }
  Campaigns result;
  for (int k = 0; k < kCampaigns; ++k) {
    std::vector<int> cheaply, better;
    Eigen::MatrixXd x(kRuns, 5);
    Eigen::VectorXd y(kRuns);
    for (Eigen::Index i = 0; i < kRuns; ++i) {
      draw(a, b);
      cheaply.push_back(models.cheap(a, b) ? 1 : 0);
      better.push_back(models.better(a, b, normally(engine)) ? 1 : 0);
      x.row(i) << 1.0, a, b, a * a, b * b;
      y[i] = cheaply.back();
    }
    const Logistic fit = fit_logistic(x, y);
    std::vector<double> weights;
    double sum = 0.0;
    for (Eigen::Index i = 0; i < kRuns; ++i) {
      const double p = fit.probability(x.row(i));
      weights.push_back(std::pow(p * (1.0 - p), 0.25));
      sum += weights.back();
    }
    for (double& w : weights) w = (1.0 - far) * w / sum + far / kRuns;
    const std::vector<GroupDraw> drawn_runs = draw_by_groups(weights, checked, static_cast<std::uint64_t>(k) + 1);
    std::vector<int> found;
    for (const GroupDraw& one : drawn_runs) found.push_back(better[one.run]);
    const Probability p = two_levels(cheaply, drawn_runs, found).corrected;
    result.held += p.low <= truth && truth <= p.high ? 1.0 / kCampaigns : 0.0;
    result.above += truth > p.high ? 1.0 / kCampaigns : 0.0;
    result.bias += (p.value - truth) / kCampaigns;
  }
  return result;
}

// Wherever the models differ. 95 % of 400 campaigns have a deviation of 1.1 %.
TEST(TwoLevelEstimate, HoldsInNinetyFiveOfAHundredCampaignsWhereverTheModelsDiffer) {
  constexpr double kScatter = 0.025, kBias = 0.012;  // the estimate: deviation of 0.1 over the root of 400, twice
  for (const TwoModels& models : kModels)
    for (const int checked : {20, 40}) {
      const Campaigns campaigns = campaigns_of(models, checked, BetterModelSpec::kFar);
      EXPECT_GE(campaigns.held, 0.95 - kScatter) << models.name << ", " << checked << " runs";
      EXPECT_LE(campaigns.above, 0.05 + kScatter) << models.name << ", " << checked << " runs";
      EXPECT_NEAR(campaigns.bias, 0.0, kBias) << models.name << ", " << checked << " runs";
    }
}

TEST(TwoLevelEstimate, IsWidenedByCheckedRunsWithoutResult) {
  std::vector<int> cheap(200, 0);
  std::fill(cheap.begin(), cheap.begin() + 40, 1);
  const std::vector<GroupDraw> checked = draw_by_groups(std::vector<double>(200, 1.0), 40, 1);
  std::vector<int> better;
  for (const GroupDraw& one : checked) better.push_back(cheap[one.run]);
  const Probability all = two_levels(cheap, checked, better).corrected;
  for (std::size_t g = 0; g < 10; ++g) better[g] = -1;
  const Probability some = two_levels(cheap, checked, better).corrected;
  EXPECT_LT(some.low, all.low);
  EXPECT_GT(some.high, all.high + 0.1);  // ten of forty might be missed
}

}  // namespace
}  // namespace footfall
