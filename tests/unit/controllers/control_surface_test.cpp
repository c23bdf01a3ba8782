#include "mbd_solver/model/controllers/control_surface.h"

#include <gtest/gtest.h>

#include "coupler/base/errors.h"
#include "tests/unit/controllers/fuzzy_files.h"

namespace footfall {
namespace {

TEST(ControlSurface, IsTheControllerOverTwoInputs) {
  const FuzzySystem lander(lander_file());
  const ControlSurface s = control_surface(lander, 2, "a", "alpha", 9, {0.0, 3.0, 0.0, 1.0});
  ASSERT_EQ(s.first.size(), 9);
  EXPECT_EQ(s.first[8], 5.0);
  EXPECT_EQ(s.second[0], -4.0);
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) EXPECT_EQ(s.voltage(i, j), voltages(lander, {s.first[i], 3.0, s.second[j], 1.0})[2]);
}

TEST(ControlSurface, U3MirrorsU1InPitch) {
  const FuzzySystem lander(lander_file());
  const ControlSurface one = control_surface(lander, 0, "a", "alpha", 11),
                       three = control_surface(lander, 2, "a", "alpha", 11);
  EXPECT_LT((one.voltage.rowwise().reverse() - three.voltage).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ControlSurface, RefusesUnknownAxesAndOutputs) {
  const FuzzySystem lander(lander_file());
  EXPECT_THROW(control_surface(lander, 0, "a", "speed"), InputError);
  EXPECT_THROW(control_surface(lander, 0, "a", "a"), InputError);
  EXPECT_THROW(control_surface(lander, 4, "a", "da"), InputError);
  EXPECT_THROW(control_surface(lander, 0, "a", "da", 1), InputError);
}

}  // namespace
}  // namespace footfall
