#include "coupler/words.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

TEST(Words, WholeNumbersWithinTheirLimitsOnly) {
  EXPECT_EQ(whole_number("0", 0, 10), 0);
  EXPECT_EQ(whole_number("10", 0, 10), 10);
  EXPECT_EQ(whole_number("-3", -5, 10), -3);
  for (const char* word : {"", "11", "-1", "1.0", "1e1", "7 ", "seven", "99999999999999999999"})
    EXPECT_FALSE(whole_number(word, 0, 10)) << "\"" << word << "\"";
}

TEST(Words, PositiveNumbersOnly) {
  EXPECT_EQ(positive_number("2.5e-3"), 2.5e-3);
  for (const char* word : {"", "0", "-1", "1s", "nan", "one"}) EXPECT_FALSE(positive_number(word)) << word;
}

}  // namespace
}  // namespace footfall
