// How far targets determine parameters: mbd_solver/cli/calibrate/determination.h, on models that are formulas.
#include "mbd_solver/cli/calibrate/determination.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "mbd_solver/cli/calibrate/gauss_newton.h"

namespace footfall {
namespace {

using Model = std::function<std::vector<double>(const std::vector<double>&)>;  // parameters -> y of the targets

CalibrationSpec spec_of(std::size_t parameters, const std::vector<double>& wanted, double tolerance) {
  CalibrationSpec spec;
  spec.step = 0.02;
  for (std::size_t i = 0; i < parameters; ++i) {
    SoughtParameter p;
    p.name = "p" + std::to_string(i);
    p.least = 1.0;
    p.most = 10.0;
    p.scale = i % 2 == 0 ? RangeScale::kLogarithmic : RangeScale::kLinear;
    spec.parameters.push_back(p);
  }
  for (const double y : wanted) {
    TargetSpec t;
    t.value = y;
    t.tolerance = tolerance;
    spec.targets.push_back(t);
  }
  return spec;
}

Evaluation evaluated(const CalibrationSpec& spec, const Model& model, const Shares& shares) {
  std::vector<double> p;
  for (std::size_t i = 0; i < shares.size(); ++i) p.push_back(spec.parameters[i].value(shares[i]));
  const std::vector<double> y = model(p);
  Evaluation e;
  e.shares = shares;
  for (std::size_t t = 0; t < y.size(); ++t) {
    TargetResult r;
    r.values = {y[t]};
    r.spread = {0.0};
    r.residuals = {residual_of(spec.targets[t], y[t])};
    e.targets.push_back(r);
    e.misfit += r.misfit(spec.targets[t]);
  }
  return e;
}

Determination determined(const CalibrationSpec& spec, const Model& model, const Shares& best) {
  std::vector<Evaluation> sets;
  for (const Shares& set : difference_sets(spec, best)) sets.push_back(evaluated(spec, model, set));
  std::vector<const Evaluation*> around;
  for (const Evaluation& e : sets) around.push_back(&e);
  return determination_of(spec, evaluated(spec, model, best), around);
}

Shares least_misfit(const CalibrationSpec& spec, const Model& model) {
  LeastSquaresQuestions squares;
  squares.may_go_on = [](const Shares&) { return true; };
  squares.residuals = [&](const Shares& u) { return evaluated(spec, model, u).residuals(spec); };
  StageSpec stage;
  stage.method = SearchMethod::kGaussNewton;
  stage.evaluations = 500;
  return walk_least_squares(stage, Shares(spec.parameters.size(), 0.5), spec.step, squares).best;
}

// Force of gas and damper over time, roughly: not linear in its parameters.
std::vector<double> decay(const std::vector<double>& p) {
  std::vector<double> y;
  for (int k = 0; k < 20; ++k) y.push_back(p[0] * std::exp(-0.02 * p[1] * k) + 0.3 * p[2] * k);
  return y;
}

// How often each interval holds what was hidden, of 400 repetitions with noise of `noise` tolerances.
std::vector<int> hits(double noise) {
  constexpr double kTolerance = 0.1;
  std::mt19937 random(20231);
  std::normal_distribution<double> normal(0.0, noise * kTolerance);
  std::uniform_real_distribution<double> anywhere(2.5, 8.0);
  std::vector<int> count(3, 0);
  for (int k = 0; k < 400; ++k) {
    const std::vector<double> hidden = {anywhere(random), anywhere(random), anywhere(random)};
    std::vector<double> measured = decay(hidden);
    for (double& y : measured) y += normal(random);
    const CalibrationSpec spec = spec_of(3, measured, kTolerance);
    const Determination d = determined(spec, decay, least_misfit(spec, decay));
    for (std::size_t i = 0; i < 3; ++i)
      count[i] += hidden[i] >= d.intervals[i].least && hidden[i] <= d.intervals[i].most;
  }
  return count;
}

// 380 of 400 expected, four standard deviations of that count are 17.
TEST(Determination, IntervalsHoldTheHiddenNumbersAsOftenAsTheySay) {
  for (const int count : hits(1.0)) {
    EXPECT_GE(count, 363);
    EXPECT_LE(count, 398);  // wider than asked, a little, where s2 is cut at 1
  }
}

TEST(Determination, IntervalsWidenWhereTheToleranceWasTooSmall) {
  for (const int count : hits(3.0)) EXPECT_GE(count, 363);
}

// y = A p: the interval is q sqrt((A' A)^-1) tolerance.
TEST(Determination, OfALinearModelIsExact) {
  const auto line = [](const std::vector<double>& p) {
    return std::vector<double>{2.0 * p[1], 0.5 * p[1] + 3.0 * std::log(p[0]), 4.0 * p[1] - std::log(p[0])};
  };
  const CalibrationSpec spec = spec_of(2, line({3.0, 4.0}), 0.05);
  const Shares best = {spec.parameters[0].share(3.0), spec.parameters[1].share(4.0)};
  const Determination d = determined(spec, line, best);
  Eigen::Matrix<double, 3, 2> a;
  a << 0.0, 2.0, 3.0, 0.5, -1.0, 4.0;
  const Eigen::Matrix2d c = (a.transpose() * a).inverse() * 0.05 * 0.05;
  EXPECT_NEAR(d.intervals[0].most, 3.0 * std::exp(1.959964 * std::sqrt(c(0, 0))), 1e-5);
  EXPECT_NEAR(d.intervals[1].least, 4.0 - 1.959964 * std::sqrt(c(1, 1)), 1e-5);
  EXPECT_NEAR(d.correlation(0, 1), c(0, 1) / std::sqrt(c(0, 0) * c(1, 1)), 1e-5);
  EXPECT_NEAR(d.gain, 0.0, 1e-12);
  EXPECT_TRUE(d.loose.empty());
  EXPECT_EQ(d.intervals[0].is_determined(), "yes");
}

TEST(Determination, TellsWhatNothingHolds) {
  const auto product = [](const std::vector<double>& p) {
    return std::vector<double>{std::log(p[0]) + std::log(p[2])};
  };
  CalibrationSpec spec = spec_of(3, {2.5}, 0.01);
  const Determination d = determined(spec, product, least_misfit(spec, product));
  ASSERT_EQ(d.loose.size(), 2u);  // p1, and p0 against p2
  for (const Interval& interval : d.intervals) EXPECT_EQ(interval.is_determined(), "no");
  EXPECT_NEAR(d.correlation(0, 2), -1.0, 1e-3);
}

TEST(Determination, SaysWhenTheSearchHasNotEnded) {
  const CalibrationSpec spec = spec_of(3, decay({4.0, 4.0, 4.0}), 0.1);
  const Shares best = {spec.parameters[0].share(4.0), spec.parameters[1].share(4.0) + 0.01,
                       spec.parameters[2].share(4.0)};
  const Determination d = determined(spec, decay, best);
  EXPECT_NEAR(d.gain / evaluated(spec, decay, best).misfit, 1.0, 0.05);  // nearly linear over so small a step
}

// Two targets of one parameter that cannot both be met: p = 3 and p = 5.
TEST(Pulls, NameWhatMeetingATargetCosts) {
  const auto twice = [](const std::vector<double>& p) { return std::vector<double>{p[1], p[1]}; };
  CalibrationSpec spec = spec_of(2, {3.0, 5.0}, 0.5);
  const Shares best = {0.5, spec.parameters[1].share(4.0)};
  std::vector<Evaluation> sets;
  for (const Shares& set : difference_sets(spec, best)) sets.push_back(evaluated(spec, twice, set));
  std::vector<const Evaluation*> around;
  for (const Evaluation& e : sets) around.push_back(&e);
  const std::vector<Pull> pulls = pulls_of(spec, evaluated(spec, twice, best), around);
  ASSERT_EQ(pulls.size(), 2u);
  EXPECT_NEAR(pulls[0].step[1], -1.0 / 9.0, 1e-9);  // of the range 1 to 10
  ASSERT_EQ(pulls[0].costs.size(), 1u);
  EXPECT_EQ(pulls[0].costs[0].first, 1u);
  EXPECT_NEAR(pulls[0].costs[0].second, 2.0, 1e-9);  // tolerances
}

}  // namespace
}  // namespace footfall
