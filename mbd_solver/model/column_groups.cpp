// Groups are found greedily: each column joins the group to which it adds the lowest cost, or begins a new one.

#include "mbd_solver/model/column_groups.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Approximate cost of a group in instructions: one product, its rows added and its columns collected one by one.
double cost(Index rows, Index columns) {
  const double product = 60.0, row = 4.0, column = 4.0, entry = 1.75;
  return product + static_cast<double>(rows) * (row + entry * static_cast<double>(columns)) +
         column * static_cast<double>(columns);
}

using Support = Eigen::Array<bool, Eigen::Dynamic, 1>;  // rows with an entry

struct Columns {
  Support support;
  std::vector<int> members;
  double cost_with(const Support& more, Index columns) const {
    return cost((support || more).count(), static_cast<Index>(members.size()) + columns);
  }
};

std::vector<Columns> gather(const Eigen::MatrixXd& A) {
  const double zero = A.size() > 0 ? ColumnGroups::kRoundOff * A.cwiseAbs().maxCoeff() : 0.0;
  std::vector<Columns> groups;
  for (Index l = 0; l < A.cols(); ++l) {
    const Support support = A.col(l).array().abs() > zero;
    if (!support.any()) continue;
    double least = cost(support.count(), 1);
    Columns* joined = nullptr;
    for (Columns& group : groups) {
      const double more = group.cost_with(support, 1) - group.cost_with(group.support, 0);
      if (more >= least) continue;
      least = more;
      joined = &group;
    }
    if (!joined) joined = &groups.emplace_back(Columns{support, {}});
    joined->support = joined->support || support;
    joined->members.push_back(static_cast<int>(l));
  }
  return groups;
}

}  // namespace

ColumnGroups::ColumnGroups(const Eigen::MatrixXd& A) {
  for (const Columns& columns : gather(A)) {
    Group group;
    group.columns = columns.members;
    for (Index r = 0; r < A.rows(); ++r)
      if (columns.support(r)) group.rows.push_back(static_cast<int>(r));
    group.values = A(group.rows, group.columns);
    groups_.push_back(std::move(group));
  }
}

void ColumnGroups::add_product(const Eigen::Ref<const VectorXd>& x, Eigen::Ref<VectorXd> y,
                               Eigen::Ref<VectorXd> scratch) const {
  for (const Group& group : groups_) {
    const Index rows = group.values.rows(), columns = group.values.cols();
    if (rows == y.size() && columns == x.size()) {
      y.noalias() += group.values * x;
      continue;
    }
    auto of_group = scratch.head(columns), sums = scratch.segment(columns, rows);
    for (Index l = 0; l < columns; ++l) of_group(l) = x(group.columns[l]);
    sums.noalias() = group.values * of_group;
    for (Index r = 0; r < rows; ++r) y(group.rows[r]) += sums(r);
  }
}

Index ColumnGroups::entries() const {
  Index sum = 0;
  for (const Group& group : groups_) sum += group.values.size();
  return sum;
}

}  // namespace footfall
