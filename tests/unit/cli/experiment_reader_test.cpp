// What the file of an experiment must hold: mbd_solver/cli/experiments/experiment_reader.cpp.
#include "mbd_solver/cli/experiments/experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;

// What read_experiment says of a file with this text; empty when nothing is wrong.
std::string complaint(const std::string& text) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("footfall_experiment_" + std::to_string(::getpid()) + ".toml"))
          .string();
  std::ofstream(path) << "scene = \"scene.toml\"\n" << text;
  std::string what;
  try {
    read_experiment(path);
  } catch (const InputError& error) {
    what = error.what();
  }
  std::filesystem::remove(path);
  return what;
}

TEST(ReadExperiment, AsksForNoDrawingsUnlessTheFileDoes) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("footfall_drawings_" + std::to_string(::getpid()) + ".toml")).string();
  std::ofstream(path) << "scene = \"scene.toml\"\nsettings = [\"output.vtk=true\"]\n"
                         "[[parameters]]\nname = \"v\"\nsettings = [\"x={value}\"]\nvalues = [1]\n"
                         "[[figures]]\nname = \"m\"\nkey = \"k\"\n";
  // The last word counts.
  EXPECT_EQ(read_experiment(path).settings, (std::vector<std::string>{"output.vtk=false", "output.vtk=true"}));
  std::filesystem::remove(path);
}

TEST(ReadExperiment, TheShortFormOfACurveIsItsFirstValueUnlessTheFileSaysOtherwise) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("footfall_short_" + std::to_string(::getpid()) + ".toml")).string();
  const auto shortened = [&](const std::string& words) {
    std::ofstream(path) << "scene = \"scene.toml\"\n[reference]\n[[curves]]\nname = \"c\"\nsettings = [\"x={value}\"]\n"
                           "values = [1, 2]\n" +
                               words + "[[figures]]\nname = \"m\"\nkey = \"k\"\n";
    return read_experiment(path).curves[0].short_values;
  };
  EXPECT_EQ(shortened(""), std::vector<std::string>{"1"});
  EXPECT_EQ(shortened("short = [2]\n"), std::vector<std::string>{"2"});
  EXPECT_EQ(shortened("short = []\n"), std::vector<std::string>{});
  std::filesystem::remove(path);
}

TEST(ReadExperiment, SaysWhatIsWrongWithCurvesAndFigures) {
  const std::string curve =
      "[reference]\n[[curves]]\nname = \"c\"\nsettings = [\"x={value}\", \"y={beside}\"]\nvalues = [1, 2]\n";
  const std::string figure = "[[figures]]\nname = \"m\"\n";
  EXPECT_EQ(complaint(curve + "beside = [3, 4]\ndefault = 2\n" + figure +
                      "columns = [\"a.b\"]\nreduce = \"largest\"\nover = \"mass\"\n"),
            "");
  EXPECT_THAT(complaint(curve + "beside = [3]\n" + figure + "key = \"k\"\n"),
              HasSubstr("has 1 entries, expected one for each of the 2 values"));
  EXPECT_THAT(complaint(curve + "default = 7\n" + figure + "key = \"k\"\n"),
              HasSubstr("is \"7\", expected one of the values"));
  EXPECT_THAT(complaint(curve + figure),
              HasSubstr("expected one of key (of summary.json), columns (of history.csv) and slope (of the grains)"));
  EXPECT_THAT(
      complaint(curve + figure + "columns = [\"a\"]\nreduce = \"mean\"\n"),
      HasSubstr("is text \"mean\", which is none of the choices. Known choices: max, min, final, largest, drop"));
}

TEST(ReadExperiment, SaysWhatIsWrongWithStatementsAndPrintedFigures) {
  const std::string figure =
      "[[parameters]]\nname = \"speed\"\nvalues = [1, 2]\nsettings = [\"x={value}\"]\n"
      "[[figures]]\nname = \"peak\"\nkey = \"peak_acceleration_g\"\n";
  const std::string statement = figure + "[[statements]]\ntext = \"t\"\nfigure = \"peak\"\n";
  EXPECT_EQ(complaint(statement + "case = \"speed 1\"\nmost = 3\n"), "");
  EXPECT_THAT(complaint(statement + "case = \"speed 1\"\n"), HasSubstr("expected least, most or both"));
  EXPECT_THAT(complaint(statement + "case = \"speed 1\"\nleast = 4\nmost = 3\n"), HasSubstr("is less than least"));
  EXPECT_THAT(complaint(statement + "case = \"speed 7\"\nmost = 3\n"), HasSubstr("there is no case \"speed 7\""));
  EXPECT_THAT(complaint(figure + "[[statements]]\ntext = \"t\"\nfigure = \"force\"\ncase = \"speed 1\"\nmost = 3\n"),
              HasSubstr("\"force\" is not one of [[figures]]"));
  EXPECT_THAT(complaint(figure + "[[printed]]\nname = \"p\"\nvalues = [1, 2]\n"),
              HasSubstr("more values than there are [[figures]]"));
  EXPECT_THAT(complaint(figure + "[[printed]]\nname = \"p\"\nvalues = [\"much\"]\n"),
              HasSubstr("\"much\" is not a number"));
  EXPECT_THAT(complaint(figure + "[[figures]]\nname = \"f\"\ncolumns = [\"x\"]\nreduce = \"mean\"\n"),
              HasSubstr("which is none of the choices"));
  EXPECT_THAT(complaint(figure + "[[figures]]\nname = \"f\"\nkey = \"x\"\naverage = true\n"),
              HasSubstr("expected at least two columns"));
}

TEST(ReadExperiment, SaysWhatIsWrongWithWaysToEnd) {
  const std::string curve = "[[curves]]\nname = \"c\"\nsettings = [\"x={value}\"]\nvalues = [1, 2]\n";
  EXPECT_EQ(complaint(curve + "ends = [\"stopped\", \"warned\"]\n"), "");
  EXPECT_EQ(complaint("[[curves]]\nname = \"c\"\nends = \"stopped\"\n"), "");  // one run
  EXPECT_THAT(complaint(curve + "ends = \"broken\"\n"), HasSubstr("expected accurate, warned, stopped or refused"));
  EXPECT_THAT(complaint(curve + "ends = [\"warned\", \"warned\", \"warned\"]\n"), HasSubstr("or one per value"));
  EXPECT_THAT(complaint(curve + "ends = \"warned\"\ncolumns = \"a\"\n"), HasSubstr("without a reference"));
  EXPECT_THAT(complaint(curve + "ends = \"warned\"\n[[curves]]\nname = \"d\"\nvalues = 1\n"),
              HasSubstr("expected ends for all curves, or for none"));
}

TEST(ReadExperiment, ExpectationsOfACurveAreOrdersOrErrors) {
  const std::string curve =
      "[reference]\n[[curves]]\nname = \"c\"\nvalues = [1, 2]\n[[figures]]\nname = \"f\"\nkey = \"k\"\n"
      "[[expect]]\nfigure = \"f\"\ncurve = \"c\"\n";
  EXPECT_EQ(complaint(curve + "order = [1.9, 2.1]\n"), "");
  EXPECT_EQ(complaint(curve + "error = 0.1\n"), "");
  EXPECT_THAT(complaint(curve), HasSubstr("expected order = [least, most] or error = most"));
  EXPECT_THAT(complaint(curve + "order = 2\n"), HasSubstr("order: expected [least, most]"));
  EXPECT_THAT(complaint(curve + "error = 0.1\n[[expect]]\nfigure = \"f\"\ncurve = \"e\"\nerror = 1\n"),
              HasSubstr("unknown curve \"e\""));
}

}  // namespace
}  // namespace footfall
