// Studies: figures of an ensemble and their errors, what is recommended from a known table, what a file must hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/experiments/study.h"
#include "mbd_solver/cli/experiments/study_advice.h"
#include "mbd_solver/cli/experiments/study_error.h"
#include "mbd_solver/cli/experiments/study_page.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;

TEST(SampledFigure, ErrorIsOfTheMeanAndItsScatterThatOfTheDifferences) {
  // Samples far apart that all change by the same: the error is known exactly, however large the spread.
  const SampledFigure same = sampled_figure({11.0, 21.0, 31.0}, {10.0, 20.0, 30.0});
  EXPECT_DOUBLE_EQ(same.mean, 21.0);
  EXPECT_DOUBLE_EQ(same.spread, 10.0);
  EXPECT_DOUBLE_EQ(same.error, 0.05);
  EXPECT_DOUBLE_EQ(same.standard_error, 0.0);
  // Differences -1, 1, 3: mean 1, deviation 2, standard error 2 / sqrt(3), of 20.
  const SampledFigure other = sampled_figure({9.0, 21.0, 33.0}, {10.0, 20.0, 30.0});
  EXPECT_DOUBLE_EQ(other.error, 0.05);
  EXPECT_NEAR(other.standard_error, 2.0 / std::sqrt(3.0) / 20.0, 1e-15);
  EXPECT_DOUBLE_EQ(sampled_figure({3.0}, {2.0}).standard_error, 0.0);
}

TEST(FigureOf, ReadsReducedColumnsOverAKeyOfTheSummary) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "footfall_study_test";
  fs::create_directories(folder);
  std::ofstream(folder / "summary.json") << "{\"reference_energy_J\": 50.0}\n";
  std::ofstream(folder / "history.csv") << "# units: s,J\ntime,work.contact\n0,0\n0.1,-20\n0.2,-10\n";
  MeasureSpec measure;
  measure.kind = MeasureKind::kFigure;
  measure.figure.columns = {"work.contact"};
  measure.figure.reduction = Reduction::kLargest;
  measure.figure.over = "reference_energy_J";
  StudyRun run;
  run.folder = folder.string();
  EXPECT_DOUBLE_EQ(figure_of(measure, run), 0.4);
  fs::remove_all(folder);
}

StudyPoint point(const std::string& curve, const std::string& value, std::vector<double> errors,
                 std::vector<double> standard_errors, double cpu) {
  StudyPoint p;
  p.curve = curve;
  p.value = value;
  p.errors = std::move(errors);
  for (std::size_t m = 0; m < p.errors.size(); ++m) p.sampled.push_back({2.0, 0.1, p.errors[m], standard_errors[m]});
  p.cpu = cpu;
  return p;
}

// Windows: 20 fails, 10 is lucky at 1 %, 5 is not, 2 is. Steps: none is within 1 %, and the coarse one leaves more open
// than 5 %.
StudyTable known_table() {
  StudyTable table;
  table.title = "Known";
  table.members = 4;
  table.curves = {"windows", "steps", "rigid"};
  table.defaults = {"5", "", ""};
  table.measures = {"force", "depth"};
  table.references = {point("reference", "reference", {0.0, 0.0}, {0.0, 0.0}, 80.0),
                      point("steps", "reference", {0.0, 0.0}, {0.0, 0.0}, 50.0)};
  StudyPoint failed = point("windows", "20", {0.0, 0.0}, {0.0, 0.0}, 1.0);
  failed.code = 2;
  failed.message = "it left the box";
  table.points = {failed,
                  point("windows", "10", {0.008, 0.009}, {0.001, 0.001}, 6.0),
                  point("windows", "5", {0.02, 0.001}, {0.001, 0.001}, 10.0),
                  point("windows", "2", {0.001, 0.004}, {0.001, 0.002}, 25.0),
                  point("steps", "2e-4", {0.02, 0.04}, {0.06, 0.01}, 30.0),
                  point("steps", "1e-4", {0.03, 0.02}, {0.001, 0.001}, 40.0),
                  point("rigid", "false", {0.3, std::numeric_limits<double>::quiet_NaN()}, {0.0, 0.0}, 8.0)};
  return table;
}

TEST(Advice, TakesTheFirstValueFromWhichOnAllErrorsAreWithin) {
  const std::vector<Advice> fine = advice_of(known_table(), 0.01), coarse = advice_of(known_table(), 0.05);
  EXPECT_EQ(fine[0].value, "2");
  EXPECT_EQ(fine[0].measure, "depth");
  EXPECT_DOUBLE_EQ(fine[0].error, 0.004);
  EXPECT_DOUBLE_EQ(fine[0].standard_error, 0.002);
  EXPECT_DOUBLE_EQ(fine[0].time_ratio, 2.5);  // over the default, 5
  EXPECT_EQ(coarse[0].value, "10");
  EXPECT_DOUBLE_EQ(coarse[0].time_ratio, 0.6);
}

TEST(Advice, SaysWhenNoneIsWithinAndWhenTheSamplesLeaveMoreOpen) {
  const std::vector<Advice> fine = advice_of(known_table(), 0.01), coarse = advice_of(known_table(), 0.05);
  EXPECT_EQ(fine[1].value, "");
  EXPECT_EQ(fine[1].best, "1e-4");
  EXPECT_TRUE(fine[1].resolved);
  EXPECT_EQ(coarse[1].value, "2e-4");
  EXPECT_FALSE(coarse[1].resolved);
  EXPECT_DOUBLE_EQ(coarse[1].time_ratio, 0.6);  // over the reference of its own
  EXPECT_EQ(coarse[2].best, "");                // an error that is no number is not within
}

TEST(Advice, LeavesOutOneMeasureThatNoValueKeepsWithin) {
  StudyTable table = known_table();
  for (StudyPoint& p : table.points)
    if (p.code == 0) p.errors[0] = 0.2;
  const std::vector<Advice> coarse = advice_of(table, 0.05);
  EXPECT_EQ(coarse[0].value, "10");
  EXPECT_EQ(coarse[0].apart, "force");
  EXPECT_DOUBLE_EQ(coarse[0].apart_error, 0.2);
  EXPECT_EQ(coarse[0].measure, "depth");
  EXPECT_DOUBLE_EQ(coarse[0].error, 0.009);
}

TEST(Advice, LinesOfThePage) {
  std::ostringstream page;
  write_recommendations(page, known_table());
  EXPECT_THAT(page.str(), HasSubstr("| windows | 2 | 0.4 ± 0.2 %, depth | 2.50 | 10 | 0.9 ± 0.1 %, depth | 0.60 |\n"));
  EXPECT_THAT(
      page.str(),
      HasSubstr(
          "| steps | none; best is 1e-4 | 3 ± 0.1 %, force | 0.80 | 2e-4 (not resolved) | 4 ± 1 %, depth | 0.60 |\n"));
  EXPECT_THAT(page.str(), HasSubstr("| rigid | none was done | | | none was done | | |\n"));
  EXPECT_THAT(page.str(), HasSubstr("the largest error is that of \"windows\": 2 ± 0.1 % of force at 5."));
  EXPECT_THAT(page.str(), HasSubstr("scatter by 5 % (force), 5 % (depth);\nof a mean of 4 by 0.50 times that."));
}

// What read_study says of a file that ends in `tail`.
std::string complaint(const std::string& tail) {
  const std::string path = (std::filesystem::temp_directory_path() / "footfall_study_test.toml").string();
  std::ofstream(path) << "scene = \"scene.toml\"\n[reference]\nsettings = []\n" << tail;
  std::string what;
  try {
    read_study(path);
  } catch (const InputError& error) {
    what = error.what();
  }
  std::filesystem::remove(path);
  return what;
}

TEST(ReadStudy, SaysWhatIsWrongWithCurvesAndFigures) {
  const std::string curve = "[[curves]]\nname = \"c\"\nsettings = [\"x={value}\", \"y={beside}\"]\nvalues = [1, 2]\n";
  const std::string measure = "[[measures]]\nname = \"m\"\nkind = \"figure\"\n";
  EXPECT_EQ(complaint(curve + "beside = [3, 4]\ndefault = 2\n" + measure +
                      "columns = [\"a.b\"]\nreduce = \"largest\"\nover = \"mass\"\n"),
            "");
  EXPECT_THAT(complaint(curve + "beside = [3]\n" + measure + "key = \"k\"\n"),
              HasSubstr("has 1 entries, expected one for each of the 2 values"));
  EXPECT_THAT(complaint(curve + "default = 7\n" + measure + "key = \"k\"\n"),
              HasSubstr("is \"7\", expected one of the values"));
  EXPECT_THAT(complaint(curve + measure),
              HasSubstr("expected either key (of summary.json) or columns (of history.csv)"));
  EXPECT_THAT(complaint(curve + measure + "columns = [\"a\"]\nreduce = \"mean\"\n"),
              HasSubstr("is \"mean\", expected max, min, final, largest, drop, peaks or variation"));
}

TEST(SettingsOf, FillsBothMarksOfAValue) {
  CurveSpec curve;
  curve.settings = {"dt={value}", "every={beside}"};
  curve.values = {"1e-4", "5e-5"};
  curve.beside = {"3", "6"};
  EXPECT_THAT(settings_of(curve, "5e-5"), ::testing::ElementsAre("dt=5e-5", "every=6"));
}

}  // namespace
}  // namespace footfall
