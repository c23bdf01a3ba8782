#include "mbd_solver/cli/launch/run_time.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

Json marks(double dem, long steps_early, long steps_late) {
  return {{"time_s", {0.0, 0.1, 0.2}},
          {"wall_s", {0.0, 1.0, 2.0}},
          {"dem_wall_s", {0.0, dem, 2.0 * dem}},
          {"steps", {0L, steps_early, steps_early + steps_late}},
          {"windows", {0L, 100L, 200L}}};
}

TEST(RunTime, AnEvenPaceGoesOn) {
  const RunTime time = expected_run_time(marks(0.9, 200, 200), 1.0);
  EXPECT_NEAR(time.seconds, 10.0, 1e-12);
  EXPECT_NEAR(time.most, 10.0, 1e-12);
  EXPECT_NEAR(time.least, 2.0 + 8.0 * (0.9 + 0.1 * 0.5), 1e-12);
  EXPECT_NEAR(time.share_of_grains, 0.9, 1e-12);
}

TEST(RunTime, StepsThatGrowAreExpectedToGrowOn) {
  const RunTime time = expected_run_time(marks(0.0, 800, 400), 1.0);  // 4 steps in a window in the end
  EXPECT_NEAR(time.most, 10.0, 1e-12);
  EXPECT_NEAR(time.least, 4.0, 1e-12);
  EXPECT_NEAR(time.seconds, 2.0 + 8.0 * 0.5, 1e-12);
}

TEST(RunTime, StepsGrowToFourTimesAtMost) {
  EXPECT_NEAR(expected_run_time(marks(0.0, 80000, 40000), 1.0).least, 2.0 + 8.0 * 0.25, 1e-12);
}

// In the first half of a trial the grains may stand still yet: the bounds tell how even their pace was.
TEST(RunTime, TheBoundsHoldBothPacesOfTheGrains) {
  Json uneven = marks(0.0, 200, 200);
  uneven["dem_wall_s"] = {0.0, 0.6, 1.5};
  const RunTime time = expected_run_time(uneven, 1.0);
  EXPECT_NEAR(time.seconds, 2.0 + 8.0 * (0.9 + 0.1), 1e-12) << "the later one is expected";
  EXPECT_NEAR(time.least, 2.0 + 8.0 * (0.6 + 0.1 * 0.5), 1e-12);
  EXPECT_NEAR(time.most, 10.0, 1e-12);
  uneven["dem_wall_s"] = {0.0, 1.2, 2.1};
  EXPECT_NEAR(expected_run_time(uneven, 1.0).most, 2.0 + 8.0 * (1.2 + 0.1), 1e-12);
}

TEST(RunTime, NothingIsLeftBehindTheEnd) {
  EXPECT_NEAR(expected_run_time(marks(0.5, 200, 200), 0.1).seconds, 2.0, 1e-12);
}

TEST(RunTime, MarksThatAreMissingAreTold) {
  EXPECT_THROW(expected_run_time(nullptr, 1.0), nlohmann::json::exception);
  EXPECT_THROW(expected_run_time({{"time_s", {0.0, 1.0}}}, 1.0), nlohmann::json::exception);
}

TEST(RunTime, DurationsHaveTwoDigits) {
  EXPECT_EQ(duration_text(0.51), "0.51 s");
  EXPECT_EQ(duration_text(45.4), "45 s");
  EXPECT_EQ(duration_text(150.0), "2.5 min");
  EXPECT_EQ(duration_text(7200.0), "2 h");
  EXPECT_EQ(duration_text(99.7), "1.7 min");
  EXPECT_EQ(duration_text(99.7 * 60.0), "1.7 h");
  EXPECT_EQ(duration_text(99.7 * 3600.0), "100 h");
  EXPECT_EQ(duration_text(1234.0 * 3600.0), "1234 h");
}

}  // namespace
}  // namespace footfall
