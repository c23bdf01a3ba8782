// LU factors without the entries that hardly matter: dynamics/thin_lu.h.
#include "mbd_solver/dynamics/thin_lu.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace footfall {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Every entry stored, zeros too.
Eigen::SparseMatrix<double> dense_pattern(const MatrixXd& A) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < A.cols(); ++j)
    for (int i = 0; i < A.rows(); ++i) entries.emplace_back(i, j, A(i, j));
  Eigen::SparseMatrix<double> out(static_cast<int>(A.rows()), static_cast<int>(A.cols()));
  out.setFromTriplets(entries.begin(), entries.end());
  out.makeCompressed();
  return out;
}

void set(Eigen::SparseMatrix<double>& matrix, int i, int j, double value) { matrix.coeffRef(i, j) = value; }

// [D, B^T; B, -eps]: n velocities, two rows of conditions.
MatrixXd saddle(int n) {
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> from(-1.0, 1.0);
  MatrixXd A = MatrixXd::Zero(n + 2, n + 2);
  for (int i = 0; i < n; ++i) A(i, i) = 1.0 + i;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 2; ++k) A(i, n + k) = A(n + k, i) = from(draw);
  A(n, n) = A(n + 1, n + 1) = -1e-12;
  return A;
}

constexpr double kNewton = 3e-3;

VectorXd solved(const ThinLu& lu, VectorXd x) {
  lu.solve(x);
  return x;
}

TEST(ThinLu, ZerosOfADenseBlockTakeNoPart) {
  const int n = 8;
  const MatrixXd A = saddle(n);
  const auto matrix = dense_pattern(A);
  const VectorXd own = A.diagonal().head(n), b = VectorXd::LinSpaced(n + 2, 1.0, 2.0);
  ThinLu lu(matrix, VectorXd::Constant(n, ThinLu::kRoundOff));
  ASSERT_TRUE(lu.factor(own));
  EXPECT_EQ(lu.entries(), n + 2 * 2 * n + 4);
  EXPECT_LT((A * solved(lu, b) - b).norm(), 1e-12 * b.norm());
}

TEST(ThinLu, LeavesOutWhatHardlyMattersAndTakesItBackWhenItDoes) {
  const int n = 8;
  MatrixXd A = saddle(n);
  A(2, 5) = A(5, 2) = 1e-3 * std::sqrt(A(2, 2) * A(5, 5));
  auto matrix = dense_pattern(A);
  const VectorXd own = A.diagonal().head(n), b = VectorXd::LinSpaced(n + 2, 1.0, 2.0);
  ThinLu lu(matrix, VectorXd::Constant(n, kNewton));
  ASSERT_TRUE(lu.factor(own));
  const auto few = lu.entries();
  const double off = (A * solved(lu, b) - b).norm() / b.norm();
  EXPECT_GT(off, 1e-5);
  EXPECT_LT(off, 1e-2);

  for (const double share : {5e-3, 2e-2, 1e-3}) {  // below what matters; beyond; and small again
    A(2, 5) = A(5, 2) = share * std::sqrt(A(2, 2) * A(5, 5));
    set(matrix, 2, 5, A(2, 5));
    set(matrix, 5, 2, A(5, 2));
    ASSERT_TRUE(lu.factor(own));
    EXPECT_EQ(lu.entries(), share == 5e-3 ? few : few + 2) << share;
    if (share != 5e-3) {
      EXPECT_LT((A * solved(lu, b) - b).norm(), 1e-12 * b.norm()) << share;
    }
  }
  lu.forget();
  ASSERT_TRUE(lu.factor(own));
  EXPECT_EQ(lu.entries(), few);
}

TEST(ThinLu, RowsWithoutAShareStayWhole) {
  const int n = 8;
  const MatrixXd A = saddle(n);
  const auto matrix = dense_pattern(A);
  VectorXd share = VectorXd::Constant(n, kNewton);
  share.head(3).setZero();
  ThinLu lu(matrix, share);
  ASSERT_TRUE(lu.factor(A.diagonal().head(n)));
  EXPECT_EQ(lu.entries(), 3 * n + (n - 3) + 2 * 2 * n + 4);
}

// A spring of stiffness k between two bodies in a direction that leans a little: k n n^T has entries of 3e-4 k, small beside k
// and not beside the mass, which alone resists when both move together.
TEST(ThinLu, WhatIsSmallBesideASpringIsNotSmall) {
  const double k = 1e6;
  const Eigen::Vector2d n = Eigen::Vector2d(1.0, 3e-4).normalized();
  const Eigen::Matrix2d spring = k * n * n.transpose();
  MatrixXd A = MatrixXd::Identity(4, 4);
  A.topLeftCorner<2, 2>() += spring;
  A.bottomRightCorner<2, 2>() += spring;
  A.topRightCorner<2, 2>() -= spring;
  A.bottomLeftCorner<2, 2>() -= spring;
  const auto matrix = dense_pattern(A);
  ThinLu lu(matrix, VectorXd::Constant(4, kNewton));
  ASSERT_TRUE(lu.factor(VectorXd::Ones(4)));
  const Eigen::Vector4d b(1.0, 2.0, 1.0, -1.0);
  EXPECT_LT((solved(lu, b) - A.partialPivLu().solve(b)).norm(), 0.1 * b.norm());
}

TEST(ThinLu, SaysWhenItIsSingular) {
  MatrixXd A = MatrixXd::Identity(3, 3);
  A(1, 1) = 0.0;
  const auto matrix = dense_pattern(A);
  ThinLu lu(matrix, VectorXd::Constant(3, kNewton));
  EXPECT_FALSE(lu.factor(VectorXd::Ones(3)));
  auto broken = dense_pattern(MatrixXd::Identity(3, 3));
  set(broken, 0, 2, std::nan(""));
  ThinLu not_finite(broken, VectorXd::Constant(3, kNewton));
  EXPECT_FALSE(not_finite.factor(VectorXd::Ones(3)));
}

}  // namespace
}  // namespace footfall
