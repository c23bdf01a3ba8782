// Numbers in the locale of a program that writes 1.234,5.
#include "coupler/base/number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include <string>

#include "coupler/archive.h"
#include "coupler/base/text.h"
#include "tests/support/foreign_locale.h"

namespace footfall {
namespace {

TEST(Numbers, AreReadAlikeInEveryLocale) {
  const test::ForeignLocale german;
  std::ostringstream foreign;
  foreign << 1234.5;
  ASSERT_EQ(foreign.str(), "1.234,5") << "this test would see nothing";
  char* rest = nullptr;
  EXPECT_EQ(read_number("1.5 m", &rest), 1.5);
  EXPECT_EQ(std::string(rest), " m");
  EXPECT_EQ(read_number("1,5", &rest), 1.0);
  EXPECT_EQ(read_number(" +0x1.8p+1", nullptr), 3.0);
  EXPECT_EQ(read_number("-inf", nullptr), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(read_number("1e999", nullptr), std::numeric_limits<double>::infinity());
  EXPECT_EQ(read_number("5e-324", nullptr), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(positive_number("2.25"), 2.25);
}

// As printf in the locale "C".
TEST(Numbers, AreWrittenAlikeInEveryLocale) {
  const double values[] = {0.0,
                           -0.0,
                           1.5,
                           -1234567.891,
                           1e300,
                           5e-324,
                           0.1,
                           std::nextafter(1.0, 2.0),
                           std::numeric_limits<double>::infinity()};
  std::string plain, hexadecimals;
  for (const double value : values) {
    char text[400];
    std::snprintf(text, sizeof text, "%f|", value);
    plain += text;
    // Of the smallest number libraries write different digits.
    std::snprintf(text, sizeof text, "%a|", value);
    hexadecimals += value == 5e-324 ? hexadecimal(value) + "|" : text;
  }
  const test::ForeignLocale german;
  std::string plain_now, hexadecimals_now;
  for (const double value : values) {
    plain_now += plain_text(value) + "|";
    hexadecimals_now += hexadecimal(value) + "|";
  }
  EXPECT_EQ(plain_now, plain);
  EXPECT_EQ(hexadecimals_now, hexadecimals);
  EXPECT_EQ(fixed_text(12345.678, 2), "12345.68");
}

TEST(Numbers, OfACheckpointAreTheSameInEveryLocale) {
  const auto saved = [] {
    Archive archive;
    double value = -0.1;
    archive("value", value);
    return archive.text();
  };
  const std::string here = saved();
  const test::ForeignLocale german;
  EXPECT_EQ(saved(), here);
  Archive archive("checkpoint", here);
  double value = 0.0;
  archive("value", value);
  EXPECT_EQ(value, -0.1);
}

}  // namespace
}  // namespace footfall
