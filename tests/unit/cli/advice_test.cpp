// What is recommended from a known table of errors, and how the page says it.
#include "mbd_solver/cli/experiments/advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

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
  p.plan.is_reference = value == "reference";
  for (std::size_t m = 0; m < errors.size(); ++m) p.figures.push_back({2.0, 0.1, errors[m], standard_errors[m]});
  p.cost.cpu = cpu;
  return p;
}

struct Known {
  ExperimentSpec spec;
  Results results;
};

// Windows: 20 fails, 10 is lucky at 1 %, 5 is not, 2 is. Steps: none is within 1 %, and the coarse one leaves more open
// than 5 %.
Known known_errors() {
  Known known;
  known.spec.title = "Known";
  known.spec.curves.resize(3);
  known.spec.curves[0].name = "windows";
  known.spec.curves[0].default_value = "5";
  known.spec.curves[1].name = "steps";
  known.spec.curves[2].name = "rigid";
  known.spec.figures.resize(2);
  known.spec.figures[0].name = "force";
  known.spec.figures[1].name = "depth";
  known.results.members = 4;
  CaseResult failed = point(0, "20", {0.0, 0.0}, {0.0, 0.0}, 1.0);
  failed.code = 2;
  failed.message = "it left the box";
  known.results.cases = {point(-1, "reference", {0.0, 0.0}, {0.0, 0.0}, 80.0),
                         point(1, "reference", {0.0, 0.0}, {0.0, 0.0}, 50.0),
                         failed,
                         point(0, "10", {0.008, 0.009}, {0.001, 0.001}, 6.0),
                         point(0, "5", {0.02, 0.001}, {0.001, 0.001}, 10.0),
                         point(0, "2", {0.001, 0.004}, {0.001, 0.002}, 25.0),
                         point(1, "2e-4", {0.02, 0.04}, {0.06, 0.01}, 30.0),
                         point(1, "1e-4", {0.03, 0.02}, {0.001, 0.001}, 40.0),
                         point(2, "false", {0.3, std::numeric_limits<double>::quiet_NaN()}, {0.0, 0.0}, 8.0)};
  return known;
}

TEST(Advice, TakesTheFirstValueFromWhichOnAllErrorsAreWithin) {
  const Known k = known_errors();
  const std::vector<Advice> fine = advice_of(k.spec, k.results, 0.01), coarse = advice_of(k.spec, k.results, 0.05);
  EXPECT_TRUE(fine[0].within);
  EXPECT_EQ(fine[0].point->plan.value, "2");
  EXPECT_EQ(k.spec.figures[fine[0].worst].name, "depth");
  EXPECT_DOUBLE_EQ(fine[0].largest().error, 0.004);
  EXPECT_DOUBLE_EQ(fine[0].largest().standard_error, 0.002);
  EXPECT_DOUBLE_EQ(fine[0].time_ratio, 2.5);  // over the default, 5
  EXPECT_EQ(coarse[0].point->plan.value, "10");
  EXPECT_DOUBLE_EQ(coarse[0].time_ratio, 0.6);
}

TEST(Advice, SaysWhenNoneIsWithinAndWhenTheSamplesLeaveMoreOpen) {
  const Known k = known_errors();
  const std::vector<Advice> fine = advice_of(k.spec, k.results, 0.01), coarse = advice_of(k.spec, k.results, 0.05);
  EXPECT_FALSE(fine[1].within);
  EXPECT_EQ(fine[1].point->plan.value, "1e-4");
  EXPECT_TRUE(fine[1].resolved);
  EXPECT_TRUE(coarse[1].within);
  EXPECT_EQ(coarse[1].point->plan.value, "2e-4");
  EXPECT_FALSE(coarse[1].resolved);
  EXPECT_DOUBLE_EQ(coarse[1].time_ratio, 0.6);  // over the reference of its own
  EXPECT_EQ(coarse[2].point, nullptr);          // an error that is no number is not within
}

TEST(Advice, LeavesOutOneMeasureThatNoValueKeepsWithin) {
  Known k = known_errors();
  for (CaseResult& p : k.results.cases)
    if (p.code == 0) p.figures[0].error = 0.2;
  const std::vector<Advice> coarse = advice_of(k.spec, k.results, 0.05);
  EXPECT_EQ(coarse[0].point->plan.value, "10");
  EXPECT_EQ(k.spec.figures[coarse[0].apart].name, "force");
  EXPECT_EQ(k.spec.figures[coarse[0].worst].name, "depth");
  EXPECT_DOUBLE_EQ(coarse[0].largest().error, 0.009);
}

TEST(Advice, LinesOfThePage) {
  const Known k = known_errors();
  const std::string page = recommendations(k.spec, k.results);
  EXPECT_THAT(page, HasSubstr("| windows | 2 | 0.4 ± 0.2 %, depth | 2.50 | 10 | 0.9 ± 0.1 %, depth | 0.60 |\n"));
  EXPECT_THAT(
      page,
      HasSubstr(
          "| steps | none; best is 1e-4 | 3 ± 0.1 %, force | 0.80 | 2e-4 (not resolved) | 4 ± 1 %, depth | 0.60 |\n"));
  EXPECT_THAT(page, HasSubstr("| rigid | none was done |  |  | none was done |  |  |\n"));
  EXPECT_THAT(page, HasSubstr("the largest error is that of \"windows\": 2 ± 0.1 % of force at 5."));
  EXPECT_THAT(page, HasSubstr("scatter by 5 % (force), 5 % (depth);\nof a mean of 4 by 0.50 times that."));
}

}  // namespace
}  // namespace footfall
