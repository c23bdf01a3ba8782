// How long a boundary may fall before it can meet a grain.

#include "mbd_solver/coupling/flight_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace footfall {
namespace {

const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

// A square plate of edge 2 m about its origin.
ModalBoundary plate() {
  Eigen::Matrix3Xd nodes(3, 4);
  nodes << -1, 1, 1, -1, -1, -1, 1, 1, 0, 0, 0, 0;
  return ModalBoundary("plate", nodes, {{0, 1, 2}, {0, 2, 3}}, {});
}

Placement ground_at(double height) {
  Placement placement;
  placement.ground_known = true;
  placement.ground_height = height;
  return placement;
}

BodyMotion falling_from(double height, double speed) {
  BodyMotion motion(0);
  motion.r.z() = height;
  motion.dr.z() = -speed;
  return motion;
}

double time(const BodyMotion& motion, const Placement& placement, const LandingSite* site = nullptr) {
  return flight_time(motion, plate(), placement, kUp, site);
}

TEST(FlightTime, IsHeightOverSpeed) { EXPECT_DOUBLE_EQ(time(falling_from(3.0, 2.0), ground_at(1.0)), 1.0); }

TEST(FlightTime, IsZeroAmongTheGrainsAndWhereNobodyKnowsThem) {
  EXPECT_EQ(time(falling_from(1.0, 2.0), ground_at(1.0)), 0.0);
  EXPECT_EQ(time(falling_from(3.0, 2.0), Placement()), 0.0);
}

TEST(FlightTime, OfABodyThatRisesIsForEver) {
  EXPECT_EQ(time(falling_from(3.0, -2.0), ground_at(1.0)), std::numeric_limits<double>::infinity());
}

// Any point may come down at |w| reach.
TEST(FlightTime, CountsTheSpinOfTheFarthestPoint) {
  BodyMotion motion = falling_from(3.0, 0.0);
  motion.w.x() = 2.0;
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0)), 2.0 / (2.0 * std::sqrt(2.0)));
}

TEST(FlightTime, IsOfTheLowestPoint) {
  BodyMotion motion = falling_from(3.0, 1.0);
  motion.L << std::sqrt(0.5), std::sqrt(0.5), 0, 0;  // stands on an edge, 1 m below its origin
  EXPECT_NEAR(time(motion, ground_at(1.0)), 1.0, 1e-14);
}

TEST(FlightTime, BeamsReachTheGrainsWithTheirRadius) {
  Eigen::Matrix3Xd nodes(3, 2);
  nodes << -1, 1, 0, 0, 0, 0;
  const ModalBoundary beam("beam", nodes, {}, {{0, 1, 0.25, 0}});
  EXPECT_DOUBLE_EQ(flight_time(falling_from(3.0, 1.0), beam, ground_at(1.0), kUp, nullptr), 1.75);
}

// Above lower grains than the highest of all it may fall longer, until it strays from them.
TEST(FlightTime, IsToTheGrainsBelowAsLongAsItStaysAboveThem) {
  LandingSite site;
  site.height = 0.5;
  site.stray = 0.2;
  site.r = Eigen::Vector3d(0, 0, 5);
  BodyMotion motion = falling_from(3.0, 1.0);
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0), &site), 2.5);
  motion.r.x() = 0.19;
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0), &site), 2.5);
  motion.r.x() = 0.21;
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0), &site), 2.0);
}

TEST(FlightTime, TurningStraysToo) {
  LandingSite site;
  site.height = 0.5;
  site.stray = 0.2;
  site.r = Eigen::Vector3d(0, 0, 5);
  BodyMotion motion = falling_from(3.0, 1.0);
  motion.L << std::cos(0.1), 0, 0, std::sin(0.1);  // 0.2 rad about up: its corners move by 0.28 m
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0), &site), 2.0);
}

// No grain at all below: the highest of all counts.
TEST(FlightTime, OverAHoleIsToTheHighestGrain) {
  LandingSite site;
  site.height = -std::numeric_limits<double>::infinity();
  site.stray = 0.2;
  site.r = Eigen::Vector3d(0, 0, 5);
  EXPECT_DOUBLE_EQ(time(falling_from(3.0, 1.0), ground_at(1.0), &site), 2.0);
}

}  // namespace
}  // namespace footfall
