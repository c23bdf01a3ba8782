// Random mechanisms that fall through positions in which their conditions lose rank.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "coupler/base/errors.h"
#include "tests/physics/motion_of.h"
#include "tests/physics/random_mechanism.h"

namespace footfall {
namespace {

using test::Family;
using test::Plan;

// Sarrus' mechanism and three parallelograms fall through positions in which Phi_v loses two and three ranks at once.
// Beyond them the motion may branch, but no energy may be lost.
const std::pair<Family, unsigned> kSingular[] = {{Family::kOverclosed, 3},     {Family::kOverclosed, 14},
                                                 {Family::kOverclosed, 16},    {Family::kOverclosed, 19},
                                                 {Family::kParallelogram, 15}, {Family::kParallelogram, 21}};

class SingularPositions : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, SingularPositions, ::testing::Values("one_step", "ida"));

TEST_P(SingularPositions, ArePassedWithTheEnergy) {
  for (const auto& [family, seed] : kSingular) {
    const Plan plan = test::random_mechanism(family, seed);
    EXPECT_LT(plan.regular_until, plan.duration) << plan.what;
    const Model model = test::build(plan);
    test::Run run(model, GetParam(), test::as_a_scene(1e-6));
    run.to(plan.duration);
    // They hold some 20 J and more; a thousand tolerances of it.
    EXPECT_LT(std::abs(run.imbalance()), 0.02) << plan.what;
  }
}

TEST(OverSingularPositions, NoEnergyIsLostInSilenceAtAnyTolerance) {
  // Below 1e-8 round-off may stand in the way of a step over the position; then the run ends and says so.
  for (const auto& [family, seed] : kSingular) {
    const Plan plan = test::random_mechanism(family, seed);
    const Model model = test::build(plan);
    for (const double rtol : {1e-4, 1e-5, 1e-7, 1e-8, 1e-9, 1e-10}) {
      test::Run run(model, "one_step", test::as_a_scene(rtol));
      std::string said;
      try {
        run.to(plan.duration);
      } catch (const NumericalError& error) {
        said = error.what();
      }
      if (rtol >= 1e-8) {
        EXPECT_EQ(said, "") << plan.what << ", rtol " << rtol;
      }
      // A thousand tolerances of 20 J and more.
      if (said.empty()) {
        EXPECT_LT(std::abs(run.imbalance()), std::max(0.02e6 * rtol, 1e-4)) << plan.what << ", rtol " << rtol;
      }
    }
  }
}

TEST(OverSingularPositions, StepsDoNotShrink) {
  // Steps do not shrink into the position: the same as on the way there, and a few that fail.
  for (const auto& [family, seed] : kSingular) {
    const Plan plan = test::random_mechanism(family, seed);
    const Model model = test::build(plan);
    test::Run run(model, "one_step", test::as_a_scene(1e-6));
    run.to(plan.duration);
    EXPECT_LT(run.integrator->statistics().steps, 40) << plan.what;
  }
}

}  // namespace
}  // namespace footfall
