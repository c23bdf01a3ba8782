// Programs that are started.
#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <filesystem>

#include "coupler/base/errors.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/launch/programs.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

// mbd_solver/base/child_watch.h and mbd_solver/launch/programs.h.

class Processes : public ::testing::Test, protected TemporaryFolder {
 protected:
};

Command shell(const std::string& script) { return {Rights::of_user(), {"sh", "-c", script}}; }

TEST_F(Processes, ChildGivesItsExitCode) {
  EXPECT_EQ(run_child(shell("exit 3")).code, 3);
  EXPECT_EQ(run_child(shell("kill -KILL $$")).code, 128 + SIGKILL);
  EXPECT_FALSE(run_child(shell("kill -KILL $$")).crashed);
  EXPECT_TRUE(run_child(shell("kill -SEGV $$")).crashed);
  EXPECT_FALSE(run_child(shell("exit 139")).crashed);  // what mpirun gives when a program of it has crashed
}

TEST_F(Processes, ChildThatCannotBeStartedIsNamed) {
  EXPECT_THROW(run_child({Rights::of_user(), {"no-such-program-anywhere"}, {}, file("out")}), InputError);
}

TEST_F(Processes, ChildTakesEnvironmentFolderAndOutputFile) {
  Command command = shell("echo $COLOUR; pwd");
  command.environment["COLOUR"] = "red";
  command.output = file("out.txt");
  command.folder = folder_.string();
  EXPECT_EQ(run_child(command).code, 0);
  EXPECT_EQ(text("out.txt"), "red\n" + std::filesystem::canonical(folder_).string() + "\n");
}

// mpirun dies of SIGQUIT without a word to its programs; they may take seconds to write a checkpoint.
TEST_F(Processes, WhatALauncherLeavesBehindIsAskedToEndInOrderWhenASignalHasEndedIt) {
  const std::string program = std::filesystem::canonical("/bin/sh").filename();
  Command command = shell(
      "env --default-signal sh -c \"trap 'sleep 3; echo done > late; exit 3' INT; while :; do sleep 0.05; done\" & "
      "sleep 0.5; kill -QUIT $$");
  command.folder = folder_.string();
  EXPECT_EQ(run_child(command, program).code, 128 + SIGQUIT);
  EXPECT_EQ(text("late"), "done\n");
}

// A grandchild that outlives its parent, and does not listen to SIGTERM, is gone when run_child returns.
TEST_F(Processes, NothingOfAChildSurvives) {
  Command command = shell("(trap '' TERM; while :; do sleep 0.05; done) & echo $! > pid; exit 4");
  command.folder = folder_.string();
  const ChildEnd end = run_child(command);
  EXPECT_EQ(end.code, 4);
  EXPECT_FALSE(end.interrupted);
  EXPECT_EQ(kill(std::stoi(text("pid")), 0), -1) << "the grandchild is still there";
}

// The child sends the front door the signal that Ctrl-C sends; the graceful program among its descendants ends the
// others in order.
TEST_F(Processes, AnInterruptEndsInOrderThroughTheGracefulProgram) {
  const std::string program = std::filesystem::canonical("/bin/sh").filename();
  const ChildEnd end = run_child(shell("trap 'exit 3' INT; kill -INT $PPID; while :; do sleep 0.05; done"), program);
  EXPECT_TRUE(end.interrupted);
  EXPECT_EQ(end.code, 3);
}

// Terminals and batch systems send several signals at once: the program still gets its time.
TEST_F(Processes, MoreSignalsDoNotCutAnOrderlyEnd) {
  const std::string program = std::filesystem::canonical("/bin/sh").filename();
  const ChildEnd end = run_child(
      shell("trap 'sleep 1; exit 3' INT; kill -TERM $PPID; sleep 0.3; kill -HUP $PPID; kill -TERM $PPID; sleep 5"),
      program);
  EXPECT_TRUE(end.interrupted);
  EXPECT_EQ(end.code, 3);
}

TEST_F(Processes, AnInterruptWithoutGracefulProgramTerminates) {
  const ChildEnd end = run_child(shell("kill -INT $PPID; while :; do sleep 0.05; done"), "nobody");
  EXPECT_TRUE(end.interrupted);
  EXPECT_EQ(end.code, 128 + SIGTERM);
}

TEST_F(Processes, ShellLineReadsBackAsTheSameWords) {
  Command command{Rights::of_user(), {"printf", "%s|", "plain", "two words", "it's", "$HOME", "[0, 0, -3]", ""}};
  const std::string line = shell_line(command);
  ASSERT_EQ(std::system((line + " > " + file("out")).c_str()), 0);
  EXPECT_EQ(text("out"), "plain|two words|it's|$HOME|[0, 0, -3]||") << line;
}

// LIGGGHTS splits words at blanks after it has replaced variables.
TEST_F(Processes, LiggghtsGetsPathsFromTheCurrentFolder) {
  const std::string script = write("two words/in.bed", ""), grains = write("two words/run/grains.restart", "");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(file("two words"));
  const std::vector<std::string> words = script_arguments(script, {{"grains", grains}, {"list", "one\ntwo"}});
  std::filesystem::current_path(before);
  EXPECT_EQ(words, (std::vector<std::string>{"-in", "in.bed", "-var", "here", ".", "-var", "grains",
                                             "run/grains.restart", "-var", "list", "one", "two"}));
}

// A value of a foreign scene must not become a program of mpirun, nor an option of LIGGGHTS.
TEST_F(Processes, AValueThatIsNoValueStartsNothing) {
  const std::string script = write("in.bed", "");
  for (const std::string value :
       {"1\n:\nsh\n-c\ntouch made", ":", "-in other", "1\n-log\n/tmp/x", "a;b", "`ls`", "a#b", "tab\there", "a\\nb"})
    EXPECT_THROW(script_arguments(script, {{"k", value}}), InputError) << value;
  for (const std::string name : {"", "-in", ":", "k k", "k\n:"})
    EXPECT_THROW(script_arguments(script, {{name, "1"}}), InputError) << name;
  for (const std::string value :
       {"", "1e-4", "-900", "-.5", "one\ntwo", "${width}*2", "(v_a+1)^2", "../beds/new bed.restart"})
    EXPECT_EQ(script_arguments(script, {{"k", value}}).size(), value == "one\ntwo" ? 9u : 8u) << value;
}

TEST_F(Processes, AProgramOfMpirunCannotBeginAnother) {
  Command command = mpirun();
  EXPECT_THROW(add_program(command, 1, "/bin/true", {"-var", ":", "sh"}), InputError);
}

}  // namespace
}  // namespace footfall
