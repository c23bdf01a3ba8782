// A system without its local unknowns has the solution of the whole system.
#include "mbd_solver/dynamics/condensed_matrix.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "mbd_solver/dynamics/sparse_lu.h"

namespace footfall {
namespace {

// Unknowns 0 to 3 stay, 4 to 9 are blocks of two, 10 stays, 11 and 12 are blocks of one; block 6, 7 acts on nothing.
class Condensed : public ::testing::Test {
 protected:
  Condensed() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    std::vector<Eigen::Triplet<double>> entries;
    for (const int i : {0, 1, 2, 3, 10})
      for (const int j : {0, 1, 2, 3, 10}) entries.emplace_back(i, j, number(random) + (i == j ? 4.0 : 0.0));
    for (int first = 4; first < 10; first += 2)
      for (int i = first; i < first + 2; ++i) {
        for (int j = first; j < first + 2; ++j) entries.emplace_back(i, j, number(random) + (i == j ? 3.0 : 0.0));
        for (const int j : {1, 2, 10}) {
          entries.emplace_back(i, j, first == 6 ? 0.0 : number(random));
          entries.emplace_back(j, i, first == 6 ? 0.0 : number(random));
        }
      }
    for (int i = 11; i < 13; ++i) {
      entries.emplace_back(i, i, 2.0 + number(random));
      entries.emplace_back(i, 0, number(random));
      entries.emplace_back(3, i, number(random));
    }
    whole.resize(13, 13);
    whole.setFromTriplets(entries.begin(), entries.end());
    whole.makeCompressed();
  }
  Eigen::SparseMatrix<double> whole;
  const std::vector<LocalUnknowns> local = {{4, 6, 2}, {11, 2, 1}};
};

TEST_F(Condensed, SolvesTheWhole) {
  CondensedMatrix condensed(whole, local);
  ASSERT_EQ(condensed.matrix().rows(), 5);
  for (const double factor : {1.0, -2.5}) {  // other values in the same pattern
    for (int k = 0; k < whole.nonZeros(); ++k) whole.valuePtr()[k] *= factor;
    ASSERT_TRUE(condensed.update());
    SparseLu lu(condensed.matrix());
    ASSERT_TRUE(lu.factor());
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(13, -3.0, 5.0);
    Eigen::VectorXd x = b;
    condensed.solve(x, [&](Eigen::Ref<Eigen::VectorXd> y) { lu.solve(y); });
    EXPECT_LT((whole * x - b).norm(), 1e-13 * b.norm());  // round-off of a well-conditioned matrix
  }
}

TEST_F(Condensed, SolvesBlocksOfThree) {
  for (const int first : {4, 7})  // 4 to 9, which act on each other within three from now on
    for (int i = first; i < first + 3; ++i)
      for (int j = first; j < first + 3; ++j) whole.coeffRef(i, j) = i == j ? 3.0 + 0.1 * i : 0.3 * i - 0.2 * j;
  whole.coeffRef(6, 7) = whole.coeffRef(7, 6) = 0.0;
  whole.prune(0.0);
  CondensedMatrix condensed(whole, {{4, 6, 3}, {11, 2, 1}});
  ASSERT_EQ(condensed.matrix().rows(), 5);
  ASSERT_TRUE(condensed.update());
  SparseLu lu(condensed.matrix());
  ASSERT_TRUE(lu.factor());
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(13, -3.0, 5.0);
  Eigen::VectorXd x = b;
  condensed.solve(x, [&](Eigen::Ref<Eigen::VectorXd> y) { lu.solve(y); });
  EXPECT_LT((whole * x - b).norm(), 1e-12 * b.norm());
}

TEST_F(Condensed, IsTheMatrixItselfWithoutLocalUnknowns) {
  const CondensedMatrix condensed(whole, {});
  EXPECT_EQ(&condensed.matrix(), &whole);
}

TEST_F(Condensed, TellsOfASingularBlock) {
  CondensedMatrix condensed(whole, local);
  whole.coeffRef(11, 11) = 0.0;
  EXPECT_FALSE(condensed.update());
}

}  // namespace
}  // namespace footfall
