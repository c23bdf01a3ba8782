// Intervals hold as often as they say: exactly, from the binomial distribution, or in many drawn campaigns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "mbd_solver/campaign/sampling.h"
#include "mbd_solver/campaign/statistics.h"
#include "tests/unit/campaign/drawn_parameters.h"

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
        const Probability& i = intervals[static_cast<std::size_t>(x)];
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
