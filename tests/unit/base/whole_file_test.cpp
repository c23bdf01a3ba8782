#include "coupler/base/whole_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

class WholeFile : public ::testing::Test, protected TemporaryFolder {
 protected:
};

TEST_F(WholeFile, ReadsBackWhatWasWrittenByteByByte) {
  const std::string text("a\r\nb\0c\n", 7);
  write_whole_file(file("a"), text);
  EXPECT_EQ(read_whole_file(file("a")), text);
  write_whole_file(file("a"), "");
  EXPECT_EQ(read_whole_file(file("a")), "") << "an empty file is there; it takes the place of the old one";
}

TEST_F(WholeFile, NothingIsReadWhereNothingStands) { EXPECT_FALSE(read_whole_file(file("missing"))); }

TEST_F(WholeFile, LeavesNoDraftBehind) {
  write_whole_file(file("a"), "text");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(WholeFile, SaysWhichFileAndWhatToDo) {
  const std::string path = file("no folder/a");
  try {
    write_whole_file(path, "text", "is the disk full?");
    FAIL() << "written into a folder that is not there";
  } catch (const InputError& e) {
    EXPECT_EQ(e.what(), path + ": cannot be written: No such file or directory; is the disk full?");
  }
}

// A file may have 1 kB here, as if the disk were full.
TEST_F(WholeFile, AFullDiskLeavesWhatWasThere) {
  write_whole_file(file("a"), "before");
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit most{1024, 1024};
    setrlimit(RLIMIT_FSIZE, &most);
    try {
      write_whole_file(file("a"), std::string(100000, 'x'));
    } catch (const InputError& error) {
      _exit(std::string(error.what()).find("File too large") != std::string::npos ? 7 : 8);
    }
    _exit(9);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(text("a"), "before");
  EXPECT_FALSE(fs::exists(file("a.part")));
}

TEST_F(WholeFile, MakeFolderMakesThoseAroundItToo) {
  make_folder(file("x/y/z"));
  make_folder(file("x/y/z"));
  EXPECT_TRUE(fs::is_directory(file("x/y/z")));
}

TEST_F(WholeFile, MakeFolderSaysWhereItCannot) {
  write_whole_file(file("a"), "a file stands in the way");
  try {
    make_folder(file("a/b"), "choose another one");
    FAIL() << "a folder inside a file";
  } catch (const InputError& e) {
    const std::string said = e.what();
    EXPECT_EQ(said.rfind(file("a/b") + ": cannot be made: ", 0), 0u) << said;
    EXPECT_NE(said.find("; choose another one"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace footfall
