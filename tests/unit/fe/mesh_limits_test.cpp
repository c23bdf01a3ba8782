// Input files of finite-element codes that include each other, or whose sets name each other, many times.
#include <gtest/gtest.h>

#include "mbd_solver/fe/fe_mesh.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

const std::string kTriangle = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n";

class MeshLimits : public ::testing::Test, protected TemporaryFolder {
 protected:
  std::string refused(const std::string& name, const std::string& content) {
    return test::error_of([&] { parse_fe_mesh(content, write(name, content)); });
  }
};

// Eight levels of ten each, 10^8 files.
TEST_F(MeshLimits, FilesThatIncludeEachOtherTenTimesAreRefused) {
  for (const auto& [end, begin] : {std::pair<std::string, std::string>{".inp", "*INCLUDE, INPUT="},
                                   std::pair<std::string, std::string>{".bdf", "INCLUDE "}}) {
    std::string first;
    for (int k = 7; k >= 0; --k) {
      first.clear();
      for (int i = 0; i < 10; ++i) first += begin + "m" + std::to_string(k + 1) + end + "\n";
      write("m" + std::to_string(k) + end, first);
    }
    write("m8" + end, end == ".inp" ? kTriangle : "GRID,1,,0.,0.,0.\n");
    EXPECT_TRUE(test::names(refused("m0" + end, first), {"m0" + end, "1000 included files", "E0437"}));
  }
}

// Each set has twice the entries of the one before.
TEST_F(MeshLimits, SetsThatNameEachOtherTwiceAreRefused) {
  std::string text = kTriangle + "*ELEMENT, TYPE=S3, ELSET=e0\n1,1,2,3\n";
  for (int k = 0; k < 60; ++k)
    text += "*ELSET, ELSET=e" + std::to_string(k + 1) + "\ne" + std::to_string(k) + ", E" + std::to_string(k) + "\n";
  EXPECT_TRUE(test::names(refused("m.inp", text), {"m.inp", "100000000 entries of sets", "E0437"}));
}

// Ranges pass over the smaller of two numbers: those they ask for, and those there are.
TEST_F(MeshLimits, RangesAreInTheOrderOfTheirNumbers) {
  const std::string text = "*NODE\n30,0,0,0\n10,1,0,0\n20,0,1,0\n*NSET, NSET=wide, GENERATE\n1,2000000000,1\n" +
                           std::string("*NSET, NSET=narrow, GENERATE\n10,30,10\n*NSET, NSET=one, GENERATE\n20,21,1\n");
  const FeMesh mesh = parse_fe_mesh(text, "m.inp");
  EXPECT_EQ(mesh.sets.at("wide"), (std::vector<int>{1, 2, 0}));
  EXPECT_EQ(mesh.sets.at("narrow"), (std::vector<int>{1, 2, 0}));
  EXPECT_EQ(mesh.sets.at("one"), std::vector<int>{2});
  const FeMesh cards = parse_fe_mesh(
      "GRID,30,,0.,0.,0.\nGRID,10,,1.,0.,0.\nGRID,20,,0.,1.,0.\nSET1,1,10,THRU,30\n"
      "SET1,2,20,THRU,21\n",
      "m.bdf");
  EXPECT_EQ(cards.sets.at("1"), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(cards.sets.at("2"), std::vector<int>{2});
}

}  // namespace
}  // namespace footfall
