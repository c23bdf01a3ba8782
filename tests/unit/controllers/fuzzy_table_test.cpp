#include "mbd_solver/model/controllers/fuzzy_table.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>

#include "coupler/base/errors.h"
#include "tests/unit/controllers/fuzzy_files.h"

namespace footfall {
namespace {

Eigen::VectorXd from_table(const FuzzyTable& of, const FuzzyInput& x) {
  Eigen::VectorXd u(of.output_count());
  of.evaluate(x, u);
  return u;
}

TEST(FuzzyTable, IsWithinAHundredthOfTheExactController) {
  const double difference = FuzzyTable(lander(), kDefaultFuzzyGrid).largest_difference(lander(), 2000);
  std::cout << "largest difference of table and controller at 2000 random inputs: " << difference << "\n";
  EXPECT_LT(difference, 0.01);
}

// Twice the points, about half the error: the error comes from kinks (first order), not from smooth curvature
// (second).
TEST(FuzzyTable, ErrorFallsWithTheGrid) {
  const double coarse = FuzzyTable(lander(), {13, 5, 9, 9}).largest_difference(lander(), 500);
  const double finer = FuzzyTable(lander(), {25, 9, 17, 17}).largest_difference(lander(), 500);
  EXPECT_LT(finer, 0.75 * coarse);
}

TEST(FuzzyTable, IsExactAtTheCornersOfTheTerms) {
  const FuzzyTable small(lander(), {13, 5, 9, 9});
  for (double a : lander().breakpoints(0))
    for (double da : lander().breakpoints(1))
      for (double alpha : lander().breakpoints(2))
        for (double beta : lander().breakpoints(3))
          EXPECT_LT((from_table(small, {a, da, alpha, beta}) - voltages(lander(), {a, da, alpha, beta}))
                        .cwiseAbs()
                        .maxCoeff(),
                    1e-12);
}

TEST(FuzzyTable, SaturatesAndNeverAnswersNaN) {
  const FuzzyTable small(lander(), {7, 5, 5, 5});
  EXPECT_EQ(from_table(small, {9.0, 90.0, -9.0, 9.0}), from_table(small, {5.0, 10.0, -4.0, 4.0}));
  EXPECT_EQ(from_table(small, {1.0, std::nan(""), 0.0, 0.0}), Eigen::Vector4d::Constant(kNoRuleVoltage));
  std::mt19937_64 generator(3);
  for (int n = 0; n < 1000; ++n) {
    const Eigen::VectorXd u = from_table(small, random_input(lander(), generator));
    EXPECT_TRUE((u.array() >= 0.0).all() && (u.array() <= 1.0).all());
  }
}

TEST(FuzzyTable, CostsFarLessThanFiftyMicrosecondsPerPeriod) {
  std::mt19937_64 generator(4);
  std::vector<FuzzyInput> inputs;
  for (int n = 0; n < 5000; ++n) inputs.push_back(random_input(lander(), generator));
  Eigen::VectorXd u(4);
  double sum = 0.0;
  const FuzzyTable table(lander(), {25, 9, 17, 17});
  const auto start = std::chrono::steady_clock::now();
  for (const FuzzyInput& x : inputs) {
    table.evaluate(x, u);
    sum += u[0];
  }
  const double microseconds =
      std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() /
      static_cast<double>(inputs.size());
  std::cout << "one evaluation of the table: " << microseconds << " us (mean voltage " << sum / 5000.0 << ")\n";
  EXPECT_LT(microseconds, 50.0);  // measured below 1: the bound leaves room for a loaded machine
}

TEST(FuzzyTable, RefusesGridsThatMakeNoSense) {
  EXPECT_THROW(FuzzyTable(lander(), {3, 5, 5, 5}), InputError);  // four corners along a
  EXPECT_THROW(FuzzyTable(lander(), {7, 1, 5, 5}), InputError);
  EXPECT_THROW(FuzzyTable(lander(), {1000, 1000, 1000, 1000}), InputError);
}

}  // namespace
}  // namespace footfall
