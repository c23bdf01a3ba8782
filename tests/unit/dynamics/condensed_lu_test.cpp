// Solutions with inner states eliminated first are those of the whole matrix. mbd_solver/dynamics/condensed_lu.h.

#include "mbd_solver/dynamics/condensed_lu.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "mbd_solver/dynamics/sparse_blocks.h"

namespace footfall {
namespace {

constexpr double kSolvedTo = 1e-12;  // of a solution of size 1, condition below 1e3

// Two bodies of six velocities, six conditions between them, and contacts: the first body's places in blocks of two, those
// between both in blocks of three.
struct ContactSystem {
  static constexpr int kBody = 6, kPlane = 8, kPair = 9, kRows = 6;
  static constexpr int z_plane = 2 * kBody, z_pair = z_plane + kPlane, lambda = z_pair + kPair, size = lambda + kRows;
  std::vector<InnerStates> inner{{z_plane, kPlane, 2}, {z_pair, kPair, 3}};
  Eigen::SparseMatrix<double> matrix;

  explicit ContactSystem(unsigned seed) {
    SparsePattern pattern(size);
    pattern.add_block(0, 2 * kBody, 0, 2 * kBody);
    pattern.add_block(z_plane, kPlane, 0, kBody);
    pattern.add_block(0, kBody, z_plane, kPlane);
    for (int z = z_plane; z < z_pair; z += 2) pattern.add_block(z, 2, z, 2);
    pattern.add_block(z_pair, kPair, 0, 2 * kBody);
    pattern.add_block(0, 2 * kBody, z_pair, kPair);
    for (int z = z_pair; z < lambda; z += 3) pattern.add_block(z, 3, z, 3);
    pattern.add_block(lambda, kRows, 0, 2 * kBody);
    pattern.add_block(0, 2 * kBody, lambda, kRows);
    pattern.add_diagonal(lambda, lambda, kRows);
    matrix = pattern.build();
    fill(seed);
  }
  // Every second place touches nothing: its rows and columns are zero but for its own block.
  void fill(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int col = 0; col < size; ++col) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, col); entry; ++entry) {
        const int row = static_cast<int>(entry.row());
        const bool own = idle(row) >= 0 && idle(row) == idle(col);
        entry.valueRef() = (idle(row) >= 0 || idle(col) >= 0) && !own ? 0.0 : uniform(random);
        if (row == col && row < lambda) entry.valueRef() += 6.0;
      }
    }
  }
  // Number of the idle place that a state belongs to; -1: none.
  static int idle(int i) {
    if (i < z_plane || i >= lambda) return -1;
    const int place = i < z_pair ? (i - z_plane) / 2 : 10 + (i - z_pair) / 3;
    return place % 2 == 1 ? place : -1;
  }
};

TEST(CondensedLu, SolvesTheWholeSystem) {
  ContactSystem system(1);
  CondensedLu lu(system.matrix, system.inner);
  EXPECT_EQ(lu.condensed_size(), ContactSystem::size - ContactSystem::kPlane - ContactSystem::kPair);
  for (unsigned seed = 1; seed < 20; ++seed) {  // factored again with other values
    system.fill(seed);
    ASSERT_TRUE(lu.factor());
    std::srand(seed);
    const Eigen::VectorXd x = Eigen::VectorXd::Random(ContactSystem::size);
    Eigen::VectorXd b = system.matrix * x;
    lu.solve(b);
    EXPECT_LT((b - x).lpNorm<Eigen::Infinity>(), kSolvedTo) << seed;
  }
}

TEST(CondensedLu, WithoutInnerStatesIsTheSparseLu) {
  ContactSystem system(3);
  CondensedLu condensed(system.matrix, {});
  SparseLu plain(system.matrix);
  ASSERT_TRUE(condensed.factor() && plain.factor());
  std::srand(3);
  Eigen::VectorXd a = Eigen::VectorXd::Random(ContactSystem::size), b = a;
  condensed.solve(a);
  plain.solve(b);
  EXPECT_EQ(a, b);
}

TEST(CondensedLu, RefusesASingularPlace) {
  ContactSystem system(4);
  CondensedLu lu(system.matrix, system.inner);
  for (int q = 0; q < 2; ++q)
    for (int p = 0; p < 2; ++p) system.matrix.coeffRef(ContactSystem::z_plane + p, ContactSystem::z_plane + q) = 0.0;
  EXPECT_FALSE(lu.factor());
}

}  // namespace
}  // namespace footfall
