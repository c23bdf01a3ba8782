// What is recommended from a known table of errors, and how the page says it.
#include "mbd_solver/cli/experiments/advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "mbd_solver/cli/experiments/error_page.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;

// Of curve -1: the reference of all.
CaseResult point(int curve, const std::string& value, const std::vector<double>& errors,
                 const std::vector<double>& standard_errors, double cpu) {
  CaseResult p;
  p.plan.curve = curve;
  p.plan.value = value;
  for (std::size_t m = 0; m < errors.size(); ++m) p.figures.push_back({2.0, 0.1, errors[m], standard_errors[m]});
  p.cost.cpu = cpu;
  return p;
}

// Windows: 20 fails, 10 is lucky at 1 %, 5 is not, 2 is. Steps: none is within 1 %, and the coarse one leaves more open
// than 5 %.
ErrorTable known_table() {
  ErrorTable table;
  table.title = "Known";
  table.members = 4;
  table.curves = {"windows", "steps", "rigid"};
  table.defaults = {"5", "", ""};
  table.figures = {"force", "depth"};
  table.references = {point(-1, "reference", {0.0, 0.0}, {0.0, 0.0}, 80.0),
                      point(1, "reference", {0.0, 0.0}, {0.0, 0.0}, 50.0)};
  CaseResult failed = point(0, "20", {0.0, 0.0}, {0.0, 0.0}, 1.0);
  failed.code = 2;
  failed.message = "it left the box";
  table.points = {failed,
                  point(0, "10", {0.008, 0.009}, {0.001, 0.001}, 6.0),
                  point(0, "5", {0.02, 0.001}, {0.001, 0.001}, 10.0),
                  point(0, "2", {0.001, 0.004}, {0.001, 0.002}, 25.0),
                  point(1, "2e-4", {0.02, 0.04}, {0.06, 0.01}, 30.0),
                  point(1, "1e-4", {0.03, 0.02}, {0.001, 0.001}, 40.0),
                  point(2, "false", {0.3, std::numeric_limits<double>::quiet_NaN()}, {0.0, 0.0}, 8.0)};
  return table;
}

TEST(Advice, TakesTheFirstValueFromWhichOnAllErrorsAreWithin) {
  const std::vector<Advice> fine = advice_of(known_table(), 0.01), coarse = advice_of(known_table(), 0.05);
  EXPECT_EQ(fine[0].value, "2");
  EXPECT_EQ(fine[0].figure, "depth");
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
  ErrorTable table = known_table();
  for (CaseResult& p : table.points)
    if (p.code == 0) p.figures[0].error = 0.2;
  const std::vector<Advice> coarse = advice_of(table, 0.05);
  EXPECT_EQ(coarse[0].value, "10");
  EXPECT_EQ(coarse[0].apart, "force");
  EXPECT_DOUBLE_EQ(coarse[0].apart_error, 0.2);
  EXPECT_EQ(coarse[0].figure, "depth");
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

}  // namespace
}  // namespace footfall
