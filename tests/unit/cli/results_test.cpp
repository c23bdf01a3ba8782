// What known runs say: means of cases, limits and ranking, and whether statements come out.
#include "mbd_solver/cli/experiments/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

using ::testing::ElementsAre;

// Speeds 1 and 2 over two seeds; the figure is the peak.
class ResultsTest : public ::testing::Test {
 protected:
  ResultsTest() {
    spec_.scene = "scene.toml";
    ParameterSpec speed, seed;
    speed.name = "speed";
    speed.choices = {{"1", "", {}}, {"2", "", {}}};
    seed.name = "seed";
    seed.choices = {{"7", "", {}}, {"8", "", {}}};
    seed.ensemble = true;
    spec_.parameters = {speed, seed};
    spec_.figures.resize(1);
    spec_.figures[0].name = "peak";
    plan_ = plan_of(spec_, false);
    for (const double peak : {4.0, 6.0, 9.0, 11.0}) {
      RunResult run;
      run.figures = {peak};
      run.end.cost.cpu = 2.0 * peak;
      runs_.push_back(run);
    }
  }
  std::vector<Outcome> outcomes(const StatementSpec& statement) {
    spec_.statements = {statement};
    return outcomes_of(spec_, cases_of(spec_, plan_, runs_));
  }

  ExperimentSpec spec_;
  Plan plan_;
  std::vector<RunResult> runs_;
};

TEST_F(ResultsTest, ACaseIsTheMeanOfItsSamples) {
  const std::vector<CaseResult> cases = cases_of(spec_, plan_, runs_);
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_DOUBLE_EQ(cases[0].figures[0].mean, 5.0);
  EXPECT_DOUBLE_EQ(cases[0].figures[0].spread, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(cases[1].cost.cpu, 20.0);
}

TEST_F(ResultsTest, AFailedRunIsLeftOutOfTheMeanAndTold) {
  runs_[2].end.code = 1;
  runs_[2].end.message = "it left the box";
  const CaseResult c = cases_of(spec_, plan_, runs_)[1];
  EXPECT_THAT(c.done, ElementsAre(3));
  EXPECT_DOUBLE_EQ(c.figures[0].mean, 11.0);
  EXPECT_EQ(c.code, 1);
  EXPECT_EQ(c.message, "it left the box");
}

TEST_F(ResultsTest, RankingLeavesOutWhatIsBeyondTheLimits) {
  spec_.minimise = "peak";
  EXPECT_THAT(ranking(spec_, cases_of(spec_, plan_, runs_)), ElementsAre(0, 1));
  spec_.limits = {{"peak", 7.0, {}}};
  EXPECT_THAT(ranking(spec_, cases_of(spec_, plan_, runs_)), ElementsAre(0));
}

TEST_F(ResultsTest, AStatementIsAboutACaseOrItsRatioToAnother) {
  StatementSpec statement;
  statement.figure = "peak";
  statement.of_case = "speed 2";
  statement.least = 9.5;
  EXPECT_TRUE(outcomes(statement)[0].came_out);
  statement.against = "speed 1";
  EXPECT_DOUBLE_EQ(outcomes(statement)[0].judged, 2.0);
  EXPECT_FALSE(outcomes(statement)[0].came_out);
}

TEST_F(ResultsTest, AStatementWithoutItsRunsIsNotJudged) {
  StatementSpec statement;
  statement.figure = "peak";
  statement.of_case = "speed 1";
  statement.most = 100.0;
  runs_[0].end.code = runs_[1].end.code = 2;
  EXPECT_TRUE(std::isnan(outcomes(statement)[0].judged));
  EXPECT_FALSE(outcomes(statement)[0].came_out);
}

TEST_F(ResultsTest, AnOrderIsTheSlopeOfTheErrorsOfItsCurve) {
  spec_.parameters.clear();
  spec_.curves.resize(1);
  spec_.curves[0].name = "window";
  StatementSpec statement;
  statement.order = {1.9, 2.1};
  statement.figure = "peak";
  statement.curve = "window";
  statement.least = 1.9;
  statement.most = 2.1;
  spec_.statements = {statement};
  std::vector<CaseResult> cases(3);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    cases[k].plan.curve = 0;
    cases[k].plan.x = std::pow(2.0, static_cast<double>(k));
    cases[k].figures.resize(1);
    cases[k].figures[0].error = 1e-3 * cases[k].plan.x * cases[k].plan.x;
  }
  cases[0].plan.is_reference = true;  // no point of the line, whatever its numbers
  cases[0].figures[0].error = 1.0;
  EXPECT_NEAR(outcomes_of(spec_, cases)[0].judged, 2.0, 1e-12);
  spec_.statements[0].order.clear();
  spec_.statements[0].error = 0.1;
  EXPECT_DOUBLE_EQ(outcomes_of(spec_, cases)[0].judged, 16e-3);  // the last value's
}

}  // namespace
}  // namespace footfall
