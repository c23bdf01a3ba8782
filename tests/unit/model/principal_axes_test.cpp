#include "mbd_solver/model/principal_axes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace footfall {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kAxesRoundOff = 1e-13;

Matrix3d turn(double angle, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}
Matrix3d turned(const Vector3d& moments, const Matrix3d& R) { return R * moments.asDiagonal() * R.transpose(); }

void expect_principal(const Matrix3d& inertia, const Matrix3d& axes) {
  EXPECT_LT((axes.transpose() * axes - Matrix3d::Identity()).norm(), kAxesRoundOff);
  EXPECT_NEAR(axes.determinant(), 1.0, kAxesRoundOff) << "right-handed";
  Matrix3d rest = axes.transpose() * inertia * axes;
  rest.diagonal().setZero();
  EXPECT_LT(rest.norm(), kAxesRoundOff * inertia.norm());
}

TEST(PrincipalAxes, MakeTheInertiaDiagonalAndLieNearestToTheFrame) {
  for (const Vector3d& axis : {Vector3d(1, 2, 3), Vector3d(-1, 0.2, 0.1), Vector3d(0, 0, 1), Vector3d(3, -2, 0.5)})
    for (double angle : {0.01, 0.3, -0.6, 2.0, 3.1}) {
      const Matrix3d inertia = turned({1.0, 2.5, 3.0}, turn(angle, axis)), axes = principal_axes(inertia);
      expect_principal(inertia, axes);
      EXPECT_NEAR(axes.diagonal().maxCoeff(), axes.cwiseAbs().maxCoeff(), kAxesRoundOff)
          << "the nearest column, same side";
      if (std::abs(angle) < 0.61) {
        EXPECT_LT((axes - turn(angle, axis)).norm(), 1e-10) << "the nearest of 24";
      }
    }
}

TEST(PrincipalAxes, OfARodTurnTheFrameOnTheShortestWay) {
  for (const Vector3d& along : {Vector3d(0.6, 0.48, 0.64), Vector3d(0.1, 0.2, -1), Vector3d(-3, 1, 1)}) {
    const Vector3d e = along.normalized();
    const Matrix3d inertia = 2.0 * Matrix3d::Identity() - 1.9 * e * e.transpose(), axes = principal_axes(inertia);
    expect_principal(inertia, axes);
    Eigen::Index nearest = 0;
    e.cwiseAbs().maxCoeff(&nearest);
    EXPECT_LT(axes.col(nearest).cross(e).norm(), 1e-12);
    const Eigen::AngleAxisd way(axes);
    EXPECT_NEAR(way.axis().dot(e), 0.0, 1e-12) << "no turn about the rod";
    EXPECT_LT(way.angle(), 1.0);
  }
}

TEST(PrincipalAxes, OfWhatLiesAlongTheFrameAreTheFrameToTheBit) {
  for (const Vector3d& moments : {Vector3d(1, 1, 1), Vector3d(1, 2, 3), Vector3d(3, 1, 2), Vector3d(0.01, 2, 2),
                                  Vector3d(2, 0.01, 2), Vector3d(2, 2, 3), Vector3d(1, 1 + 1e-9, 1)}) {
    const Matrix3d inertia = moments.asDiagonal();
    EXPECT_TRUE(principal_axes(inertia) == Matrix3d::Identity()) << moments.transpose();
    Matrix3d nearly = inertia;
    nearly(0, 1) = nearly(1, 0) = 1e-16;
    EXPECT_TRUE(principal_axes(nearly) == Matrix3d::Identity()) << moments.transpose();
  }
}

}  // namespace
}  // namespace footfall
