// What an experiment runs.
#include "mbd_solver/cli/experiments/runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> names(const Plan& plan) {
  std::vector<std::string> names;
  for (const RunRequest& run : plan.runs) names.push_back(run.name);
  return names;
}

// Two curves over two seeds, one with a reference of its own.
ExperimentSpec two_curves() {
  ExperimentSpec spec;
  spec.scene = "scene.toml";
  spec.settings = {"all=1"};
  spec.reference.emplace();
  spec.reference->settings = {"fine=1"};
  spec.curves.resize(2);
  spec.curves[0].name = "window";
  spec.curves[0].settings = {"every={value}"};
  spec.curves[0].values = {"5", "2"};
  spec.curves[0].short_values = {"2"};
  spec.curves[1].name = "time step";
  spec.curves[1].settings = {"dt={value}", "every={beside}"};
  spec.curves[1].reference = {"dt=1e-5"};
  spec.curves[1].values = {"1e-4", "5e-5"};
  spec.curves[1].short_values = {"1e-4"};
  spec.curves[1].beside = {"3", "6"};
  ParameterSpec seed;
  seed.name = "seed";
  seed.ensemble = true;
  seed.choices = {{"7", "", {"seed=7"}}, {"8", "", {"seed=8"}}};
  seed.short_choices = {seed.choices[0]};
  spec.parameters = {seed};
  return spec;
}

TEST(PlanOf, RunsEveryValueOfACurveForEveryMemberOfTheEnsemble) {
  const Plan plan = plan_of(two_curves(), false);
  EXPECT_EQ(plan.members, 2U);
  EXPECT_THAT(names(plan), ElementsAre("reference__seed_7", "reference__seed_8", "window_5__seed_7", "window_5__seed_8",
                                       "window_2__seed_7", "window_2__seed_8", "time_step_reference__seed_7",
                                       "time_step_reference__seed_8", "time_step_1e-4__seed_7",
                                       "time_step_1e-4__seed_8", "time_step_5e-5__seed_7", "time_step_5e-5__seed_8"));
  EXPECT_THAT(plan.runs[10].settings, ElementsAre("all=1", "dt=5e-5", "every=6", "seed=7"));
  EXPECT_THAT(plan.runs[7].settings, ElementsAre("all=1", "fine=1", "dt=1e-5", "seed=8"));
}

TEST(PlanOf, EveryCaseKnowsWhatItIsComparedWith) {
  const Plan plan = plan_of(two_curves(), false);
  ASSERT_EQ(plan.cases.size(), 6U);
  EXPECT_EQ(plan.cases[1].name, "window 5");
  EXPECT_EQ(plan.cases[1].reference, 0);
  EXPECT_EQ(plan.cases[3].name, "time step reference");
  EXPECT_EQ(plan.cases[5].reference, 3);
  EXPECT_THAT(plan.cases[5].runs, ElementsAre(10, 11));
}

TEST(PlanOf, ShortFormTakesItsOwnValuesTimeAndSettings) {
  ExperimentSpec spec = two_curves();
  spec.until = 2.0;
  spec.short_form = {0.1, {"small=1"}};
  const Plan plan = plan_of(spec, true);
  EXPECT_THAT(names(plan), ElementsAre("reference__seed_7", "window_2__seed_7", "time_step_reference__seed_7",
                                       "time_step_1e-4__seed_7"));
  EXPECT_THAT(plan.runs[1].settings, ElementsAre("all=1", "small=1", "every=2", "seed=7"));
  EXPECT_EQ(plan.runs[1].until, 0.1);
}

TEST(PlanOf, AReferenceThatDependsOnTheValueIsRunForEach) {
  ExperimentSpec spec = two_curves();
  spec.reference.reset();
  spec.parameters.clear();
  spec.curves.pop_back();
  spec.curves[0].reference = {"every={value}", "tolerance=1e-9"};
  const Plan plan = plan_of(spec, false);
  EXPECT_THAT(names(plan), ElementsAre("window_5_reference", "window_5", "window_2_reference", "window_2"));
  EXPECT_EQ(plan.cases[3].reference, 2);
}

TEST(PlanOf, ParametersAreCombinedAndTheEnsembleIsOneCase) {
  ExperimentSpec spec = two_curves();
  spec.curves.clear();
  spec.reference.reset();
  ParameterSpec speed;
  speed.name = "speed";
  speed.choices = {{"1", "", {"v=1"}}, {"on ice", "ice.toml", {"v=2"}}};
  spec.parameters.push_back(speed);
  const Plan plan = plan_of(spec, false);
  EXPECT_THAT(names(plan),
              ElementsAre("seed_7__speed_1", "seed_7__speed_on_ice", "seed_8__speed_1", "seed_8__speed_on_ice"));
  ASSERT_EQ(plan.cases.size(), 2U);
  EXPECT_EQ(plan.cases[1].name, "speed on ice");
  EXPECT_THAT(plan.cases[1].runs, ElementsAre(1, 3));
  EXPECT_EQ(plan.runs[1].scene, "ice.toml");
}

TEST(PlanOf, RunsOfOneNameAreTold) {
  ExperimentSpec spec = two_curves();
  spec.curves[1].name = "window";
  spec.curves[1].values = {"5", "6"};
  EXPECT_THROW(plan_of(spec, false), InputError);
}

}  // namespace
}  // namespace footfall
