// Sobol' indices of functions with known ones: with and without a mean, with interactions, and shifted.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/campaign/sampling.h"
#include "tests/unit/campaign/drawn_parameters.h"

namespace footfall {
namespace {

using Numbers = std::vector<double>;

struct KnownFunction {
  const char* name;
  std::function<double(const Numbers&)> f;
  Numbers first, total;
};

// Of three inputs, uniform in -1 to 1: variance 1/3 each, of a product of two 1/9, of sin(a) 1/2 - sin(2)/4 = 0.2727.
const std::vector<KnownFunction> kFunctions = {
    {"a + 2 b", [](const Numbers& v) { return v[0] + 2.0 * v[1]; }, {0.2, 0.8, 0.0}, {0.2, 0.8, 0.0}},
    {"a + 2 b + 3 c",
     [](const Numbers& v) { return v[0] + 2.0 * v[1] + 3.0 * v[2]; },
     {1.0 / 14.0, 4.0 / 14.0, 9.0 / 14.0},
     {1.0 / 14.0, 4.0 / 14.0, 9.0 / 14.0}},
    {"a b + c", [](const Numbers& v) { return v[0] * v[1] + v[2]; }, {0.0, 0.0, 0.75}, {0.25, 0.25, 0.75}},
    {"a b", [](const Numbers& v) { return v[0] * v[1]; }, {0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}},
    {"sin(a) + 0.3 b c",
     [](const Numbers& v) { return std::sin(v[0]) + 0.3 * v[1] * v[2]; },
     {0.9646, 0.0, 0.0},
     {0.9646, 0.0354, 0.0354}},
    // Ishigami and Homma 1990: sin x1 + a sin^2 x2 + b x3^4 sin x1 with x = pi v, a = 7, b = 0.1.
    {"Ishigami",
     [](const Numbers& v) {
       const double x1 = kPi * v[0], x2 = kPi * v[1], x3 = kPi * v[2];
       return std::sin(x1) + 7.0 * std::pow(std::sin(x2), 2) + 0.1 * std::pow(x3, 4) * std::sin(x1);
     },
     {0.3139, 0.4424, 0.0},
     {0.5576, 0.4424, 0.2437}},
};

// Of the function and what is added to it in each run.
Sensitivity sensitivity_of(const KnownFunction& known, const std::function<double()>& added, int seed, int runs,
                           Design design = Design::kLatinHypercube) {
  const Draws draws(
      drawn_sweep({uniform("a", -1.0, 1.0), uniform("b", -1.0, 1.0), uniform("c", -1.0, 1.0)}, runs, design, seed));
  std::vector<Numbers> x;
  Numbers y;
  for (std::size_t i = 0; i < draws.count(); ++i) {
    x.push_back(draws.positions(i));
    y.push_back(known.f(draws.values(i)) + added());
  }
  return sobol_indices(x, y);
}

// Polynomials are exact; of Ishigami's function the published numbers are met to two hundredths.
TEST(SensitivityOf, FunctionsWithKnownIndicesIsTheirs) {
  constexpr double kOfPolynomials = 0.02;
  for (const KnownFunction& known : kFunctions)
    for (const int seed : {1, 2}) {
      const Sensitivity s = sensitivity_of(
          known, [] { return 0.0; }, seed, 1000);
      ASSERT_EQ(s.total.size(), 3U);
      EXPECT_GT(s.explained, 0.98) << known.name;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(s.first[k], known.first[k], kOfPolynomials) << known.name << ' ' << k;
        EXPECT_NEAR(s.total[k], known.total[k], kOfPolynomials) << known.name << ' ' << k;
      }
    }
}

// A constant has no variance. Round-off: the constant is 1e4 times the function.
TEST(SensitivityOf, AFunctionAndOneWithAConstantAddedIsTheSame) {
  constexpr double kRoundOff = 1e-6;
  for (const KnownFunction& known : kFunctions) {
    const Sensitivity s = sensitivity_of(
        known, [] { return 0.0; }, 1, 300);
    for (const double shift : {-1.0, 1e4}) {
      const Sensitivity shifted = sensitivity_of(
          known, [&] { return shift; }, 1, 300);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(shifted.first[k], s.first[k], kRoundOff) << known.name << ' ' << shift;
        EXPECT_NEAR(shifted.total[k], s.total[k], kRoundOff) << known.name << ' ' << shift;
      }
    }
  }
}

// With a noise of a tenth of the variance, which no input explains: indices over the whole variance. 100 campaigns of 200 runs;
// an index that is 0 is within its interval when that begins at 0.
TEST(SensitivityOf, FunctionsWithNoiseIsWithinItsIntervals) {
  constexpr int kCampaigns = 100, kRuns = 200;
  constexpr double kShare = 0.1, kScatter = 0.045;  // two deviations of a share of 95 % of 100
  const double variances[] = {5.0 / 3.0, 14.0 / 3.0, 4.0 / 9.0};
  for (const std::size_t f : {0, 1, 2}) {
    const KnownFunction& known = kFunctions[f];
    double held[2][3] = {};
    for (int seed = 1; seed <= kCampaigns; ++seed) {
      std::mt19937_64 engine(static_cast<std::uint64_t>(seed));
      std::normal_distribution<double> noise(0.0, std::sqrt(variances[f] * kShare / (1.0 - kShare)));
      const Sensitivity s = sensitivity_of(
          known, [&] { return noise(engine); }, seed, kRuns, Design::kRandom);
      for (std::size_t k = 0; k < 3; ++k) {
        const double first = (1.0 - kShare) * known.first[k], total = (1.0 - kShare) * known.total[k];
        held[0][k] += s.first_interval[k].first <= first && first <= s.first_interval[k].second;
        held[1][k] += s.total_interval[k].first <= total && total <= s.total_interval[k].second;
      }
    }
    for (const int kind : {0, 1})
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_GE(held[kind][k] / kCampaigns, 0.95 - kScatter) << known.name << ' ' << kind << ' ' << k;
  }
}

}  // namespace
}  // namespace footfall
