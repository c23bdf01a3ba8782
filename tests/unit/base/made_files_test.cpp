#include "coupler/base/made_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
namespace fs = std::filesystem;

class FilesOfARun : public ::testing::Test, protected TemporaryFolder {
 protected:
  FilesOfARun() { fs::create_directories(folder_ / "run/plots"); }
  std::string run() const { return file("run"); }
  bool is_there(const std::string& name) const { return fs::exists(fs::symlink_status(folder_ / name)); }
};

TEST_F(FilesOfARun, AreWhatHasComeToItsFolder) {
  write("run/notes.txt", "mine");
  {
    const MadeFiles made(run());
    EXPECT_TRUE(made.is_foreign("notes.txt"));
    write("run/history.csv", "1");
    write("run/plots/energy.png", "2");
  }
  EXPECT_THAT(made_files(run()), ElementsAre("history.csv", "plots/energy.png"));
  remove_made_files(run());
  EXPECT_TRUE(is_there("run/notes.txt"));
  EXPECT_FALSE(is_there("run/plots"));
  EXPECT_FALSE(is_there("run/history.csv"));
  EXPECT_THAT(made_files(run()), IsEmpty());
}

TEST_F(FilesOfARun, GrowWithLaterCommandsAndForgetWhatIsGone) {
  {
    const MadeFiles made(run());
    write("run/history.csv", "1");
  }
  fs::remove(folder_ / "run/history.csv");
  {
    const MadeFiles made(run());
    write("run/report.html", "2");
    write("run/compare.txt", "3");
  }
  EXPECT_THAT(made_files(run()), ElementsAre("compare.txt", "report.html"));
}

TEST_F(FilesOfARun, AreKnownOfARunThatWasKilled) {
  write("run/summary.json", "mine");
  const MadeFiles made(run());
  made.note({"history.csv", "summary.json"});
  EXPECT_THAT(made_files(run()), ElementsAre("history.csv"));
}

TEST_F(FilesOfARun, LeaveFoldersWithOtherFilesAlone) {
  write("run/plots/mine.png", "mine");
  {
    const MadeFiles made(run());
    write("run/plots/energy.png", "2");
    write("run/history.csv", "1");
  }
  remove_made_files(run(), "plots/");
  EXPECT_TRUE(is_there("run/plots/mine.png"));
  EXPECT_FALSE(is_there("run/plots/energy.png"));
  EXPECT_TRUE(is_there("run/history.csv"));
}

// The list may come with a folder from somebody else.
TEST_F(FilesOfARun, NeverLieOutsideItsFolder) {
  const std::string outside = write("outside.txt", "mine");
  fs::create_directories(folder_ / "elsewhere");
  write("elsewhere/far.txt", "mine");
  fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "run/link");
  write("run/.footfall.files", "../outside.txt\n" + outside + "\nlink/far.txt\nplots/../../outside.txt\n.\n./\n..\n\n");
  EXPECT_THAT(made_files(run()), ElementsAre("."));
  remove_made_files(run());
  EXPECT_TRUE(is_there("outside.txt"));
  EXPECT_TRUE(is_there("elsewhere/far.txt"));
  EXPECT_TRUE(is_there("run"));
}

}  // namespace
}  // namespace footfall
