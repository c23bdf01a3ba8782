// Text: numbers, lists, names, quotes, and the words of a progress line.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/live_line.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/base/quote.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

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

class Quote : public ::testing::Test, protected TemporaryFolder {};

const std::string kNasty = "it's `touch ran` $(touch ran) \"two\" \\ # %d @x {a|b} ; & 'x";

TEST_F(Quote, AShellReadsTheWordBack) {
  for (const std::string& word : {kNasty, std::string(), std::string("plain"), std::string("two words"),
                                  std::string("line\nend"), std::string("~"), std::string("-3e-5")}) {
    ASSERT_EQ(std::system(("cd " + shell_word(file("")) + " && printf %s " + shell_word(word) + " > out").c_str()), 0);
    EXPECT_EQ(text("out"), word);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "ran"));
  EXPECT_EQ(shell_word("plain-3.5_x/y"), "plain-3.5_x/y");
}

TEST_F(Quote, GnuplotReadsTheTextBack) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not here";
  const std::string trailing = kNasty + "\\";
  write("a.gp", "set print 'out'\nprint " + gnuplot_text(trailing) + "\nset title " + gnuplot_text(trailing) +
                    "\nprint " + gnuplot_text("first\nprint 2") + "\n");
  ASSERT_EQ(std::system(("cd " + shell_word(file("")) + " && gnuplot a.gp").c_str()), 0);
  EXPECT_EQ(text("out"), trailing + "\nfirst print 2\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "ran"));
}

TEST_F(Quote, HtmlTextHoldsNoTags) {
  EXPECT_EQ(html_text("<b a=\"1\">&\n\x01\x7f"), "&lt;b a=&quot;1&quot;&gt;&amp;\n");
}

const std::vector<std::string> kBodies = {"cabin", "leg_1", "leg_2"};

TEST(NearestName, FindsOneEditOfEachKind) {
  EXPECT_EQ(nearest_name("cabn", kBodies), "cabin") << "a letter is missing";
  EXPECT_EQ(nearest_name("cabbin", kBodies), "cabin") << "one too many";
  EXPECT_EQ(nearest_name("cavin", kBodies), "cabin") << "another letter";
  EXPECT_EQ(nearest_name("acbin", kBodies), "cabin") << "neighbours swapped";
}

TEST(NearestName, TakesTheFirstOfEquals) { EXPECT_EQ(nearest_name("leg", kBodies), "leg_1"); }

TEST(NearestName, IsEmptyWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("thruster", kBodies), "");
  EXPECT_EQ(nearest_name("cabin", {}), "");
}

TEST(KnownNames, ListsAndGuesses) {
  EXPECT_EQ(known_names("bodies", "leg2", kBodies), " Known bodies: cabin, leg_1, leg_2. Did you mean \"leg_2\"?");
  EXPECT_EQ(known_names("bodies", "leg2", {}), " There are no known bodies.");
}

TEST(KnownNames, CutsALongList) {
  const std::vector<std::string> many(25, "thruster");
  const std::string text = known_names("bodies", "x", many);
  EXPECT_EQ(text.substr(text.size() - 5), ", ...");
}

TEST(ParameterCheck, AcceptsTheEdgesOfTheRange) {
  EXPECT_NO_THROW(require_not_negative("law", "c", 0.0, "N s/m"));
  EXPECT_NO_THROW(require_within("law", "share", 0.0, 0.0, 1.0, ""));
  EXPECT_NO_THROW(require_within("law", "share", 1.0, 0.0, 1.0, ""));
  EXPECT_THROW(require_positive("law", "k", 0.0, "N/m"), InputError);
}

TEST(ParameterCheck, RefusesWhatIsNoNumber) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(require_positive("law", "k", value, "N/m"), InputError);
    EXPECT_THROW(require_not_negative("law", "k", value, "N/m"), InputError);
    EXPECT_THROW(require_finite("law", "k", value, "N/m"), InputError);
    EXPECT_THROW(require_within("law", "k", value, 0.0, 1.0, "N/m"), InputError);
  }
}

TEST(ParameterCheck, NamesLawParameterAndValue) {
  EXPECT_TRUE(test::names(test::error_of([] { require_positive("gas spring", "volume", -2.0, "m3"); }),
                          {"gas spring", "volume", "-2 m3"}));
  EXPECT_TRUE(test::names(test::error_of([] { require_within("law", "share", 1.5, 0.0, 1.0, ""); }), {"share", "1.5"}));
}

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
