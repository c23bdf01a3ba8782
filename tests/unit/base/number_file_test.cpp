// Large texts of numbers against std::from_chars, word by word.

#include "mbd_solver/base/number_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <charconv>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

double nearest(const std::string& word) {
  double value = 0.0;
  std::from_chars(word.data(), word.data() + word.size(), value);
  return value;
}

std::shared_ptr<NumberFile> file_of(const std::string& text) {
  const TemporaryFolder folder;
  return NumberFile::open(folder.write("numbers", text));
}

bool judged(const std::string& text, std::size_t count, double hole = -9999.0) {
  return file_of(text)->judge(0, count, hole);
}

TEST(NumberFile, GivesTheNearestDoubleOfEveryWord) {
  std::mt19937 random(3);
  const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  std::string text = "header 7";
  const std::size_t begin = text.size();
  std::vector<double> expected;
  const std::string gaps = " \n\t\r,;";
  for (int i = 0; i < 60000; ++i) {
    for (unsigned k = below(i % 900 == 0 ? 90 : 3) + 1; k > 0; --k) text += gaps[below(6)];
    std::string word = below(3) == 0 ? "-" : "";
    const unsigned before = below(i % 50 == 0 ? 9 : 6), behind = below(i % 70 == 0 ? 25 : 7);
    for (unsigned k = 0; k < before; ++k) word += static_cast<char>('0' + below(10));
    if (behind > 0 || before == 0) word += ".";
    for (unsigned k = 0; k < behind + (before == 0); ++k) word += static_cast<char>('0' + below(10));
    expected.push_back(nearest(word));
    text += word;
  }
  const auto numbers = file_of(text);
  ASSERT_TRUE(numbers->judge(begin, expected.size(), -1e9));
  std::vector<double> all(expected.size());
  numbers->read(0, all.size(), all.data());
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], expected[i]) << i;
  for (int i = 0; i < 3000; ++i) {
    const std::size_t first = random() % expected.size(), count = std::min<std::size_t>(5, expected.size() - first);
    double some[5];
    numbers->read(first, count, some);
    for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(some[k], expected[first + k]) << first;
  }
}

// Each word at every place in a block of 64 bytes, at its borders too.
TEST(NumberFile, LeavesAllElseToAReaderOfWords) {
  const auto at_every_place = [](const std::string& word) {
    int good = 0;
    for (std::size_t k = 0; k < 70; ++k) good += judged(std::string(k, ' ') + word + " 1", 2);
    return good;
  };
  for (const char* word :
       {"1", "-1", "12.5", "-0.25", ".5", "-.5", "5.", "00012", "12345678", "-1.23456789012345678901234567890"})
    EXPECT_EQ(at_every_place(word), 70) << word;
  for (const char* word : {"nan",          "1e5",   "+1",      "--1",    "1-2",    "-",       ".",       "-.",
                           "1.2.3",        "1..2",  ".5.",     "1.-2",   "0x1",    "\"1\"",   "1:2",     "123456789",
                           "-123456789.5", "-9999", "-9999.0", "-09999", "-9999.", "1.5\x01", "\xc2\xa0"})
    EXPECT_EQ(at_every_place(word), 0) << word;
  EXPECT_FALSE(judged("1 2 3", 2));
  EXPECT_FALSE(judged("1 2 3", 4));
  EXPECT_FALSE(judged("", 1));
  EXPECT_TRUE(judged("", 0));
  EXPECT_FALSE(judged(std::string(400, '1'), 1));
  EXPECT_FALSE(judged(std::string("1 \0 2", 5), 2));
}

TEST(NumberFile, FindsHolesOfEveryForm) {
  struct Case {
    double hole;
    std::vector<std::string> same, others;
  };
  const std::vector<Case> cases = {
      {-9999, {"-9999", "-9999.000", "-0009999"}, {"9999", "-99999", "-9999.5", "-999"}},
      {0, {"0", "-0", "0.00", ".0", "-.0", "000"}, {"0.01", "-0.5", ".5", "10"}},
      {0.5, {"0.5", ".5", "00.50"}, {"-0.5", "0.51"}},
      {7, {"7", "07.0"}, {"-7", "70", "17"}},
      {-32768, {"-32768"}, {"32768", "-3276"}},
      {-3.4028234663852886e38, {"-340282346638528859811704183484516925440.000000"}, {"-34028"}},
      {std::nan(""), {}, {"0", "-9999"}}};
  for (const Case& c : cases) {
    for (std::size_t k = 0; k < 70; ++k) {
      for (const std::string& word : c.same) EXPECT_FALSE(judged(std::string(k, '\n') + word, 1, c.hole)) << word << k;
      for (const std::string& word : c.others) EXPECT_TRUE(judged(std::string(k, '\n') + word, 1, c.hole)) << word << k;
    }
  }
}

// Around the border of what is judged at once.
TEST(NumberFile, JudgesWordsAcrossChunks) {
  for (std::size_t k = 262144 - 20; k < 262144 + 2; ++k) {
    const std::string before(k, ' ');
    EXPECT_TRUE(judged(before + "-1234.5678", 1)) << k;
    EXPECT_FALSE(judged(before + "-9999.0000", 1)) << k;
    EXPECT_FALSE(judged(before + "-12.345.678", 1)) << k;
    double value = 0.0;
    const auto file = file_of("3 " + before + "-1234.5678\n");
    ASSERT_TRUE(file->judge(0, 2, -9999.0));
    file->read(1, 1, &value);
    EXPECT_EQ(value, -1234.5678) << k;
  }
}

TEST(NumberFile, TellsOfAFileThatIsChangedWhileItIsInUse) {
  const TemporaryFolder folder;
  const std::string path = folder.write("numbers", "1 2 3");
  const auto file = NumberFile::open(path);
  ASSERT_TRUE(file->judge(0, 3, -9999.0));
  double values[3];
  file->read(0, 3, values);
  std::ofstream(path) << "1 2 3 4";
  EXPECT_THROW(file->read(0, 3, values), FileError);
  unlink(path.c_str());
  EXPECT_EQ(NumberFile::open(path), nullptr);
}

}  // namespace
}  // namespace footfall
