#include "mbd_solver/fe/eigen_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/fe/fe_partition.h"
#include "mbd_solver/fe/mesh_generator.h"

namespace footfall {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

// n masses in a row between walls: omega_k = 2 sin(k pi / (2 (n + 1))). Every other mass may be left out.
void chain(int n, bool every_other_massless, Sparse& K, Sparse& M) {
  K.resize(n, n);
  M.resize(n, n);
  for (int i = 0; i < n; ++i) {
    K.insert(i, i) = 2.0;
    if (i > 0) K.insert(i, i - 1) = -1.0;
    if (i + 1 < n) K.insert(i, i + 1) = -1.0;
    if (!every_other_massless || i % 2 == 1) M.insert(i, i) = 1.0;
  }
}

TEST(LowestModes, OfAChainAreTheExactOnesByEitherMethod) {
  Sparse K, M;
  const int n = 60, count = 5;
  chain(n, false, K, M);
  for (EigenMethod method : {EigenMethod::kDense, EigenMethod::kSubspace}) {
    const Modes modes = lowest_modes(K, M, count, 0.0, method);
    for (int k = 0; k < count; ++k) {
      const double omega = 2.0 * std::sin((k + 1) * kPi / (2.0 * (n + 1)));
      EXPECT_NEAR(modes.lambda(k), omega * omega, 1e-10 * omega * omega);
    }
    const Eigen::MatrixXd orthonormal = modes.shapes.transpose() * M * modes.shapes;
    EXPECT_LT((orthonormal - Eigen::MatrixXd::Identity(count, count)).norm(), 1e-10);
  }
}

TEST(LowestModes, OfMasslessDegreesOfFreedomFollowStatically) {
  // Condensed, masses at odd places are joined by springs 1/2, with a whole spring 1 from the last to the
  // wall.
  Sparse K, M;
  chain(21, true, K, M);
  Eigen::MatrixXd K10 = Eigen::MatrixXd::Zero(10, 10);
  for (int i = 0; i < 10; ++i) {
    K10(i, i) = 1.0;
    if (i > 0) K10(i, i - 1) = K10(i - 1, i) = -0.5;
  }
  const Eigen::VectorXd exact = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K10).eigenvalues();
  EXPECT_LT((lowest_modes(K, M, 10, 0.0).lambda - exact).norm(), 1e-10);
  EXPECT_LT((lowest_modes(K, M, 4, 0.0, EigenMethod::kSubspace).lambda - exact.head(4)).norm(), 1e-10);
  EXPECT_THROW(lowest_modes(K, M, 11, 0.0), InputError) << "ten masses have ten modes";
  EXPECT_THROW(lowest_modes(K, M, 22, 0.0), InputError) << "more modes than degrees of freedom";
}

TEST(LowestModes, OfAFreePlateAgreeBetweenTheMethods) {
  const FeModel model = plate_model(disc_mesh(0.2, 0.05), 0.004, Material{7850.0, 207e9, 0.3});
  const Sparse M = lumped_mass_matrix(model);
  const int count = 16;
  const double shift = elastic_scale(model);
  const Modes dense = lowest_modes(model.stiffness, M, count, shift, EigenMethod::kDense);
  const Modes subspace = lowest_modes(model.stiffness, M, count, shift, EigenMethod::kSubspace);
  const double round_off = 1e-7;  // of lambda: the membrane is 1e6 times as stiff as bending
  for (int k = 6; k < count; ++k) EXPECT_NEAR(subspace.lambda(k), dense.lambda(k), round_off * dense.lambda(k));
  for (int k = 0; k < 6; ++k) EXPECT_LT(std::abs(subspace.lambda(k)), round_off * dense.lambda(6));
  // The same space: mass products of the two sets of elastic modes are an orthogonal matrix (pairs may be
  // turned).
  const Eigen::MatrixXd P = dense.shapes.rightCols(8).transpose() * M * subspace.shapes.rightCols(8);
  EXPECT_GT(std::abs(P.leftCols(2).norm()), std::sqrt(2.0) * (1.0 - 1e-6));
}

TEST(LowestModes, RefuseABodyThatFloatsWithoutShift) {
  Sparse K(2, 2), M(2, 2);
  K.insert(0, 0) = K.insert(1, 1) = 1.0;
  K.insert(0, 1) = K.insert(1, 0) = -1.0;
  M.setIdentity();
  EXPECT_THROW(lowest_modes(K, M, 1, 0.0), InputError);
  EXPECT_NEAR(lowest_modes(K, M, 2, 1.0).lambda(1), 2.0, 1e-12);
}

}  // namespace
}  // namespace footfall
