#include "coupler/base/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace footfall {
namespace {

TEST(NumberText, RoundsToSoManyDigitsWithoutTrailingZeros) {
  EXPECT_EQ(number_text(1.5), "1.5");
  EXPECT_EQ(number_text(-900.0), "-900");
  EXPECT_EQ(number_text(2.0 / 3.0), "0.666667");
  EXPECT_EQ(number_text(2.0 / 3.0, 3), "0.667");
  EXPECT_EQ(number_text(123456.0, 3), "1.23e+05");
  EXPECT_EQ(number_text(1e-6), "1e-06");
}

TEST(NumberText, SeventeenDigitsReadBackTheSameNumber) {
  for (const double x :
       {0.1, -1.0 / 3.0, std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min()})
    EXPECT_EQ(std::strtod(number_text(x, 17).c_str(), nullptr), x);
}

TEST(NumberText, SaysWhatIsNoNumber) {
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(number_text(std::nan("")), "nan");
}

TEST(FixedText, HoldsTheDigitsBehindThePoint) {
  EXPECT_EQ(fixed_text(0.5, 2), "0.50");
  EXPECT_EQ(fixed_text(-1.26, 1), "-1.3");
  EXPECT_EQ(fixed_text(1e300, 1).size(), 303u) << "301 digits, point, one digit";
}

TEST(Joined, PutsTheMarkBetweenTheTextsOnly) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"a"}), "a");
  EXPECT_EQ(joined({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(joined({"", "b"}, ","), ",b") << "an empty cell keeps its place";
}

TEST(Split, UndoesJoined) {
  const std::vector<std::string> cells = {"time", "", "body 1.z"};
  EXPECT_EQ(split(joined(cells, ","), ','), cells);
  EXPECT_TRUE(split("", ',').empty());
}

TEST(Trimmed, CutsBothEndsOnly) {
  EXPECT_EQ(trimmed(" \ta b\r"), "a b");
  EXPECT_EQ(trimmed(" \t\r"), "");
}

TEST(Text, NamesOfFilesHoldNothingThatMeansSomethingElsewhere) {
  for (const char* good : {"a", "leg_1", "pad-2.left", "9", "_x"}) EXPECT_TRUE(is_plain_name(good)) << good;
  for (const char* bad : {"", ".", "..", ".a", "a/b", "a b", "a`b`", "a$b", "a\n", "\xc3\xa4", "a'b", "a:b", "*"})
    EXPECT_FALSE(is_plain_name(bad)) << bad;
  EXPECT_TRUE(is_plain_name(std::string(kLongestName, 'a')));
  EXPECT_FALSE(is_plain_name(std::string(kLongestName + 1, 'a')));
}

}  // namespace
}  // namespace footfall
