// Errors of an ensemble's figures, and of curves.
#include "mbd_solver/cli/experiments/errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

TEST(SampledFigure, ErrorIsOfTheMeanAndItsScatterThatOfTheDifferences) {
  // Samples far apart that all change by the same: the error is known exactly, however large the spread.
  const SampledFigure same = sampled_figure({11.0, 21.0, 31.0}, {10.0, 20.0, 30.0});
  EXPECT_DOUBLE_EQ(same.mean, 21.0);
  EXPECT_DOUBLE_EQ(same.spread, 10.0);
  EXPECT_DOUBLE_EQ(same.error, 0.05);
  EXPECT_DOUBLE_EQ(same.standard_error, 0.0);
  // Differences -1, 1, 3: mean 1, deviation 2, standard error 2 / sqrt(3), of 20.
  const SampledFigure other = sampled_figure({9.0, 21.0, 33.0}, {10.0, 20.0, 30.0});
  EXPECT_DOUBLE_EQ(other.error, 0.05);
  EXPECT_NEAR(other.standard_error, 2.0 / std::sqrt(3.0) / 20.0, 1e-15);
  EXPECT_DOUBLE_EQ(sampled_figure({3.0}, {2.0}).standard_error, 0.0);
}

TEST(ObservedOrder, IsTheSlopeOfTheLogarithms) {
  EXPECT_NEAR(observed_order({{0.1, 3e-2}, {0.2, 12e-2}, {0.4, 48e-2}}), 2.0, 1e-12);
  EXPECT_EQ(observed_order({{0.1, 3e-2}, {0.2, 0.0}}), 0.0);  // one point that has a logarithm
}

}  // namespace
}  // namespace footfall
