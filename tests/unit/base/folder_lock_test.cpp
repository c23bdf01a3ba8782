#include "coupler/base/folder_lock.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "coupler/base/errors.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class FolderLocks : public ::testing::Test, protected TemporaryFolder {};

TEST_F(FolderLocks, ASecondRunIsRefused) {
  const FileLock lock = lock_folder(file("run"));
  try {
    lock_folder(file("run"));
    FAIL() << "the folder was given twice";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("another run writes here"), std::string::npos) << what;
    EXPECT_NE(what.find("--out"), std::string::npos) << what;
  }
  EXPECT_TRUE(lock_folder(file("other")).held());
}

TEST_F(FolderLocks, AProgramOfTheHolderIsNotRefused) {
  EXPECT_FALSE(folder_is_held_for_us(file("run")));
  setenv(kLockedFolder, locked_name(file("run")).c_str(), 1);
  EXPECT_TRUE(folder_is_held_for_us(file("run")));
  EXPECT_TRUE(folder_is_held_for_us(file("run/")));
  EXPECT_TRUE(folder_is_held_for_us(file("other/../run")));
  EXPECT_FALSE(folder_is_held_for_us(file("other")));
  unsetenv(kLockedFolder);
}

}  // namespace
}  // namespace footfall
