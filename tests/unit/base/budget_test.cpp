// Limits of readers: mbd_solver/base/budget.h.
#include <gtest/gtest.h>

#include "mbd_solver/base/budget.h"
#include "mbd_solver/base/csv.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

constexpr ReadLimit kTen{10, "parts", "take fewer"};
constexpr ReadLimit kTwoMegabytes{2 * limit::kMegabyte, "of text", "take less", true};

TEST(ReadBudget, HoldsWhatItsLimitSaysAndNoMore) {
  ReadBudget parts(kTen, "file.xml:3");
  parts.take(9);
  parts.take();
  EXPECT_TRUE(test::names(test::error_of([&] { parts.take(); }),
                          {"file.xml:3: has more than 10 parts", "take fewer", "[E0437 read-limit]"}));
}

TEST(ReadBudget, DoesNotOverflow) {
  ReadBudget parts(kTen, "file");
  EXPECT_TRUE(parts.takes(1));
  EXPECT_FALSE(parts.takes(~std::uint64_t{0}));
  EXPECT_FALSE(parts.takes(10));
  EXPECT_TRUE(parts.takes(9));
}

TEST(ReadBudget, NamesBytesInMegabytes) {
  EXPECT_TRUE(test::names(ReadBudget(kTwoMegabytes, "file").excess(), {"more than 2 MB of text"}));
  EXPECT_TRUE(test::names(ReadBudget(kTwoMegabytes, "file", limit::kMegabyte).excess(), {"more than 1 MB of text"}));
}

TEST(XmlParts, AreAtLeastTheElementsAndAttributes) {
  EXPECT_EQ(xml_parts("<a b='1' c=\"2\"><d/></a>"), 5u);
  EXPECT_EQ(xml_parts(""), 0u);
}

class LongLine : public ::testing::Test, protected TemporaryFolder {};

// Before, the line was read whole, and a file without line ends with it: 4 GB, and its cells.
TEST_F(LongLine, OfATableIsRefused) {
  const std::string most(limit::kLine.most, ' ');
  CsvReader good(write("good.csv", most + "\n1,2\n"), "a table");
  EXPECT_TRUE(good.next());
  for (const std::string& text : {most + " \n", "\"" + most + "\"\n"}) {
    CsvReader csv(write("long.csv", text), "a table");
    EXPECT_TRUE(test::names(test::error_of([&] { csv.next(); }), {"long.csv", "16 MB", "E0437"}));
  }
  std::string lines = "\"\n";
  for (int k = 0; k < 17; ++k) lines += std::string(limit::kMegabyte, 'x') + "\n";
  CsvReader csv(write("quoted.csv", lines), "a table");
  EXPECT_TRUE(test::names(test::error_of([&] { csv.next(); }), {"quoted.csv:1", "16 MB", "E0437"}));
}

}  // namespace
}  // namespace footfall
