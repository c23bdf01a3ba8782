// Scenes and scripts that ask for more than a reader takes end with one message, or a list that can be read.
#include <gtest/gtest.h>

#include <algorithm>

#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/particle_script.h"
#include "mbd_solver/scene/toml_file.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

// Before, each had a line, and the search of a near name: 90 s and 300 MB of a million.
TEST(UnknownKeys, AreListedToAHundredAndCounted) {
  std::string keys;
  for (int k = 0; k < 20000; ++k) keys += "key_" + std::to_string(k) + " = 1\n";
  const SceneText text;
  const std::string findings = text.findings(keys + kPendulum);
  EXPECT_EQ(std::count(findings.begin(), findings.end(), '\n'), static_cast<std::ptrdiff_t>(Findings::kMost));
  EXPECT_TRUE(test::names(findings, {"scene.toml:1: key_0: ", "E0103", "and 19900 more errors", "E0137 more-errors"}));
}

TEST(FindingsOfAFile, AreListedToAHundredAndCounted) {
  Findings findings("scene.toml");
  const Source source{"bodies.a", 1, {}, {}, {}};
  const int most = static_cast<int>(Findings::kMost);
  for (int k = 0; k < most; ++k) {
    findings.error(code::kOutOfRange, k, "", "wrong");
    findings.warning(code::kAngleInDegrees, source, "", "odd");
  }
  EXPECT_EQ(findings.error_count(), most);
  EXPECT_EQ(findings.warnings().size(), Findings::kMost);
  EXPECT_EQ(test::error_of([&] { findings.throw_if_errors(); }).find("more"), std::string::npos);
  for (int k = 0; k < 5; ++k) {
    findings.error(code::kOutOfRange, most + k, "", "wrong");
    findings.warning(code::kAngleInDegrees, source, "", "odd");
  }
  EXPECT_EQ(findings.error_count(), most + 5) << "checks that ask whether there was one more still see it";
  EXPECT_TRUE(test::names(test::error_of([&] { findings.throw_if_errors(); }), {"and 5 more errors", "E0137"}));
  EXPECT_EQ(findings.warnings().size(), Findings::kMost + 1);
  EXPECT_TRUE(test::names(findings.warnings().back(), {"and 5 more warnings", "W1172 more-warnings"}));
}

TEST(TomlText, HasFourMillionValuesAtMost) {
  std::string text = "a = [";
  text.reserve(9000000);
  for (int k = 0; k < 4000000; ++k) text += "0,";
  EXPECT_TRUE(test::names(test::error_of([&] { parse_toml(text + "0]", "scene.toml"); }),
                          {"scene.toml: has more than 4000000 values", "E0437"}));
}

// Names of an array's entries are patterns; before, each brace was tried at each place: 10^13 ways of the last one. A joint
// whose kind has no coordinate is told from an unknown joint.
TEST(InitialJoints, FindTheirPatternInOneWay) {
  const SceneText text;
  const auto is_found = [&](const std::string& joint, const std::string& name) {
    std::string toml = kPendulum + "[initial.joints]\n" + name + " = 0.25\n";
    toml.replace(toml.find("hinge"), 5, joint);
    toml.replace(toml.find("revolute"), 8, "spherical");
    return text.findings(toml).find("E0165") != std::string::npos;
  };
  for (const char* good :
       {"left_1_knee", "left_{i}_knee", "{i}_knee", "left{i}", "{i}", "l{i}ft{i}e", "left_1_knee{i}"})
    EXPECT_TRUE(is_found(good, "left_1_knee")) << good;
  for (const char* bad : {"left_1_kne", "left_{i}_hip", "eft{i}", "{i}kne", "left_1_kn{i}nee", "left{i}knee{i}e"})
    EXPECT_FALSE(is_found(bad, "left_1_knee")) << bad;
  std::string pattern;
  for (int k = 0; k < 20; ++k) pattern += "a{i}";
  EXPECT_FALSE(is_found(pattern + "b", std::string(60, 'a')));
}

class Scripts : public ::testing::Test, protected TemporaryFolder {
 protected:
  std::string refused(const std::string& path) {
    return test::error_of([&] { ScriptText script(path, {}); });
  }
};

// 2^20 files: before, hours.
TEST_F(Scripts, ThatIncludeEachOtherTwiceAreRefused) {
  for (int k = 0; k < 20; ++k) {
    const std::string line = "include in." + std::to_string(k + 1) + "\n";
    write("in." + std::to_string(k), line + line);
  }
  write("in.20", "units si\n");
  EXPECT_TRUE(test::names(refused(file("in.0")), {"in.0: has more than 1000 included files", "E0437"}));
  EXPECT_EQ(ScriptText(file("in.14"), {}).commands().size(), 126u + 64u) << "2^6 files at the end";
}

// Each is twice as long as the one before: the 40th has 10 TB.
TEST_F(Scripts, WhoseVariablesDoubleEachOtherAreRefused) {
  std::string text = "variable a0 string 0123456789\n";
  for (int k = 0; k < 40; ++k) {
    const std::string before = "${a" + std::to_string(k) + "}";
    text += "variable a" + std::to_string(k + 1) + " string " + before + before + "\n";
  }
  EXPECT_TRUE(test::names(refused(write("in.script", text)), {"in.script: has more than 64 MB", "E0437"}));
}

TEST_F(Scripts, KeepWhatIsNoVariable) {
  const ScriptText script(write("in.script", "variable a string x\nprint p${a}${none}q${a}$ ${a\n"), {});
  EXPECT_EQ(script.commands().back().words[1], "px${none}qx$");
}

}  // namespace
}  // namespace footfall
