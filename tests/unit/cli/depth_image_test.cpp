// The renderer: what is nearer hides what is behind it, whatever was drawn first.
#include "mbd_solver/cli/grains/depth_image.h"
#include "coupler/base/pi.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

constexpr Colour kRed{255, 0, 0}, kBlue{0, 0, 255}, kWhite{255, 255, 255};

// 2 m wide, seen along -x: y to the right, z up. 100 pixels.
DepthImage from_ahead() { return DepthImage({eye_axes(0.0, 0.0), {-1, -1}, {1, 1}}, 100); }
bool is_red(const Colour& c) { return c[0] > 60 && c[2] == 0; }
bool is_blue(const Colour& c) { return c[2] > 60 && c[0] == 0; }

TEST(DepthImage, AxesOfTheEyeAreARotationWithZUp) {
  for (const double azimuth : {-1.1, 0.0, 2.5}) {
    const Eigen::Matrix3d R = eye_axes(azimuth, 0.4);
    EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(R.determinant(), 1.0, 1e-14);
    EXPECT_NEAR((R * Eigen::Vector3d::UnitZ())(0), 0.0, 1e-14);  // upright
  }
}

TEST(DepthImage, TheNearerOneIsSeenInEitherOrder) {
  for (const bool near_first : {true, false}) {
    DepthImage image = from_ahead();
    if (near_first) image.sphere({1.0, 0, 0}, 0.3, kRed);
    image.sphere({0, 0, 0}, 0.6, kBlue);
    if (!near_first) image.sphere({1.0, 0, 0}, 0.3, kRed);
    EXPECT_TRUE(is_red(image.pixel(50, 50)));
    EXPECT_TRUE(is_blue(image.pixel(75, 50)));  // y = 0.51
    EXPECT_EQ(image.pixel(90, 50), kWhite);
  }
}

TEST(DepthImage, RightIsRightAndUpIsUp) {
  DepthImage image = from_ahead();
  image.sphere({0, 0.5, 0.5}, 0.2, kRed);
  EXPECT_TRUE(is_red(image.pixel(75, 25)));
  EXPECT_EQ(image.pixel(25, 75), kWhite);
}

TEST(DepthImage, ASphereCoversItsDisc) {
  DepthImage image = from_ahead();
  image.sphere({0, 0, 0}, 0.5, kRed);
  int covered = 0;
  for (int row = 0; row < image.height(); ++row)
    for (int column = 0; column < image.width(); ++column) covered += image.pixel(column, row) != kWhite;
  // Pixels that touch its edge count too: about one layer of a circumference of 50 pi.
  EXPECT_NEAR(covered, kPi * 25 * 25, 50 * kPi);
  EXPECT_GT(covered, kPi * 25 * 25);
}

// An inclined capsule is the hull of its spheres: drawn as many spheres, the picture is the same, but for rounding at
// edges between them.
TEST(DepthImage, ACapsuleIsARowOfSpheres) {
  const Eigen::Vector3d a(-0.8, -0.5, -0.3), b(0.9, 0.4, 0.5);
  DepthImage capsule = from_ahead(), spheres = from_ahead();
  capsule.capsule(a, b, 0.2, kRed);
  constexpr int kSpheres = 4000;
  for (int k = 0; k <= kSpheres; ++k) spheres.sphere(a + (b - a) * k / kSpheres, 0.2, kRed);
  int different = 0;
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column)
      different += std::abs(capsule.pixel(column, row)[0] - spheres.pixel(column, row)[0]) > 3;
  EXPECT_EQ(different, 0);
}

TEST(DepthImage, APlateCoversWhatPressesIntoItByLessThanItsLift) {
  DepthImage bare = from_ahead(), lifted = from_ahead();
  for (DepthImage* image : {&bare, &lifted}) {
    image->sphere({-0.29, 0, 0}, 0.3, kBlue);  // 0.01 m through the plate x = 0
    image->triangle({0, -1, -1}, {0, 1, -1}, {0, 0, 1}, kRed, image == &lifted ? 0.02 : 0.0);
  }
  EXPECT_TRUE(is_blue(bare.pixel(50, 50)));
  EXPECT_TRUE(is_red(lifted.pixel(50, 50)));
  EXPECT_TRUE(is_red(bare.pixel(50, 70)));
}

}  // namespace
}  // namespace footfall
