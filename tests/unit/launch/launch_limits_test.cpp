// mpirun is not started where it would wait without end: the limit is named, with what there is and what is needed.
#include "mbd_solver/launch/launch_limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/support/refused.h"

namespace footfall {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A limit of this process, until the end of a scope.
class Lowered {
 public:
  Lowered(__rlimit_resource_t what, rlim_t limit) : what_(what) {
    getrlimit(what_, &before_);
    const rlimit lower{limit, before_.rlim_max};
    setrlimit(what_, &lower);
  }
  ~Lowered() { setrlimit(what_, &before_); }

 private:
  __rlimit_resource_t what_;
  rlimit before_{};
};

std::string refused(int processes) {
  return test::refusal([&] { require_room_to_launch(processes); });
}

TEST(RoomToLaunch, IsThereAsARule) { EXPECT_NO_THROW(require_room_to_launch(4)); }

TEST(RoomToLaunch, NeedsOpenFilesForEachProcess) {
  const Lowered files(RLIMIT_NOFILE, 50);
  EXPECT_NO_THROW(require_room_to_launch(2));
  EXPECT_THAT(refused(4),
              AllOf(HasSubstr("ulimit -n"), HasSubstr("at most 50"), HasSubstr("needs 56"), HasSubstr("E0575")));
}

TEST(RoomToLaunch, NeedsFilesOfSomeMegabytes) {
  const Lowered size(RLIMIT_FSIZE, 64 << 10);
  EXPECT_THAT(refused(2), AllOf(HasSubstr("ulimit -f"), HasSubstr("64 kB"), HasSubstr("4160 kB"), HasSubstr("E0575")));
}

TEST(RoomToLaunch, NeedsATemporaryFolderWithSpace) {
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "/tmp";
  for (const char* place : {"/proc", "/proc/missing/below"}) {  // no space; a user may not write either
    setenv("TMPDIR", place, 1);
    EXPECT_THAT(refused(2), AllOf(HasSubstr(place), HasSubstr("TMPDIR"), HasSubstr("E0575")));
  }
  setenv("TMPDIR", kept.c_str(), 1);
}

// Processes that do not share memory need none: one alone, or those that the user connects in another way.
TEST(RoomToLaunch, NeedsSharedMemory) {
  constexpr const char* kFull = "/proc";  // no space
  if (access(kFull, W_OK) != 0) GTEST_SKIP() << "an ordinary user may not write there, as MPI finds";
  setenv("OMPI_MCA_btl_vader_backing_directory", kFull, 1);
  EXPECT_THAT(refused(3), AllOf(HasSubstr("shared memory /proc has 0 kB left"), HasSubstr("needs 6208 kB"),
                                HasSubstr("--shm-size"), HasSubstr("E0575")));
  EXPECT_NO_THROW(require_room_to_launch(1));
  for (const char* ways : {"tcp,self", "^vader"}) {
    setenv("OMPI_MCA_btl", ways, 1);
    EXPECT_NO_THROW(require_room_to_launch(3)) << ways;
  }
  setenv("OMPI_MCA_btl", "^tcp", 1);
  EXPECT_THAT(refused(3), HasSubstr("shared memory"));
  unsetenv("OMPI_MCA_btl");
  unsetenv("OMPI_MCA_btl_vader_backing_directory");
}

}  // namespace
}  // namespace footfall
