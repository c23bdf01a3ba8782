// mbd_solver/cli/launch/run_time.h

#include "mbd_solver/cli/launch/run_time.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

TEST(RunTime, IsWhatWasMeasuredWhenTheRunCameToItsEnd) {
  EXPECT_DOUBLE_EQ(expected_run_time({{0.0, 0.0}, {0.4, 0.5}, {0.9, 1.0}}, 1.0), 0.9);
}

TEST(RunTime, GoesOnAtThePaceOfTheSecondHalf) {
  // A slow start: 0.1 s of motion in the first second, 0.5 s in the next.
  const std::vector<TimeMark> marks{{0.0, 0.0}, {0.5, 0.05}, {1.0, 0.1}, {1.5, 0.35}, {2.0, 0.6}};
  EXPECT_NEAR(expected_run_time(marks, 2.1), 2.0 + 1.5 / 0.5, 1e-12);
}

TEST(RunTime, KnowsNothingOfARunThatHasNotMoved) {
  EXPECT_EQ(expected_run_time({}, 1.0), 0.0);
  EXPECT_EQ(expected_run_time({{0.0, 0.0}}, 1.0), 0.0);
}

}  // namespace
}  // namespace footfall
