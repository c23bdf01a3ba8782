#pragma once
// A constant matrix that is partly empty, as a few dense blocks: columns with entries in much the same rows form a group
// that stores these rows only.   y += A x  is one dense product for each group.
// Modes of a straight rod bend along one principal axis each, so that many sums over two modes are zero in these axes. For
// a body of general shape none is zero: one group.

#include <Eigen/Dense>
#include <vector>

namespace footfall {

class ColumnGroups {
 public:
  static constexpr double kRoundOff = 1e-14;  // of the largest entry: smaller ones count as zero

  ColumnGroups() = default;
  explicit ColumnGroups(const Eigen::MatrixXd& A);

  // y += A x. `scratch`: rows + columns of A, overwritten.
  void add_product(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> y,
                   Eigen::Ref<Eigen::VectorXd> scratch) const;
  Eigen::Index entries() const;  // multiplied entries, zeros included

 private:
  struct Group {
    std::vector<int> rows, columns;  // of A, rising
    Eigen::MatrixXd values;
  };
  std::vector<Group> groups_;
};

}  // namespace footfall
