// What keeps a program within a folder: rights given up to the kernel, folders of runs whose links are not followed, and
// inputs that are no files.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fcntl.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "coupler/base/codes.h"
#include "coupler/base/confinement.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/input_file.h"
#include "coupler/base/run_directory.h"
#include "coupler/base/start.h"
#include "mbd_solver/base/lock.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

// The exit code of `work` in a process of its own: rights are given up for good.
int in_a_child(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool can_write(const std::string& path) { return std::ofstream(path).good(); }

bool refuses(const MessageCode& code, const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return std::string(error.what()).find(code.number) != std::string::npos;
  }
  return false;
}

class MatrixFiles : public TemporaryFolder, public ::testing::Test {
 protected:
  MatrixFiles() {
    fs::create_directories(folder_ / "run/plots");
    fs::create_directories(folder_ / "outside");
    write("outside/kept", "as it was\n");
  }
  void link(const std::string& name, const std::string& target) const {
    fs::create_symlink(folder_ / target, folder_ / name);
  }
};

TEST_F(MatrixFiles, AConfinedProcessWritesOnlyBelowItsFolders) {
  if (!kernel_confines_files()) GTEST_SKIP() << "this kernel has no Landlock";
  link("run/link", "outside/kept");
  const int result = in_a_child([&] {
    if (!confine({{file("run")}, {}}).empty()) return 100;
    std::error_code error;
    int wrong = 0;
    wrong |= can_write(file("run/new")) ? 0 : 1;
    wrong |= can_write("/dev/null") ? 0 : 2;
    wrong |= can_write(file("outside/new")) || can_write(file("outside/kept")) ? 4 : 0;
    wrong |= can_write(file("run/link")) ? 8 : 0;
    wrong |= fs::remove(file("outside/kept"), error) || fs::create_directory(file("outside/folder"), error) ? 16 : 0;
    wrong |= text("outside/kept") == "as it was\n" ? 0 : 32;  // reading stays
    return wrong;
  });
  EXPECT_EQ(result, 0);
  EXPECT_EQ(text("outside/kept"), "as it was\n");
}

TEST_F(MatrixFiles, AConfinedProcessStartsOnlyItsProgram) {
  const std::string touch = "/bin/touch " + file("run/evil");
  EXPECT_EQ(in_a_child([&] {
              if (!confine({{file("run")}, {}}).empty()) return 100;
              return std::system(touch.c_str()) == 0 ? 1 : 0;
            }),
            0);
  EXPECT_FALSE(fs::exists(file("run/evil")));
  if (!kernel_confines_files()) return;
  EXPECT_EQ(in_a_child([&] {
              if (!confine({{file("run")}, {"/bin/true"}}).empty()) return 100;
              execl("/bin/true", "true", nullptr);
              return 101;
            }),
            0);
  EXPECT_EQ(in_a_child([&] {
              if (!confine({{file("run")}, {"/bin/true"}}).empty()) return 100;
              execl("/bin/touch", "touch", file("run/evil").c_str(), nullptr);
              return errno == EACCES ? 0 : 101;
            }),
            0);
}

TEST_F(MatrixFiles, LinksBelowAGuardedFolderAreNotFollowed) {
  fs::remove(file("run/plots"));
  link("run/plots", "outside");
  link("run/history.csv", "outside/kept");
  link("run/summary.json.part", "outside/kept");
  guard_folder(file("run"));

  EXPECT_EQ(GuardedPath(file("run/plots/kept")).problem(), ELOOP);
  EXPECT_EQ(GuardedPath(file("run/history.csv")).open(O_RDWR), -1);
  std::ofstream stream;
  EXPECT_FALSE(open_file(stream, file("run/history.csv"), FileStart::kNew));
  EXPECT_THROW(write_whole_file(file("run/plots/new"), "text"), InputError);
  EXPECT_THROW(make_folder(file("run/plots/new")), InputError);
  EXPECT_EQ(GuardedPath(file("run/plots/kept")).remove_all(), ELOOP);
  write_whole_file(file("run/summary.json"), "text");  // the draft was a link of someone else
  EXPECT_EQ(text("run/summary.json"), "text");
  write_whole_file(file("run/history.csv"), "text");  // replaces the link
  EXPECT_FALSE(fs::is_symlink(file("run/history.csv")));
  EXPECT_EQ(GuardedPath(file("run/plots")).remove_all(), 0);  // the link itself
  make_folder(file("run/plots/deeper"));
  write_whole_file(file("run/plots/deeper/new"), "text");
  EXPECT_EQ(text("run/plots/deeper/new"), "text");
  EXPECT_EQ(text("outside/kept"), "as it was\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(file("outside")), fs::directory_iterator()), 1);
}

// A hard link is a second name of a file: writing to one of them would change the other.
TEST_F(MatrixFiles, HardLinksBelowAGuardedFolderAreSeparated) {
  const std::string names[] = {"run/history.csv", "run/motion.csv"};
  for (const std::string& name : names) fs::create_hard_link(file("outside/kept"), file(name));
  guard_folder(file("run"));
  std::ofstream stream;
  ASSERT_TRUE(open_file(stream, file(names[0]), FileStart::kEnd));
  stream << "more\n" << std::flush;
  EXPECT_EQ(text(names[0]), "as it was\nmore\n");
  std::ofstream anew;
  ASSERT_TRUE(open_file(anew, file(names[1]), FileStart::kNew));
  anew << "new\n" << std::flush;
  EXPECT_EQ(text(names[1]), "new\n");
  EXPECT_EQ(text("outside/kept"), "as it was\n");
}

TEST_F(MatrixFiles, ALockIsNoLinkAndNoPipe) {
  link("run/.footfall.lock", "outside/kept");
  EXPECT_THROW(lock_folder(file("run")), InputError);
  fs::remove(file("run/.footfall.lock"));
  ASSERT_EQ(mkfifo(file("run/.footfall.lock").c_str(), 0644), 0);
  EXPECT_THROW(lock_folder(file("run")), InputError);
  EXPECT_EQ(text("outside/kept"), "as it was\n");
}

TEST_F(MatrixFiles, InputsAreRegularFilesOfASizeThatCanBeMeant) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0644), 0);
  for (const std::string& path : {file("pipe"), std::string("/dev/zero")}) {
    EXPECT_TRUE(refuses(code::kNotRegularFile, [&] { require_regular_file(path); })) << path;
    EXPECT_TRUE(refuses(code::kNotRegularFile, [&] { read_whole_file(path); })) << path;
  }
  write("long", "");
  fs::resize_file(file("long"), kLargestText + 1);
  EXPECT_TRUE(refuses(code::kFileTooLarge, [&] { require_regular_file(file("long"), kLargestText); }));
  EXPECT_NO_THROW(require_regular_file(file("long")));
  EXPECT_NO_THROW(require_regular_file(file("outside/kept")));
  EXPECT_NO_THROW(require_regular_file(file("missing")));
}

TEST_F(MatrixFiles, ArgumentsAreTextAndTheCurrentFolderExists) {
  const auto starts = [](std::string argument) {
    char name[] = "footfall";
    char* words[] = {name, argument.data(), nullptr};
    prepare_start(2, words);
  };
  for (const char* good : {"plain", "\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"})
    EXPECT_NO_THROW(starts(good)) << good;
  for (const char* bad : {"\xFF", "\xC3", "\xC0\xAF", "\xE2\x82", "\xED\xA0\x80", "\xF5\x80\x80\x80"})
    EXPECT_TRUE(refuses(code::kNotUtf8, [&] { starts(bad); }));
  const int result = in_a_child([&] {
    fs::create_directory(file("gone"));
    fs::current_path(file("gone"));
    fs::remove(file("gone"));
    return refuses(code::kCurrentFolder, [] { require_current_folder(); }) ? 0 : 1;
  });
  EXPECT_EQ(result, 0);
}

TEST_F(MatrixFiles, ThatTheLibraryCannotUseAreNamed) {
  try {
    FAIL() << fs::file_size(file("missing"));
  } catch (const fs::filesystem_error& error) {
    EXPECT_EQ(std::string(as_input_error(error).what()).rfind(file("missing") + ": cannot be used: No such file", 0),
              0u);
  }
}

// A history that got the number of a closed standard output would hold what is printed.
TEST_F(MatrixFiles, NeverGetTheNumberOfAStandardStream) {
  const int result = in_a_child([&] {
    close(STDIN_FILENO), close(STDOUT_FILENO);
    keep_streams();
    const int own = open(file("own").c_str(), O_WRONLY | O_CREAT, 0644);
    return own > STDERR_FILENO && ::write(STDOUT_FILENO, "x", 1) == 1 && fs::file_size(file("own")) == 0 ? 0 : 1;
  });
  EXPECT_EQ(result, 0);
}

TEST_F(MatrixFiles, AnOutputThatNobodyReadsIsAnErrorOfTheWrite) {
  const int result = in_a_child([] {
    int ends[2];
    if (pipe(ends) != 0) return 1;
    dup2(ends[1], STDOUT_FILENO);
    if (output_is_unread()) return 2;
    close(ends[0]);
    keep_streams();
    return ::write(STDOUT_FILENO, "x", 1) == -1 && errno == EPIPE && output_is_unread() ? 0 : 3;
  });
  EXPECT_EQ(result, 0);
}

}  // namespace
}  // namespace footfall
