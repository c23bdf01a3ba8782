// mbd_solver/app/needed_parts.h: what a command line needs, from the files that it names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "mbd_solver/app/needed_parts.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Words = std::vector<std::string>;

const std::string kEngine = "[[signals]]\nname = \"engine\"\nkind = \"fmu\"\nfile = \"engine.fmu\"\n";
const std::string kConstant = "[[signals]]\nname = \"engine\"\nkind = \"constant\"\nvalue = 1\n";

class NeededParts : public ::testing::Test, protected TemporaryFolder {
 protected:
  // Of `footfall run` with a scene of this text.
  Words of_scene(const std::string& text) const { return needed_parts({"run", write("a scene/scene.toml", text)}); }
};

TEST_F(NeededParts, OfASceneWithoutSuchSignalsAreNone) {
  EXPECT_THAT(of_scene(""), IsEmpty());
  EXPECT_THAT(of_scene("end_time = 1\n" + kConstant), IsEmpty());
  EXPECT_THAT(of_scene("# kind = \"fmu\"\n[[signals]] # kind = \"fmu\"\nname = 'kind = \"fmu\"'\n"), IsEmpty());
  EXPECT_THAT(of_scene("title = \"\"\"\n[[signals]]\nkind = \"fmu\"\n\"\"\"\n"), IsEmpty());
  EXPECT_THAT(of_scene("[[joints]]\nkind = \"fmu\"\n"), IsEmpty()) << "no signal";
  EXPECT_THAT(of_scene("signals = \"fmu\"\n"), IsEmpty());
}

TEST_F(NeededParts, OfASignalFromAnFmuAreFmiHoweverItIsWritten) {
  for (const std::string& text :
       {kEngine, kConstant + kEngine, std::string("signals = [{ name = \"e\", kind = \"fmu\", file = \"e.fmu\" }]\n"),
        std::string("[[signals]]\nkind = 'fmu'\n"), std::string("[[signals]]\n\"kind\"=\"\"\"fmu\"\"\"\n"),
        std::string("[[signals]]\ntype = \"fmu\"\n")})
    EXPECT_THAT(of_scene(text), ElementsAre("fmi")) << text;
}

TEST_F(NeededParts, AreThoseOfTheBases) {
  write("engine/scene.toml", kEngine);
  write("middle.toml", "base = \"engine\"\n");
  const std::string top = write("deep/top.toml", "base = \"../middle.toml\"\nend_time = 2\n");
  EXPECT_THAT(needed_parts({"run", top}), ElementsAre("fmi"));
  // What the scene replaces or leaves out, it does not need.
  EXPECT_THAT(needed_parts({"run", write("plain.toml", "base = \"engine\"\n" + kConstant)}), IsEmpty());
  EXPECT_THAT(needed_parts({"run", write("none.toml", "base = \"engine\"\nwithout = [\"signals\"]\n")}), IsEmpty());
}

TEST_F(NeededParts, OfFilesThatCannotBeReadAreNone) {
  EXPECT_THAT(of_scene("base = \".\"\n" + kEngine), IsEmpty()) << "a base that leads back to itself";
  EXPECT_THAT(of_scene("base = \"missing\"\n" + kEngine), IsEmpty());
  EXPECT_THAT(of_scene(kEngine + "end_time = \n"), IsEmpty()) << "no TOML";
  EXPECT_THAT(needed_parts({"run", file("missing.toml")}), IsEmpty());
  EXPECT_THAT(needed_parts({"run", folder_.string()}), IsEmpty()) << "a folder without a scene.toml";
  EXPECT_THAT(needed_parts({"run", "/dev/zero"}), IsEmpty());
  EXPECT_THAT(needed_parts({"sweep", file("missing.toml")}), IsEmpty());
  EXPECT_THAT(needed_parts({"run", "--resume", folder_.string()}), IsEmpty());
}

TEST_F(NeededParts, OfALineWithoutASceneAreNone) {
  for (const Words& words : {Words{}, Words{"run"}, Words{"run", "--until", "1"}, Words{"--help"}, Words{"run", ""}})
    EXPECT_THAT(needed_parts(words), IsEmpty());
}

TEST_F(NeededParts, CountEveryWordThatNamesAFile) {
  write("engine/scene.toml", kEngine);
  const std::string engine = file("engine");
  EXPECT_THAT(needed_parts({"run", engine}), ElementsAre("fmi"));
  EXPECT_THAT(needed_parts({"run", "--until", "1", "--quiet", engine + "/scene.toml"}), ElementsAre("fmi"));
  EXPECT_THAT(needed_parts({"check", engine, "--time=1"}), ElementsAre("fmi"));
  EXPECT_THAT(needed_parts({"fmu", engine, "--out", "engine.fmu"}), ElementsAre("fmi"));
  EXPECT_THAT(needed_parts({"new", "mine", "--from=" + engine}), ElementsAre("fmi"));
}

TEST_F(NeededParts, FollowTheSettingsOfTheLine) {
  const std::string scene = write("scene.toml", kConstant), engine = write("engine.toml", kEngine);
  EXPECT_THAT(needed_parts({"run", scene, "--set", "signals.engine.kind=fmu"}), ElementsAre("fmi"));
  EXPECT_THAT(needed_parts({"run", "--set=signals.engine.type='fmu'", scene}), ElementsAre("fmi"));
  EXPECT_THAT(needed_parts({"run", scene, "--set", "title=\"fmu\"", "--set", "nonsense"}), IsEmpty());
  EXPECT_THAT(needed_parts({"run", engine, "--set", "signals.engine.kind=constant"}), IsEmpty());
}

TEST_F(NeededParts, OfAResumedRunAreThoseOfItsScene) {
  const std::string scene = write("scene.toml", kConstant);
  write("run/summary.json", "{ \"scene_file\": \"" + scene + "\", \"settings\": [\"signals.engine.kind=fmu\"] }");
  EXPECT_THAT(needed_parts({"run", "--resume", file("run")}), ElementsAre("fmi"));
  write("run/summary.json", "{ \"scene_file\": \"" + scene + "\", \"settings\": [] }");
  EXPECT_THAT(needed_parts({"run", "--resume=" + file("run")}), IsEmpty());
  write("run/summary.json", "{ \"settings\": 3");
  EXPECT_THAT(needed_parts({"run", "--resume", file("run")}), IsEmpty());
}

TEST_F(NeededParts, OfAStudyAreThoseOfItsScenes) {
  write("scenes/engine/scene.toml", kEngine);
  write("scenes/plain.toml", kConstant);
  const auto of = [&](const std::string& command, const std::string& text) {
    return needed_parts({command, write("study.toml", text)});
  };
  for (const std::string command : {"sweep", "accuracy"}) {
    EXPECT_THAT(of(command, "scene = \"scenes/engine\"\n[[parameters]]\nname = \"p\"\n"), ElementsAre("fmi"));
    EXPECT_THAT(of(command, "scene = \"scenes/plain.toml\"\n"), IsEmpty());
    EXPECT_THAT(of(command, "# scene = \"scenes/engine\"\nscene = \"scenes/missing\"\n"), IsEmpty());
  }
  EXPECT_THAT(of("accuracy", "[[curves]]\nscene = \"scenes/plain.toml\"\n[[curves]]\nscene = \"scenes/engine\"\n"),
              ElementsAre("fmi"));
  EXPECT_THAT(of("calibrate", "[[scenes]]\nname = \"a\"\nscene = \"scenes/engine\"\n[[targets]]\nscene = \"a\"\n"),
              ElementsAre("fmi"));
  EXPECT_THAT(needed_parts({"ground", "fit", write("study.toml", "scene = \"scenes/engine/scene.toml\"\n")}),
              ElementsAre("fmi"));
  EXPECT_THAT(needed_parts({"rig", "plate", "--file=" + file("study.toml")}), ElementsAre("fmi"));
  EXPECT_THAT(of("sweep",
                 "scene = \"scenes/plain.toml\"\n[[parameters]]\nname = \"p\"\n"
                 "choices = [{ name = \"a\", settings = [\"signals.engine.kind=\\\"fmu\\\"\"] }]\n"),
              ElementsAre("fmi"));
}

TEST_F(NeededParts, OfDrawnRunsAreACampaign) {
  write("engine/scene.toml", kEngine);
  const std::string drawn = write("drawn.toml", "scene = \"engine\"\nruns = 10\n"),
                    listed = write("listed.toml", "scene = \"none\"\n# runs = 10\n[check]\nruns = 3\n");
  EXPECT_THAT(needed_parts({"sweep", drawn}), ElementsAre("campaign", "fmi"));
  EXPECT_THAT(needed_parts({"sweep", "--jobs", "2", drawn, "--list"}), ElementsAre("campaign", "fmi"));
  EXPECT_THAT(needed_parts({"sweep", listed}), IsEmpty());
  EXPECT_THAT(needed_parts({"accuracy", drawn}), ElementsAre("fmi")) << "it refuses drawn runs";
}

TEST_F(NeededParts, OfANewCaseFromARobotAreTheImport) {
  EXPECT_THAT(needed_parts({"new", "arm", "--from", "robots/arm.urdf"}), ElementsAre("import"));
  EXPECT_THAT(needed_parts({"new", "arm", "--from=arm.xml"}), ElementsAre("import"));
  EXPECT_THAT(needed_parts({"new", "arm", "--from", "wheel"}), IsEmpty());
  EXPECT_THAT(needed_parts({"new", "arm.urdf"}), IsEmpty());
  EXPECT_THAT(needed_parts({"run", "--from", "arm.urdf"}), IsEmpty());
}

// Every scene and study that comes with the program, in a time that nobody waits for.
TEST_F(NeededParts, OfShippedFilesAreFoundAtOnce) {
  constexpr double kAtMost = 0.3;  // [s], of one file, on a busy machine
  const std::filesystem::path inputs = FOOTFALL_SOURCE_DIR "/inputs";
  EXPECT_THAT(needed_parts({"run", (inputs / "landing_mr").string()}), IsEmpty());
  EXPECT_THAT(needed_parts({"run", (inputs / "reference").string()}), ElementsAre("fmi"));
  EXPECT_THAT(needed_parts({"sweep", (inputs / "sweeps/touchdowns.toml").string()}), ElementsAre("campaign"));
  EXPECT_THAT(needed_parts({"sweep", (inputs / "sweeps/soils.toml").string()}), IsEmpty());
  for (const auto& entry : std::filesystem::recursive_directory_iterator(inputs)) {
    if (entry.path().extension() != ".toml") continue;
    const auto start = std::chrono::steady_clock::now();
    needed_parts({"sweep", entry.path().string()});
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), kAtMost) << entry.path();
  }
}

}  // namespace
}  // namespace footfall
