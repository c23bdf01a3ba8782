// The rigid motion of a surface's nodes.
#include "mbd_solver/observe/motion_record.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

TEST(FitRigid, FindsTheMotionOfARigidSurface) {
  const Eigen::Matrix3Xd x0 = Eigen::Matrix3Xd::Random(3, 40);
  for (const double angle : {0.0, 1e-6, 0.4, 3.0}) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    const Eigen::Vector3d shift(0.3, -4.0, 2.0);
    const RigidFit fit = fit_rigid(x0, (R * x0).colwise() + shift);
    EXPECT_LT((fit.R - R).norm(), 1e-14);
    EXPECT_LT((fit.centre - (R * x0.rowwise().mean() + shift)).norm(), 1e-14);
    EXPECT_LT(fit.left_over, 1e-14);
  }
}

// A plate: all points in one plane, where a reflection would fit as well.
TEST(FitRigid, TurnsAPlateOverInsteadOfReflectingIt) {
  Eigen::Matrix3Xd x0 = Eigen::Matrix3Xd::Random(3, 30);
  x0.row(2).setZero();
  const Eigen::Matrix3d R = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  const RigidFit fit = fit_rigid(x0, R * x0);
  EXPECT_NEAR(fit.R.determinant(), 1.0, 1e-14);
  EXPECT_LT((fit.R - R).norm(), 1e-13);
}

// Bent symmetrically, a plate has not turned; what is left over is the bending about its mean.
TEST(FitRigid, LeavesTheBendingOver) {
  Eigen::Matrix3Xd x0(3, 3), x(3, 3);
  x0 << -1, 0, 1, 0, 0, 0, 0, 0, 0;
  x = x0;
  x(2, 0) = x(2, 2) = 0.03;
  const RigidFit fit = fit_rigid(x0, x);
  EXPECT_LT((fit.R * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitX()).norm(), 1e-14);
  EXPECT_NEAR(fit.left_over, 0.02, 1e-15);
  EXPECT_NEAR(fit.centre.z(), 0.02, 1e-15);
}

}  // namespace
}  // namespace footfall
