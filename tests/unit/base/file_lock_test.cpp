#include "coupler/base/file_lock.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "coupler/base/errors.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class FileLocks : public ::testing::Test, protected TemporaryFolder {};

TEST_F(FileLocks, OneAtATime) {
  const std::string path = file("lock");
  {
    const FileLock first = FileLock::try_lock(path);
    EXPECT_TRUE(first.held());
    EXPECT_FALSE(FileLock::try_lock(path).held());
    EXPECT_EQ(owner_of(path), getpid());
  }
  EXPECT_TRUE(FileLock::try_lock(path).held());
}

TEST_F(FileLocks, AProgramThatWasStartedHoldsItOn) {
  const std::string path = file("lock");
  pid_t child = -1;
  {
    const FileLock lock = FileLock::try_lock(path);
    child = fork();
    if (child == 0) {
      pause();
      _exit(0);
    }
  }
  ASSERT_GT(child, 0);
  EXPECT_FALSE(FileLock::try_lock(path).held());
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(FileLock::try_lock(path).held());
}

TEST_F(FileLocks, WaitingEndsWithTheHolder) {
  const std::string path = file("lock");
  FileLock first = FileLock::try_lock(path);
  int told = 0;
  const FileLock second = FileLock::wait_for(path, [&] {
    ++told;
    first = FileLock();
  });
  EXPECT_TRUE(second.held());
  EXPECT_EQ(told, 1);
}

TEST_F(FileLocks, AnOwnerThatNobodyHasCollectedIsDead) {
  EXPECT_TRUE(is_alive(getpid()));
  const pid_t child = fork();
  if (child == 0) _exit(0);
  siginfo_t info;
  waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT);
  EXPECT_FALSE(is_alive(child));
  waitpid(child, nullptr, 0);
  EXPECT_FALSE(is_alive(child));
  EXPECT_FALSE(is_alive(0));
}

TEST_F(FileLocks, WithoutItsFolderThereIsNone) { EXPECT_THROW(FileLock::try_lock(file("nowhere/lock")), InputError); }

}  // namespace
}  // namespace footfall
