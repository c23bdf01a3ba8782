#include "mbd_solver/output/checkpoint_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

class CheckpointFolderTest : public testing::Test, TemporaryFolder {
 protected:
  void keep(long n) {
    CheckpointFolder folder(run_);
    std::ofstream(folder.begin(n) + "/run.txt") << "memory " << n;
    folder.finish();
  }
  bool there(const std::string& name) const { return fs::exists(fs::path(run_) / "checkpoint" / name); }

  const std::string run_ = folder_.string();
};

TEST_F(CheckpointFolderTest, TheLastTwoSetsAreKept) {
  for (const long n : {9, 10, 11}) keep(n);
  EXPECT_FALSE(there("9"));
  EXPECT_TRUE(there("10") && there("11"));
  EXPECT_EQ(fs::path(newest_checkpoint(run_)).filename(), "11");
}

TEST_F(CheckpointFolderTest, ASetThatIsNotFinishedDoesNotCount) {
  keep(1);
  {
    CheckpointFolder folder(run_);
    std::ofstream(folder.begin(2) + "/run.txt") << "half of it";
    EXPECT_TRUE(there("2.part"));
    EXPECT_EQ(fs::path(newest_checkpoint(run_)).filename(), "1");
  }
  EXPECT_FALSE(there("2.part")) << "it went with who wrote it";
}

TEST_F(CheckpointFolderTest, WhatProgramsThatWereKilledHaveLeftIsRemoved) {
  fs::create_directories(run_ + "/checkpoint/3.part");
  std::ofstream(run_ + "/checkpoint/3.part/run.txt") << "half of it";
  remove_unfinished_sets(run_);
  EXPECT_FALSE(fs::exists(run_ + "/checkpoint")) << "there was nothing else in it";
  keep(1);
  fs::create_directories(run_ + "/checkpoint/3.part");
  remove_unfinished_sets(run_);
  EXPECT_TRUE(there("1"));
  EXPECT_FALSE(there("3.part"));
}

TEST_F(CheckpointFolderTest, ADamagedSetIsPassedOver) {
  keep(1);
  keep(2);
  std::ofstream(run_ + "/checkpoint/2/run.txt", std::ios::app) << "x";
  EXPECT_EQ(fs::path(newest_checkpoint(run_)).filename(), "1");
  fs::remove(run_ + "/checkpoint/1/run.txt");
  try {
    newest_checkpoint(run_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("run.txt is damaged or missing"), std::string::npos) << error.what();
  }
}

TEST_F(CheckpointFolderTest, WhatIsDroppedOrClearedIsGoneAndOlderSetsStay) {
  keep(1);
  CheckpointFolder folder(run_);
  folder.begin(2);
  folder.drop();
  EXPECT_FALSE(there("2.part"));
  folder.begin(3);
  folder.finish();
  EXPECT_TRUE(there("1") && there("3"));
  folder.clear();
  EXPECT_FALSE(there("3"));
  EXPECT_EQ(fs::path(newest_checkpoint(run_)).filename(), "1");
}

TEST_F(CheckpointFolderTest, NoneIsAnError) { EXPECT_THROW(newest_checkpoint(run_), InputError); }

}  // namespace
}  // namespace footfall
