// Chains whose neighbours differ by many orders of magnitude in mass: right, or told with a name.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coupler/base/errors.h"
#include "tests/physics/mechanisms.h"
#include "tests/physics/motion_of.h"

namespace footfall {
namespace {

// Rods of 1 m on hinges, level at the start; every other one, the first included, weighs 1 / ratio kg, the rest 1 kg.
Model chain(int rods, double ratio) {
  Model model({0.0, -9.81, 0.0});
  int last = kGround;
  for (int i = 0; i < rods; ++i) {
    const std::string number = std::to_string(i);
    const Eigen::Vector3d from(i, 0.0, 0.0), to(i + 1.0, 0.0, 0.0), none = Eigen::Vector3d::Zero();
    const int rod = test::add_rod(model, "rod_" + number, from, to, none, none, i % 2 == 0 ? 1.0 / ratio : 1.0, 0.1);
    model.add_joint(test::hinge(model, "hinge_" + number, last, rod, from));
    last = rod;
  }
  return model;
}

class MassRatios : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, MassRatios, ::testing::Values("one_step", "ida"));

TEST_P(MassRatios, LightRodsBetweenHeavyOnesHoldThemAsRodsWithoutMassDo) {
  // All ratios have the same limit, which they reach to 1 / ratio. They hold some 60 J.
  constexpr double kEnd = 0.5, kRtol = 1e-6;
  for (const int rods : {3, 6}) {
    const Model almost_none = chain(rods, 1e9);
    test::Run limit(almost_none, "one_step", test::as_a_scene(1e-8));
    const test::Motion start = test::motion_of(limit);
    limit.to(kEnd);
    const test::Motion end = test::motion_of(limit);
    const test::Size size = test::size_of(start, end);
    for (const double ratio : {1e8, 1e10, 1e12, 1e14}) {
      const Model model = chain(rods, ratio);
      test::Run run(model, GetParam(), test::as_a_scene(kRtol));
      run.to(kEnd);
      EXPECT_LT(test::difference(test::motion_of(run), end, size), 100.0 * kRtol) << rods << " rods, " << ratio;
      EXPECT_LT(std::abs(run.imbalance()), 2e-3) << rods << " rods, " << ratio;
    }
  }
}

TEST(MassRatio, BeyondDoublePrecisionNamesTheBody) {
  std::string said = "nothing";
  try {
    const Model model = chain(4, 1e20);
    test::Run run(model, "one_step", test::as_a_scene(1e-6));
  } catch (const InputError& error) {
    said = error.what();
  }
  EXPECT_NE(said.find("body \"rod_0\""), std::string::npos) << said;
}

}  // namespace
}  // namespace footfall
