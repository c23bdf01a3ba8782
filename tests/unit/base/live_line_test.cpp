#include "coupler/base/live_line.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

TEST(LiveLine, SaysNothingOfTheTimeLeftAsLongAsNobodyCanKnowIt) {
  EXPECT_EQ(time_left({0.0, 0.0, 0.0}), "");
  EXPECT_EQ(time_left({0.0, 0.0, 30.0}), "");  // no pace yet
  EXPECT_EQ(time_left({0.5, 0.5, 0.1}), "");   // too early to know
  EXPECT_EQ(time_left({1.0, 1.0, 30.0}), "");  // nothing is left
  EXPECT_EQ(time_text(0.0, 1.0, {0.0, 0.0, 0.0}), "t = 0.0000 of 1 s (0 %)");
}

TEST(LiveLine, CountsTheTimeLeftFromThePaceSinceItsClockWasStarted) {
  EXPECT_EQ(time_left({0.25, 0.25, 10.0}), "about 30 s left");
  EXPECT_EQ(time_left({0.75, 0.25, 10.0}), "about 10 s left");  // a resumed run: what was done before took no time here
  EXPECT_EQ(time_left({0.1, 0.1, 60.0}), "about 9 min left");
  EXPECT_EQ(time_left({0.01, 0.01, 360.0}), "about 9.9 h left");
  EXPECT_EQ(time_left({0.01, 0.01, 3640.0}), "about 100 h left");
}

TEST(LiveLine, InAFileAPerCentComesOnce) {
  LiveLine line(false, false);
  EXPECT_FALSE(line.due(0.0));
  EXPECT_TRUE(line.due(0.012));
  EXPECT_FALSE(line.due(0.013));  // the same per cent
  EXPECT_FALSE(line.due(0.5));    // within the same second
  EXPECT_FALSE(LiveLine(true, true).due(0.5));
}

}  // namespace
}  // namespace footfall
