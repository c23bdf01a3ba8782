#include "mbd_solver/cli/launch/bed_conditions.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

// As LIGGGHTS writes it: the line of the script, then as it was filled in.
std::string log_with(const std::string& young) {
  return "LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0)\n#fix young all property/global youngsModulus peratomtype 1 1\n"
         "fix young    all property/global youngsModulus peratomtype ${e} 207e9\n"
         "fix young    all property/global youngsModulus peratomtype " +
         young + " 207e9\nfix poisson  all property/global poissonsRatio peratomtype 0.3 0.1\nSetting up run at\n";
}

class BedConditions : public testing::Test, protected TemporaryFolder {};

TEST_F(BedConditions, AreThoseThatLiggghtsExecuted) {
  const auto constants = elastic_constants(write("log", log_with("3.5e7")));
  EXPECT_EQ(constants.at("youngsModulus"), "peratomtype 35000000 207000000000");
  EXPECT_EQ(constants.at("poissonsRatio"), "peratomtype 0.3 0.1");
}

TEST_F(BedConditions, AgreeHoweverTheNumbersAreWritten) {
  EXPECT_EQ(different_material(write("bed", log_with("3.5e7")), write("run", log_with("35000000"))), "");
}

TEST_F(BedConditions, OfAnotherMaterialAreTold) {
  const std::string text = different_material(write("bed", log_with("5e6")), write("run", log_with("35e6")));
  EXPECT_NE(text.find("youngsModulus: the bed was poured with peratomtype 5000000 207000000000, the run has"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("poissonsRatio"), std::string::npos);
}

TEST_F(BedConditions, ThatNobodyKnowsAreNotCompared) {
  EXPECT_EQ(different_material(file("none"), write("run", log_with("35e6"))), "");
  EXPECT_EQ(different_material(write("bed", log_with("5e6")), write("run", "units si\n")), "");
}

}  // namespace
}  // namespace footfall
