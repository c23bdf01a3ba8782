#include "mbd_solver/model/column_groups.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd product(const ColumnGroups& A, const VectorXd& x, Eigen::Index rows) {
  VectorXd y = VectorXd::Zero(rows), scratch(rows + x.size());
  A.add_product(x, y, scratch);
  return y;
}

// Columns of three kinds by turns, each with its own third of the rows.
MatrixXd three_kinds(int rows, int columns) {
  MatrixXd A = MatrixXd::Zero(rows, columns);
  for (int l = 0; l < columns; ++l)
    for (int r = l % 3; r < rows; r += 3) A(r, l) = 1.0 + 0.01 * r + 0.1 * l;
  return A;
}

TEST(ColumnGroups, GiveTheProductOfTheWholeMatrix) {
  for (const int columns : {0, 1, 2, 7, 30}) {
    const int rows = 9 * columns;
    MatrixXd some = MatrixXd::Random(rows, columns);
    some = (some.array().abs() < 0.8).select(0.0, some);
    for (const MatrixXd& A : {MatrixXd(MatrixXd::Random(rows, columns)), three_kinds(rows, columns), some,
                              MatrixXd(MatrixXd::Zero(rows, columns))}) {
      const VectorXd x = VectorXd::Random(columns), wanted = A * x;
      EXPECT_LT((product(ColumnGroups(A), x, rows) - wanted).norm(), 1e-14 * (1.0 + A.norm())) << columns;
    }
  }
}

TEST(ColumnGroups, KeepNoZeros) {
  EXPECT_EQ(ColumnGroups(three_kinds(90, 30)).entries(), 30 * 30);
  EXPECT_EQ(ColumnGroups(MatrixXd(MatrixXd::Zero(90, 30))).entries(), 0);
  EXPECT_EQ(ColumnGroups(MatrixXd(MatrixXd::Ones(90, 30))).entries(), 90 * 30);
  const MatrixXd round_off = three_kinds(90, 30) + 1e-16 * MatrixXd::Random(90, 30);
  EXPECT_EQ(ColumnGroups(round_off).entries(), 30 * 30);
}

TEST(ColumnGroups, KeepSmallMatricesWhole) {
  EXPECT_EQ(ColumnGroups(three_kinds(9, 3)).entries(), 9 * 3) << "a product more costs more than a few zeros";
}

}  // namespace
}  // namespace footfall
