// Distances of surfaces: boxes, lines and balls whose distance is known.

#include "mbd_solver/model/surface/surface_model.h"

#include <gtest/gtest.h>

#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kSurfaceRoundOff = 1e-12;

// The unit cube about the origin.
SurfaceModel cube() {
  Eigen::Matrix3Xd v(3, 8);
  for (int i = 0; i < 8; ++i) v.col(i) << (i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5;
  return SurfaceModel(v, {{0, 2, 3},
                          {0, 3, 1},
                          {4, 5, 7},
                          {4, 7, 6},
                          {0, 1, 5},
                          {0, 5, 4},
                          {2, 6, 7},
                          {2, 7, 3},
                          {0, 4, 6},
                          {0, 6, 2},
                          {1, 3, 7},
                          {1, 7, 5}});
}

SurfaceModel line(double radius) {
  Eigen::Matrix3Xd v(3, 2);
  v << -1.0, 1.0, 0.0, 0.0, 0.0, 0.0;
  return SurfaceModel(v, {{0, 0, 1}}, radius);
}

TEST(SurfaceModel, DistanceOfTwoCubesIsThatOfFaceEdgeAndCorner) {
  const SurfaceModel a = cube(), b = cube();
  EXPECT_NEAR(gap_between(a, b, {Eigen::Matrix3d::Identity(), {1.3, 0.2, 0.1}}).distance, 0.3, kSurfaceRoundOff);
  EXPECT_NEAR(gap_between(a, b, {Eigen::Matrix3d::Identity(), {1.3, 1.4, 0.1}}).distance, 0.5, kSurfaceRoundOff);
  EXPECT_NEAR(gap_between(a, b, {Eigen::Matrix3d::Identity(), {1.2, 1.2, 1.1}}).distance, 0.3, kSurfaceRoundOff);
  const double half = 0.5 * std::sqrt(2.0);  // turned about z by 45 degrees its edge comes first
  const FramePose turned{rotation_matrix(quaternion_about(Eigen::Vector3d::UnitZ(), std::atan(1.0))), {2.0, 0.0, 0.3}};
  const SurfaceGap gap = gap_between(a, b, turned);
  EXPECT_NEAR(gap.distance, 1.5 - half, kSurfaceRoundOff);
  EXPECT_NEAR(gap.place.x(), 0.5 * (0.5 + 2.0 - half), kSurfaceRoundOff);
}

TEST(SurfaceModel, SurfacesThatCrossHaveNoDistanceAndAPlaceInBoth) {
  const SurfaceModel a = cube(), b = cube();
  const SurfaceGap gap = gap_between(a, b, {Eigen::Matrix3d::Identity(), {0.9, 0.8, 0.7}});
  EXPECT_LE(gap.distance, 0.0);
  EXPECT_LT((gap.place - Eigen::Vector3d(0.45, 0.4, 0.35)).cwiseAbs().maxCoeff(), 0.2);
  // One within the other does not cross it.
  Eigen::Matrix3Xd small(3, 3);
  small << 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0;
  EXPECT_NEAR(gap_between(a, SurfaceModel(small, {{0, 1, 2}}), {}).distance, 0.4, kSurfaceRoundOff);
}

TEST(SurfaceModel, ABeamIsAsThickAsItIs) {
  const SurfaceModel a = line(0.1), b = line(0.05), c = cube();
  const Eigen::Matrix3d across = rotation_matrix(quaternion_about(Eigen::Vector3d::UnitZ(), 2.0 * std::atan(1.0)));
  EXPECT_NEAR(gap_between(a, b, {across, {0.3, 0.4, 0.5}}).distance, 0.35, 1e-6);  // a line is a sliver
  EXPECT_LE(gap_between(a, b, {across, {0.3, 0.4, 0.14}}).distance, 0.0);
  EXPECT_NEAR(gap_between(c, a, {across, {0.9, 0.2, 0.0}}).distance, 0.3, 1e-6);
}

TEST(SurfaceModel, MovedVerticesAreWhereTheyWereMoved) {
  const SurfaceModel a = cube();
  SurfaceModel b = line(0.1);
  Eigen::Matrix3Xd v(3, 2);
  v << -1.0, 1.0, 0.0, 0.0, 1.5, 1.5;
  b.move(v);
  EXPECT_NEAR(gap_between(a, b, {}).distance, 0.9, 1e-6);
}

}  // namespace
}  // namespace footfall
