#include "coupler/base/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

#include "coupler/base/quick_number.h"

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

// Tables are written by a quicker way of our own: digit for digit what the library writes, from tiny to huge, at powers of ten
// and ties, and round numbers.
TEST(NumberText, IsThatOfTheLibraryDigitForDigit) {
  std::vector<double> values = {0.0, -0.0, 0.5, 2.5, 0.125, 1e22, 1e23, 5e-324};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mantissa(-10.0, 10.0), exponent(-14.0, 24.0);
  for (int i = 0; i < 20000; ++i) values.push_back(mantissa(random) * std::pow(10.0, exponent(random)));
  for (int i = 0; i < 500; ++i)
    for (const double unit : {1e-5, 1e-3, 0.125, 1.0, 1e8}) values.push_back(i * unit);
  for (int i = -20; i < 25; ++i) {
    const double power = std::pow(10.0, i);
    for (const double near : {power, std::nextafter(power, 0.0), std::nextafter(power, 1e300), power * (1.0 - 5e-11),
                              power * (1.0 - 4e-11), power * (1.0 - 6e-11), power * 1.2345500000000001})
      values.push_back(near);
  }
  for (const int digits : {1, 2, 6, 9, 10, 12, 13, 17}) {
    for (const double value : values) {
      char written[64];
      std::snprintf(written, sizeof written, "%.*g", digits, value);
      ASSERT_EQ(number_text(value, digits), written) << digits << " digits";
    }
  }
}

// The quick way is taken: nearly all numbers of tables go by it.
TEST(NumberText, AsksTheLibrarySeldom) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mantissa(1.0, 10.0), exponent(-9.0, 9.0);
  int asked = 0;
  for (int i = 0; i < 10000; ++i) {
    char written[kLongestQuickNumber];
    if (write_quickly(written, mantissa(random) * std::pow(10.0, exponent(random)), 10) == nullptr) ++asked;
  }
  EXPECT_LT(asked, 100);
}

TEST(ShareText, HasTwoDigitsAndNoPowersOfTen) {
  EXPECT_EQ(share_text(0.0123), "1.2 %");
  EXPECT_EQ(share_text(0.5), "50 %");
  EXPECT_EQ(share_text(0.994), "99 %");
  EXPECT_EQ(share_text(0.997), "100 %");
  EXPECT_EQ(share_text(1.34), "134 %");
  EXPECT_EQ(share_text(-1.5), "-150 %");
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
