// Exponents from measured values: exact laws, known quantiles, and how often an interval holds the truth.
#include "mbd_solver/cli/experiments/power_law.h"
#include "coupler/base/pi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

constexpr double kRoundOff = 1e-12;

// All combinations of 3 x 2 x 4 values over rather different ranges.
Eigen::MatrixXd combinations() {
  Eigen::MatrixXd x(24, 3);
  int row = 0;
  for (const double density : {1400.0, 2800.0, 5600.0})
    for (const double diameter : {0.14, 0.24})
      for (const double height : {0.2, 0.4, 0.8, 1.6}) x.row(row++) << density, diameter, height;
  return x;
}

const Eigen::Vector3d kExponents(1.0 / 2, 2.0 / 3, 1.0 / 3);

Eigen::VectorXd law_of(const Eigen::MatrixXd& x, double factor) {
  return factor * (x.array().log().matrix() * kExponents).array().exp();
}

TEST(PowerLaw, AnExactLawComesBackToTheLastDigits) {
  const Eigen::MatrixXd x = combinations();
  const PowerLaw law = fit_power_law(x, law_of(x, 0.14));
  EXPECT_LT((law.exponents - kExponents).norm(), kRoundOff);
  EXPECT_NEAR(law.factor, 0.14, 0.14 * 10 * kRoundOff);
  EXPECT_EQ(law.degrees_of_freedom, 20);
  EXPECT_NEAR(law.r_squared, 1.0, kRoundOff);
  EXPECT_LT(law.scatter, kRoundOff);
  EXPECT_NEAR(law.at(Eigen::Vector3d(1e3, 0.1, 1.0)), 0.14 * std::sqrt(1e3) * std::pow(0.1, 2.0 / 3), 1e-9);
}

// Whole tables have t to four or five digits (two-sided 95 %); one and two degrees are known in closed form.
TEST(PowerLaw, QuantilesOfStudent) {
  constexpr double kOfTheTable = 5e-5;
  EXPECT_NEAR(student_t(0.95, 1), std::tan(0.95 * kPi / 2), 1e-9);
  EXPECT_NEAR(student_t(0.95, 2), 0.95 * std::sqrt(2.0 / (1 - 0.95 * 0.95)), 1e-12);
  EXPECT_NEAR(student_t(0.95, 3), 3.18245, kOfTheTable);
  EXPECT_NEAR(student_t(0.95, 10), 2.22814, kOfTheTable);
  EXPECT_NEAR(student_t(0.95, 30), 2.04227, kOfTheTable);
  EXPECT_NEAR(student_t(0.99, 20), 2.84534, kOfTheTable);
  EXPECT_NEAR(student_t(0.95, 100000), 1.95996, kOfTheTable);
}

// Errors of one exponent against the formula of a straight line, s / sqrt(sum (x - mean)^2): four points by hand.
TEST(PowerLaw, ErrorsOfAStraightLine) {
  const Eigen::Vector4d log_x(0, 1, 2, 3), log_y(0.1, 0.9, 2.1, 2.9);  // slope 0.96, residuals 0.04, -0.12, 0.12, -0.04
  const PowerLaw law = fit_power_law(log_x.array().exp().matrix(), log_y.array().exp());
  const double scatter = std::sqrt((2 * 0.04 * 0.04 + 2 * 0.12 * 0.12) / 2);
  EXPECT_NEAR(law.exponents[0], 0.96, kRoundOff);
  EXPECT_NEAR(law.scatter, scatter, kRoundOff);
  EXPECT_NEAR(law.errors[0], scatter / std::sqrt(5.0), kRoundOff);
  EXPECT_NEAR(law.upper[0] - law.lower[0], 2 * 4.302653 * scatter / std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(std::log(law.factor), 0.06, kRoundOff);
  EXPECT_NEAR(std::log(law.factor_interval.second / law.factor), 4.302653 * scatter * std::sqrt(0.25 + 2.25 / 5.0),
              1e-6);
}

// Noise of 10 %, 4000 times: 95 of 100 intervals hold the truth. The share of n trials scatters by sqrt(0.95 0.05 / n)
// = 0.35 %; four times that.
TEST(PowerLaw, IntervalsHoldTheTruthAsOftenAsTheySay) {
  constexpr int kTrials = 4000;
  const Eigen::MatrixXd x = combinations();
  const Eigen::VectorXd exact = law_of(x, 0.14);
  std::mt19937 generator(20030514);
  std::normal_distribution<double> noise(0.0, 0.1);
  Eigen::Array4i held = Eigen::Array4i::Zero();
  double scatter = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    Eigen::VectorXd y = exact;
    for (double& value : y) value *= std::exp(noise(generator));
    const PowerLaw law = fit_power_law(x, y);
    for (int k = 0; k < 3; ++k) held[k] += law.lower[k] < kExponents[k] && kExponents[k] < law.upper[k];
    held[3] += law.factor_interval.first < 0.14 && 0.14 < law.factor_interval.second;
    scatter += law.scatter * law.scatter / kTrials;
  }
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(held[k] / static_cast<double>(kTrials), 0.95, 0.014) << "coefficient " << k;
  EXPECT_NEAR(std::sqrt(scatter), 0.1, 0.001);
}

TEST(PowerLaw, WithGivenExponentsOnlyTheFactorIsFound) {
  const Eigen::MatrixXd x = combinations();
  const PowerLaw right = fit_factor(x, law_of(x, 0.14), kExponents);
  EXPECT_NEAR(right.factor, 0.14, 1e-12);
  EXPECT_LT(right.scatter, kRoundOff);
  const PowerLaw wrong = fit_factor(x, law_of(x, 0.14), Eigen::Vector3d(-1.0, 2.0 / 3, 1.0 / 3));
  EXPECT_LT(wrong.r_squared, 0.0);
}

TEST(PowerLaw, RefusesWhatLeavesExponentsOpen) {
  const Eigen::MatrixXd x = combinations();
  EXPECT_THROW(fit_power_law(x.topRows(4), Eigen::VectorXd::Ones(4)), InputError);
  Eigen::MatrixXd together = x;
  together.col(1) = x.col(0).array().square();
  EXPECT_THROW(fit_power_law(together, law_of(x, 1.0)), InputError);
  Eigen::MatrixXd constant = x;
  constant.col(2).setConstant(0.3);
  EXPECT_THROW(fit_power_law(constant, law_of(x, 1.0)), InputError);
}

}  // namespace
}  // namespace footfall
