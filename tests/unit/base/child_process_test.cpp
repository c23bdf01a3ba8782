// Programs as they are started: words, files and rights.

#include "mbd_solver/base/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "coupler/base/errors.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class ChildProcess : public ::testing::Test, protected TemporaryFolder {
 protected:
  int run(const Rights& rights, const std::string& script) {
    return wait_for_end(start_program({rights, {"/bin/sh", "-c", script}, {}, file("said")}));
  }
};

// ls and touch are programs of their own; echo is part of the shell.
TEST_F(ChildProcess, StartsNothingButWhatItsRightsName) {
  if (!kernel_confines_files()) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_EQ(run(Rights::of_user(), "/bin/ls / >/dev/null"), 0);
  EXPECT_EQ(run(Rights::starting({"/bin/sh"}), "echo $((1 + 1))"), 0);
  EXPECT_EQ(run(Rights::starting({"/bin/sh"}), "/bin/ls /"), 126);
  EXPECT_EQ(run(Rights::starting({"/bin/sh", "/bin/ls"}), "/bin/ls / >/dev/null"), 0);
  EXPECT_EQ(run(Rights::starting({"/bin/ls"}), "true"), kCannotStart);
}

TEST_F(ChildProcess, WritesOnlyBelowItsFolders) {
  if (!kernel_confines_files()) GTEST_SKIP() << "this kernel has no Landlock";
  std::filesystem::create_directory(file("in"));
  const Rights limited = Rights::writing({"/bin/sh"}, {file("in")});
  EXPECT_EQ(run(limited, "echo 1 > '" + file("in/a") + "'"), 0);
  EXPECT_NE(run(limited, "echo 1 > '" + file("b") + "'"), 0);
  EXPECT_EQ(run(Rights::starting({"/bin/sh"}), "echo 1 > '" + file("b") + "'"), 0);
  EXPECT_TRUE(std::filesystem::exists(file("in/a")));
  // Paths count from here, also where the program begins elsewhere.
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  const Command there{Rights::writing({"/bin/sh"}, {"in"}), {"/bin/sh", "-c", "echo 1 > b"}, {}, "", "in"};
  EXPECT_EQ(wait_for_end(start_program(there)), 0);
  std::filesystem::current_path(before);
}

// Not lifted by what it starts.
TEST_F(ChildProcess, RightsGoOnToWhatItStarts) {
  if (!kernel_confines_files()) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_EQ(run(Rights::starting({"/bin/sh"}), "/bin/sh -c '/bin/ls /'"), 126);
}

TEST_F(ChildProcess, AWordWithALineEndIsRefused) {
  for (const std::string& word : std::vector<std::string>{"1\n:", "a\tb", "\x1b[0m", std::string("a\0b", 3)})
    EXPECT_THROW(start_program({Rights::of_user(), {"/bin/true", word}}), InputError) << word;
}

// Two pipes, each with the other's numbers.
TEST_F(ChildProcess, FilesGetTheirNumbers) {
  int one[2], two[2];
  ASSERT_EQ(pipe(one), 0);
  ASSERT_EQ(pipe(two), 0);
  // dash knows numbers of one digit only.
  const auto into = [](int end) { return " > /proc/self/fd/" + std::to_string(end); };
  const std::string script = "echo first" + into(two[1]) + "; echo second" + into(one[1]);
  const pid_t process = start_program({Rights::of_user(), {"sh", "-c", script}}, {{one[1], two[1]}, {two[1], one[1]}});
  ASSERT_EQ(wait_for_end(process), 0);
  char text[16] = {};
  EXPECT_EQ(read(one[0], text, sizeof text - 1), 6);
  EXPECT_STREQ(text, "first\n");
  for (const int end : {one[0], one[1], two[0], two[1]}) close(end);
}

TEST_F(ChildProcess, OutputOfAShortCommand) {
  EXPECT_EQ(output_of({Rights::of_user(), {"printf", "%s", "3.8.0"}}), "3.8.0");
  EXPECT_EQ(output_of({Rights::of_user(), {"sh", "-c", "echo half; exit 1"}}), "");
  EXPECT_EQ(output_of({Rights::of_user(), {"no-such-program-anywhere"}}), "");
}

TEST_F(ChildProcess, ACopyEndsWithItsCode) {
  EXPECT_EQ(wait_for_end(start_copy([] { return 7; }, Orphan::kIsKilled)), 7);
}

}  // namespace
}  // namespace footfall
