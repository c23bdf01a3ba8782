// Command lines: every command has its help and its place in the pages, and a line that cannot be read is answered by one line that says
// what to do.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <regex>
#include <set>

#include "tests/app/programs.h"

namespace footfall {
namespace {

using app::holds;

class Commands : public ::testing::Test {
 protected:
  const app::Folder folder{"commands"};
  // As `footfall --help` lists them.
  std::set<std::string> listed() const {
    const std::string help = folder.done("--help").text;
    std::set<std::string> names;
    const std::regex line("\n  ([a-z]+) ");
    for (auto at = std::sregex_iterator(help.begin() + static_cast<long>(help.find("Subcommands:")), help.end(), line);
         at != std::sregex_iterator(); ++at)
      names.insert((*at)[1]);
    return names;
  }
  static std::string text_of(const std::string& path) {
    std::ifstream file(app::kSource + "/" + path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_F(Commands, AreThoseOfThePageAndHaveHelp) {
  const std::string page = text_of("docs/reference/commands.md");
  const std::set<std::string> names = listed();
  for (const std::string& name : names) {
    // The program of `import` is built by its first call.
    if (name != "import" || std::filesystem::exists(folder.program("footfall_import"))) {
      EXPECT_TRUE(holds(folder.done(name + " --help").text, "--help")) << name;
    }
    EXPECT_TRUE(holds(page, "footfall " + name)) << name << " is not in docs/reference/commands.md";
  }
}

// The script of the checkout builds what the part of a command has: the program alone carries out the commands of a landing.
TEST_F(Commands, NeedTheProgramsOfTheirPartOnly) {
  const std::string list = text_of("mbd_solver/app/commands.def");
  folder.command("cp " + folder.program("footfall") + " footfall", 10);
  for (const std::string& name : listed()) {
    const bool own = folder.command("./footfall " + name + " --help", 10).exit_code == 0;
    EXPECT_EQ(own, holds(list, "\nCOMMAND(" + name + ", landing,") || name == "test") << name;
  }
}

// For the script of the checkout (tests/unit/app/needed_parts_test.cpp): an answer and nothing else, whatever the line is.
TEST_F(Commands, NameThePartsThatALineNeeds) {
  EXPECT_EQ(folder.done("needs run " + app::kInputs + "/reference --quiet").text, "fmi\n");
  EXPECT_EQ(folder.done("needs sweep " + app::kInputs + "/sweeps/touchdowns.toml").text, "campaign\n");
  for (const char* line : {"", "run", "run --until 1", "nonsense missing.toml", "needs", "--help"})
    EXPECT_EQ(folder.done(std::string("needs ") + line).text, "") << line;
  EXPECT_EQ(listed().count("needs"), 0u);
}

TEST_F(Commands, ThatBecameOptionsNameTheNewLine) {
  for (const auto& [old, now] : std::map<std::string, std::string>{
           {"surfaces", "check"}, {"pictures", "view"}, {"watch", "view"}, {"audit", "run"}}) {
    const test::Outcome outcome = folder.refused(old + " x", "E0502");
    EXPECT_TRUE(holds(outcome.text, "footfall " + now)) << outcome.text;
    EXPECT_EQ(app::lines_of(outcome.text), 1) << outcome.text;
  }
}

TEST_F(Commands, TakeTheLargerVersionOfEveryExampleOnGrains) {
  for (const std::filesystem::directory_entry& example : std::filesystem::directory_iterator(app::kExamples)) {
    const std::string scene = example.path().string();
    if (!std::filesystem::exists(example.path() / "scene.toml")) continue;
    EXPECT_TRUE(holds(folder.done("check " + app::quoted(scene) + " --large").text, "large.toml: no faults")) << scene;
  }
}

// A full disk behind the standard output, and an end time after the end of the scene.
TEST_F(Commands, TellOfOutputThatIsLostAndOfAnEndThatIsNotReached) {
  const test::Outcome full = folder.shell(folder.program("footfall") + " check " + app::kSliderCrank + " > /dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_TRUE(holds(full.text, "E0519")) << full.text;
  const std::string run = "run " + app::kSliderCrank + " --quiet --set output.plots=false --set end_time=0.02 --until ";
  EXPECT_TRUE(holds(folder.done(run + "0.05 --out beyond").text, "W0518"));
  EXPECT_FALSE(holds(folder.done(run + "0.01 --out within").text, "W0518"));
}

TEST_F(Commands, ThatCannotBeReadAreAnsweredByOneLine) {
  struct Line {
    const char *line, *code, *names;
  };
  const Line lines[] = {{"", "E0501", "run"},
                        {"rnu", "E0501", "\"run\""},
                        {"run --untl=1", "E0500", "\"--until\""},
                        {"compare", "E0500", "DIR"},
                        {"view", "E0500", "DIR"},
                        {"plot", "E0500", "DIR"},
                        {"report", "E0500", "DIR"},
                        {"rig", "E0500", "NAME"},
                        {"calibrate", "E0500", "FILE"},
                        {"sweep", "E0500", "FILE"},
                        {"accuracy", "E0500", "FILE"},
                        {"calibrate missing.toml", "E0433", "missing.toml"},
                        {"sweep missing.toml", "E0433", "missing.toml"},
                        {"accuracy /", "E0432", "/"},
                        {"run --ranks", "E0500", "--ranks"},
                        {"run --ranks many", "E0500", "\"many\""},
                        {"run --keep-every -1", "E0500", "\"-1\""},
                        {"view DIR --frames 1", "E0500", "\"1\""},
                        {"view DIR --frames 2.5", "E0500", "\"2.5\""},
                        {"view DIR --pictures --times soon", "E0500", "\"soon\""},
                        {"run scene.toml --resume DIR", "E0500", "--resume"},
                        {"check scene.toml --ranks 2", "E0500", "--time"},
                        {"check scene.toml --time 0", "E0500", "--time"},
                        {"run missing --large", "E0100", "missing"},
                        {"run " FOOTFALL_SOURCE_DIR "/inputs/rigid_plane --large", "E0100", "large.toml"},
                        {"run --large --resume DIR", "E0500", "--resume"},
                        {"check scene.toml more", "E0500", "more"},
                        {"compare DIR --qiet", "E0500", "\"--quiet\""},
                        {"sweep file.toml --set a=1", "E0500", "is an option of"},
                        {"view DIR --png a.png --camera 400", "E0500", "--camera"},
                        {"check " FOOTFALL_SOURCE_DIR "/docs/tutorials/landing.png", "E0102", "no text file"},
                        {"new other", "E0500", "--from"},
                        {"new other --from whel", "E0508", "\"wheel\""},
                        {"new 'my case' --from wheel", "E0509", "my case"}};
  for (const Line& line : lines) {
    const test::Outcome outcome = folder.footfall(line.line);
    EXPECT_EQ(outcome.exit_code, 2) << line.line;
    EXPECT_TRUE(holds(outcome.text, std::string("[") + line.code)) << line.line << ": " << outcome.text;
    EXPECT_TRUE(holds(outcome.text, line.names)) << line.line << ": " << outcome.text;
    EXPECT_EQ(app::lines_of(outcome.text), 1) << line.line << ": " << outcome.text;
  }
  EXPECT_FALSE(folder.has("other") || folder.has("my case"));
}

// As another user, or without the right to enter the folder that they are in.
TEST_F(Commands, NeedNoFolderToTellOfThemselves) {
  const bool is_root = geteuid() == 0;
  const std::string other = is_root ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  const auto in_closed_folder = [&](const std::string& program, const std::string& words) {
    return folder.shell("rm -rf closed; mkdir closed && cd closed && chmod " + std::string(is_root ? "700" : "0") +
                        " . && " + other + test::RunFolder::program(program) + " " + words);
  };
  if (is_root && folder.shell(other + "test -x " + test::RunFolder::program("footfall")).exit_code != 0)
    GTEST_SKIP() << "another user may not start the programs of this build";
  const std::string programs[] = {"footfall", "footfall_studies", "footfall_campaign", "footfall_import", "mbd_solver"};
  for (const std::string& program : programs)
    for (const std::string word : {"--version", "--help"})
      if (std::filesystem::exists(test::RunFolder::program(program)))  // the first call of `import` builds its program
        EXPECT_EQ(in_closed_folder(program, word).exit_code, 0) << program << " " << word;
  for (const std::string line : {"run", "check", "sweep x.toml", "calibrate x.toml", "needs run"}) {
    const test::Outcome outcome = in_closed_folder("footfall", line);
    EXPECT_EQ(outcome.exit_code, line == "needs run" ? 0 : 2) << line << ": " << outcome.text;
    if (line != "needs run") EXPECT_TRUE(holds(outcome.text, "[E0426 ")) << line << ": " << outcome.text;
  }
  EXPECT_TRUE(holds(in_closed_folder("mbd_solver", "x.toml").text, "[E0426 "));
  folder.shell("chmod 700 closed");  // so that the next test can remove it
}

// Whatever becomes of the standard output, the work is done.
TEST_F(Commands, EndAsTheyWouldWhenNobodyReadsTheirOutput) {
  const std::string run = app::kSliderCrank + " --until 0.02 --out ", footfall = test::RunFolder::program("footfall");
  const std::pair<std::string, std::string> lines[] = {{footfall + " run " + run + "a", "a"},
                                                       {test::RunFolder::program("mbd_solver") + " " + run + "b", "b"},
                                                       {footfall + " check " + app::kInputs + "/rigid_plane", ""}};
  for (const auto& [line, out] : lines)
    for (const std::string where : {" | true", " >&-"}) {
      const std::string closed = where == " >&-" ? where : "";
      const test::Outcome outcome = folder.shell("rm -rf a b; { sleep 0.2; " + line + closed + "; echo code $? >&2; }" +
                                                 (closed.empty() ? where : ""));
      EXPECT_TRUE(holds(outcome.text, "code 0\n")) << line << where << ": " << outcome.text;
      if (!out.empty()) EXPECT_EQ(folder.summary(out)["status"], "done") << line << where;
    }
  EXPECT_TRUE(holds(folder.shell(lines[0].first + " --force > /dev/full").text, "E0519"));
}

TEST_F(Commands, AreCompletedByBash) {
  const std::string program = test::RunFolder::program("footfall");
  const auto completed = [&](const std::string& words) {
    return folder
        .shell("compopt() { :; }; . " + app::kSource + "/packaging/footfall.bash; COMP_WORDS=(" + program + " " +
               words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _footfall; printf '%s\\n' \"${COMPREPLY[@]}\"")
        .text;
  };
  EXPECT_EQ(completed("calib"), "calibrate\n");
  EXPECT_EQ(completed("run --res"), "--resume\n");
}

}  // namespace
}  // namespace footfall
