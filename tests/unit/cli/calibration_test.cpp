// What the file of a calibration must hold: mbd_solver/cli/calibrate/calibration_reader.cpp.
#include "mbd_solver/cli/calibrate/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;

const std::string kParameter = "[[parameters]]\nname = \"k\"\nsettings = [\"a={value}\"]\nleast = 1\nmost = 4\n";
const std::string kRest =
    "[[figures]]\nname = \"m\"\nkey = \"q\"\n[[targets]]\nfigure = \"m\"\nvalue = 3\ntolerance = 0.1\n"
    "[[stages]]\nmethod = \"bobyqa\"\nevaluations = 10\n";

CalibrationSpec read_text(const std::string& text) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("footfall_calibration_" + std::to_string(::getpid()) + ".toml"))
          .string();
  std::ofstream(path) << "scene = \"scene.toml\"\n" << text;
  const std::unique_ptr<const std::string, void (*)(const std::string*)> gone(
      &path, [](const std::string* file) { std::filesystem::remove(*file); });
  return read_calibration(path);
}

std::string complaint(const std::string& text) {
  try {
    read_text(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadCalibration, TakesAParameterWithItsScale) {
  CalibrationSpec s = read_text(kParameter + "scale = \"logarithmic\"\nstart = 1\n" + kRest);
  const SoughtParameter& p = s.parameters.front();
  EXPECT_DOUBLE_EQ(p.value(0.5), 2.0);
  EXPECT_DOUBLE_EQ(p.share(2.0), 0.5);
  EXPECT_DOUBLE_EQ(p.value(1.0), 4.0);
  EXPECT_EQ(start_of(s), (Shares{0.0}));
  EXPECT_EQ(s.targets.front().name, "m, run");  // the only scene
}

TEST(ReadCalibration, PutsFormulasIntoSettings) {
  const CalibrationSpec s = read_text("settings = [\"b={= 2*k + 1}\", \"c=[{= k}, {= -k}]\"]\n" + kParameter + kRest);
  EXPECT_EQ(with_formulas({"x={= 2*k}", "leg_{leg}=1"}, s, {1.0}), (std::vector<std::string>{"x=8", "leg_{leg}=1"}));
  EXPECT_THAT(complaint("settings = [\"b={= 2*kk}\"]\n" + kParameter + kRest),
              HasSubstr("unknown parameter \"kk\". Known parameters: k."));
  EXPECT_THAT(complaint("settings = [\"b={= 2*k\"]\n" + kParameter + kRest), HasSubstr("does not end; expected }"));
}

TEST(ReadCalibration, SaysWhatIsWrongWithParameters) {
  const auto with = [](const std::string& keys) { return complaint("[[parameters]]\n" + keys + kRest); };
  EXPECT_THAT(with("name = \"k\"\nleast = 1\nmost = 2\n"), HasSubstr("it changes nothing"));
  EXPECT_THAT(with("name = \"k\"\nsettings = [\"a=1\"]\nleast = 1\nmost = 2\n"), HasSubstr("hold no {value}"));
  EXPECT_THAT(with("name = \"my k\"\nsettings = [\"a={value}\"]\nleast = 1\nmost = 2\n"),
              HasSubstr("formulas read it"));
  EXPECT_THAT(with("name = \"k\"\nsettings = [\"a={value}\"]\nleast = 2\nmost = 2\n"),
              HasSubstr("more than least = 2"));
  EXPECT_THAT(with("name = \"k\"\nsettings = [\"a={value}\"]\nleast = 0\nmost = 2\nscale = \"logarithmic\"\n"),
              HasSubstr("expected more than 0 on a logarithmic scale"));
  EXPECT_THAT(complaint(kParameter + "start = 9\n" + kRest), HasSubstr("between least and most"));
  EXPECT_THAT(complaint(kParameter + kParameter + kRest), HasSubstr("two are named \"k\""));
}

TEST(ReadCalibration, SaysWhatIsWrongWithTargetsAndConstraints) {
  const std::string target = "[[targets]]\nfigure = \"m\"\nname = \"t\"\ntolerance = 1\n";
  EXPECT_THAT(complaint(kParameter + kRest + target), HasSubstr("expected either value, or least, most or both"));
  EXPECT_THAT(complaint(kParameter + kRest + target + "value = 1\nleast = 0\n"), HasSubstr("expected either value"));
  EXPECT_THAT(complaint(kParameter + kRest + target + "least = 3\nmost = 2\n"), HasSubstr("is less than least"));
  EXPECT_THAT(complaint(kParameter + kRest + target + "value = 1\nscene = \"x\"\n"),
              HasSubstr("\"x\" is not one of [[scenes]]"));
  EXPECT_THAT(complaint(kParameter + kRest + "[[targets]]\nfigure = \"n\"\nvalue = 1\ntolerance = 1\n"),
              HasSubstr("\"n\" is not one of [[figures]]"));
  EXPECT_THAT(complaint(kParameter + kRest + "[[targets]]\ncolumn = \"a.b\"\nfile = \"none.csv\"\ntolerance = 1\n"),
              HasSubstr("none.csv"));
  EXPECT_THAT(complaint(kParameter + kRest + "[[constraints]]\nname = \"c\"\nformula = \"k*k\"\n"),
              HasSubstr("expected least, most or both"));
  EXPECT_THAT(complaint(kParameter + kRest + "[[constraints]]\nname = \"c\"\nformula = \"k*k\"\nmost = 2\n"),
              HasSubstr("the start breaks one"));
  EXPECT_THAT(complaint(kParameter + kRest + "[seeds]\nsettings = [\"s={value}\"]\nvalues = [1, 2]\nsearch = 3\n"),
              HasSubstr("expected at most the number of values, 2"));
}

TEST(ReadCalibration, MeasuresABrokenConstraint) {
  const CalibrationSpec s =
      read_text(kParameter + kRest + "[[constraints]]\nname = \"c\"\nformula = \"k*k\"\nmost = 8\n");
  EXPECT_DOUBLE_EQ(broken_by(s, {0.5}), 0.0);  // 2.5^2
  EXPECT_DOUBLE_EQ(broken_by(s, {1.0}), 1.0);  // 16 over 8
}

TEST(CalibrationSchema, HoldsTheKeysOfEverySection) {
  const nlohmann::json s = nlohmann::json::parse(calibration_schema())["properties"];
  EXPECT_TRUE(s["parameters"]["items"]["properties"]["scale"].contains("enum"));
  for (const char* key : {"value", "least", "against", "file", "tolerance", "weight"})
    EXPECT_TRUE(s["targets"]["items"]["properties"].contains(key)) << key;
  for (const char* section : {"scenes", "seeds", "stages", "limits", "figures", "constraints"})
    EXPECT_TRUE(s.contains(section)) << section;
}

TEST(ShippedCalibrations, CanBeRead) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/calibrations")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(read_calibration(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 4);
}

// 24 statements, and the two numbers of Table 2 beside them.
TEST(ShippedCalibrations, OfThePaperHoldsEveryStatement) {
  const CalibrationSpec s = read_calibration(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/calibrations/paper.toml");
  EXPECT_EQ(s.targets.size(), 26u);
  double weights = 0.0;
  for (const TargetSpec& target : s.targets) weights += target.weight;
  EXPECT_DOUBLE_EQ(weights, 24.5);
}

}  // namespace
}  // namespace footfall
