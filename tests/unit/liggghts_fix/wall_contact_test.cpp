#include "liggghts_fix/wall_contact.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

constexpr double kWallRoundOff = 1e-14;  // of a few products and roots

// Equal materials: E* = E / (2 (1 - nu^2)), G* = G / (2 (2 - nu)) with G = E / (2 (1 + nu)).
TEST(WallContact, EqualMaterialsGiveTheKnownModuli) {
  const ElasticConstants m{6e6, 0.3};
  const WallContact contact = hertz_mindlin(m, m);
  EXPECT_NEAR(contact.young, 6e6 / (2.0 * (1.0 - 0.09)), kWallRoundOff * 6e6);
  EXPECT_NEAR(contact.shear, 6e6 / (2.0 * 1.3) / (2.0 * 1.7), kWallRoundOff * 6e6);
}

TEST(WallContact, GrainAndWallMayChangePlaces) {
  const ElasticConstants grain{6e6, 0.3}, wall{1e9, 0.25};
  EXPECT_NEAR(hertz_mindlin(grain, wall).young, hertz_mindlin(wall, grain).young, kWallRoundOff * 6e6);
  EXPECT_NEAR(hertz_mindlin(grain, wall).shear, hertz_mindlin(wall, grain).shear, kWallRoundOff * 6e6);
}

// F = 4/3 E* sqrt(R) delta^(3/2), so dF/ddelta = 2 E* sqrt(R delta).
TEST(WallContact, StiffnessIsTheDerivativeOfHertzForce) {
  const WallContact contact = hertz_mindlin({6e6, 0.3}, {1e9, 0.25});
  const double radius = 0.004, overlap = 1e-5, step = 1e-9;
  const auto force = [&](double delta) { return 4.0 / 3.0 * contact.young * std::sqrt(radius) * std::pow(delta, 1.5); };
  const double difference = (force(overlap + step) - force(overlap - step)) / (2.0 * step);
  const double kDifference = 1e-8;  // (step / overlap)^2 / 24, and round-off over step
  EXPECT_NEAR(contact.stiffness(std::sqrt(radius * overlap)), difference, kDifference * difference);
}

TEST(WallContact, PerfectBounceIsNotDamped) {
  EXPECT_EQ(damping_of_restitution(1.0), 0.0);
  EXPECT_GT(damping_of_restitution(0.5), damping_of_restitution(0.8));
}

TEST(WallContact, SlidesAtTheCoulombLimitAndSticksBelow) {
  WallContact contact = hertz_mindlin({6e6, 0.3}, {1e9, 0.25});
  contact.friction = 0.5;
  contact.damping = damping_of_restitution(0.6);
  const double s = 2e-4, mass = 1e-3;
  const Eigen::Vector3d n(0.0, 0.0, 1.0);
  const ContactSlope sticks = contact.slope(n, {0.4, 0.0, -1.0}, s, mass);
  EXPECT_EQ(sticks.stiffness, contact.stiffness(s));
  EXPECT_EQ(sticks.shear_stiffness, 8.0 * contact.shear * s);
  EXPECT_EQ(sticks.damping, contact.damping * std::sqrt(sticks.stiffness * mass));
  EXPECT_EQ(sticks.shear_damping, contact.damping * std::sqrt(sticks.shear_stiffness * mass));
  const ContactSlope slides = contact.slope(n, {0.5, 0.0, -1.0}, s, mass);
  EXPECT_EQ(slides.stiffness, sticks.stiffness);
  EXPECT_EQ(slides.shear_stiffness, 0.0);
  EXPECT_EQ(slides.shear_damping, 0.0);
}

TEST(WallContact, LinearSpringHasTheScriptsConstantsAtAnyOverlap) {
  WallContact contact;
  contact.linear = 1000.0;
  contact.linear_shear = 300.0;
  contact.linear_damping = 20.0;
  contact.linear_shear_damping = 5.0;
  contact.friction = 1.0;
  const ContactSlope slope = contact.slope(Eigen::Vector3d::UnitZ(), {0.0, 0.0, -1.0}, 1e-3, 0.5);
  EXPECT_EQ(slope.stiffness, 1000.0);
  EXPECT_EQ(slope.shear_stiffness, 300.0);
  EXPECT_EQ(slope.damping, 10.0);  // per mass of the grain
  EXPECT_EQ(slope.shear_damping, 2.5);
}

}  // namespace
}  // namespace footfall
