#include "coupler/gravity.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

const Eigen::Vector3d kEarth(0, 0, -9.81), kMoon(0, 0, -1.62), kNone(0, 0, 0);

TEST(Gravity, IsTheSameButForRounding) {
  EXPECT_TRUE(is_same_gravity(kEarth * (1.0 + 1e-9), kEarth));
  EXPECT_TRUE(is_same_gravity(kNone, kNone));
  EXPECT_FALSE(is_same_gravity(kEarth * 1.001, kEarth));
  EXPECT_FALSE(is_same_gravity(-kEarth, kEarth));
}

TEST(Gravity, SaysWhatDiffers) {
  EXPECT_EQ(gravity_differs(kMoon, kEarth, " at the start")
                .rfind("the LIGGGHTS script has the gravity (0, 0, -1.62) m/s2 at the start (fix gravity), the scene "
                       "(0, 0, -9.81) "
                       "m/s2 (gravity): make them agree",
                       0),
            0U);
  EXPECT_EQ(
      gravity_differs(kNone, kEarth, ""),
      "the LIGGGHTS script has no fix gravity, the scene has gravity = (0, 0, -9.81) m/s2: the grains have no weight");
  EXPECT_EQ(gravity_differs(kNone, kEarth, " at the start").rfind("the LIGGGHTS script has the gravity (0, 0, 0)", 0),
            0U);
}

}  // namespace
}  // namespace footfall
