#include "coupler/base/made_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

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

// A kill leaves the list as it stands while a run lives.
class FilesOfAKilledRun : public FilesOfARun {
 protected:
  FilesOfAKilledRun() {
    write("run/notes.txt", "mine");
    write("run/summary.json", "mine");
    MadeFiles made(run());
    made.begin({"history.csv", "summary.json"}, {"bodies_[0-9].*", "script/.*", "([0-9"});
    fs::create_directories(folder_ / "run/script");
    write("run/script/in.grains", "1");
    write("run/grains_500.vtk", "2");
    write("run/history.csv", "3");
    pause();
    write("run/bodies_0001.vtu", "4");
    fs::copy_file(folder_ / "run/.footfall.files", folder_ / "list");
  }
  // After the last sign of the run, and of the clock of files.
  static void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }
  void kill() {
    fs::copy_file(folder_ / "list", folder_ / "run/.footfall.files", fs::copy_options::overwrite_existing);
  }
};

TEST_F(FilesOfAKilledRun, AreWhatCameWhileItLived) {
  kill();
  pause();
  write("run/later.txt", "mine");
  EXPECT_THAT(made_files(run()), ElementsAre("bodies_0001.vtu", "grains_500.vtk", "history.csv", "script/in.grains"));
  remove_made_files(run());
  for (const char* mine : {"run/notes.txt", "run/summary.json", "run/later.txt"}) EXPECT_TRUE(is_there(mine)) << mine;
  EXPECT_FALSE(is_there("run/script"));
}

TEST_F(FilesOfAKilledRun, StayKnownWhenOtherCommandsHaveAddedTheirs) {
  kill();
  pause();
  write("run/later.txt", "mine");
  {
    const MadeFiles report(run());
    EXPECT_TRUE(report.is_foreign("later.txt"));
    write("run/report.html", "5");
  }
  EXPECT_THAT(made_files(run()),
              ElementsAre("bodies_0001.vtu", "grains_500.vtk", "history.csv", "report.html", "script/in.grains"));
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
