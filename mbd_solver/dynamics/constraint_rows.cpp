// Rows are scaled by the Cholesky factors of the masses; SPQR orders them, and rows behind its rank are combinations of the
// others.

#include "mbd_solver/dynamics/constraint_rows.h"

#include <Eigen/SPQRSupport>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <set>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/body_force.h"

namespace footfall {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr double kTakesPart = 1e-6;  // smallest share of a unit row in a combination
constexpr double kZero = 1e-15;      // round-off of the factors of unit rows

// Representative of the set that `i` belongs to, paths shortened.
int root(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

// Solves R x = a column of R behind its first `rank` columns. Visits only entries that are reached from the entries
// of this column, in the order of a back substitution.
class BackSubstitution {
 public:
  explicit BackSubstitution(const SparseMatrix& R) : R_(R), x_(Eigen::VectorXd::Zero(R.rows())) {}

  // visit(i, x_i), i falling, for x_i that are not zero.
  template <typename Visit>
  void solve(Eigen::Index column, Visit visit) {
    for (SparseMatrix::InnerIterator entry(R_, column); entry; ++entry) subtract(entry.index(), -entry.value());
    while (!reached_.empty()) {
      const Eigen::Index i = reached_.top();
      reached_.pop();
      if (std::abs(x_[i]) <= kZero) {  // cancelled, or reached twice
        x_[i] = 0.0;
        continue;
      }
      const Eigen::Index last = R_.outerIndexPtr()[i + 1] - 1;  // the diagonal
      const double x = x_[i] / R_.valuePtr()[last];
      x_[i] = 0.0;
      for (Eigen::Index k = R_.outerIndexPtr()[i]; k < last; ++k) subtract(R_.innerIndexPtr()[k], x * R_.valuePtr()[k]);
      visit(i, x);
    }
  }

 private:
  void subtract(Eigen::Index i, double value) {
    if (x_[i] == 0.0) reached_.push(i);
    x_[i] -= value;
  }

  const SparseMatrix& R_;
  Eigen::VectorXd x_;  // zero between calls
  std::priority_queue<Eigen::Index> reached_;
};

}  // namespace

// A P = Q [R; 0], R with `rank` rows, its first columns upper triangular. Columns of A are unit vectors; one with an
// independent part below `tolerance` is a combination of the others and follows them.
struct ConstraintRows::Factors {
  Factors(const SparseMatrix& A, double rank_tolerance) : tolerance(rank_tolerance), size(A.rows()) {
    qr.setPivotThreshold(tolerance);
    qr.compute(A);
    FOOTFALL_DEMAND(qr.info() == Eigen::Success);
    rank = qr.rank();
    R = SparseMatrix(qr.matrixR()).topRows(rank);
    order.resize(static_cast<std::size_t>(A.cols()));
    for (std::size_t k = 0; k < order.size(); ++k)
      order[k] = static_cast<int>(qr.colsPermutation().indices()[static_cast<Eigen::Index>(k)]);
  }
  // Q [z; 0]
  Eigen::VectorXd in_range(const Eigen::VectorXd& z) const {
    Eigen::VectorXd padded = Eigen::VectorXd::Zero(size);
    padded.head(rank) = z;
    return qr.matrixQ() * padded;
  }

  double tolerance;
  Eigen::SPQR<SparseMatrix> qr;
  Eigen::Index size = 0, rank = 0;
  SparseMatrix R;
  std::vector<int> order;  // column k of A P is column order[k] of A
  // R^T P = Q' [R'; 0]: least squares with more rows than rank, made when they are used.
  std::unique_ptr<Eigen::SPQR<SparseMatrix>> least_squares;
};

// A sum of y_i times unit row i that is zero.
struct ConstraintRows::Combination {
  int follows = -1;  // the row that follows from the others, y = -1; -1: a link of split bodies
  std::vector<std::pair<int, double>> entries;  // i, y_i
};

ConstraintRows::ConstraintRows(const Model& model, const Layout& layout)
    : model_(model), layout_(layout), kinematics_(model), split_(model, layout) {}

ConstraintRows::~ConstraintRows() = default;

void ConstraintRows::evaluate(const State& state) {
  const int m = layout_.row_count;
  kinematics_.load(layout_, state.q, state.v, Eigen::VectorXd());
  kinematics_.load_turns(layout_, state.z);
  masses_.clear();
  for (int i = 0; i < model_.body_count(); ++i) {
    const int n = kinematics_.of(i).size();
    Eigen::MatrixXd M(n, n);
    InertiaScratch scratch(n - 6);
    body_mass_matrix(model_.body(i), kinematics_.of(i), scratch, M);
    masses_.push_back(M.llt().matrixL());
  }
  phi = rate = Eigen::VectorXd::Zero(m);
  scale = Eigen::VectorXd::Ones(m);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd phi_v;
  for (int j = 0; j < model_.joint_count(); ++j) {
    const Joint& joint = model_.joint(j);
    const int bodies[2] = {joint.m1.body, joint.m2.body};
    const PairMotion pair = kinematics_.pair(bodies[0], bodies[1]);
    phi_v.resize(pair.size());
    MarkerVectors vectors(pair, joint.m1, joint.m2);
    for (std::size_t k = 0; k < joint.rows.size(); ++k) {
      const int row = layout_.joint_row[j] + static_cast<int>(k);
      const RowValue value = evaluate_row(joint.rows[k], state.time, vectors, phi_v, kinematics_.turns(j));
      phi[row] += value.phi;
      rate[row] += value.rate;
      for (int i = 0; i < 2; ++i) {  // C^-1 of each body
        if (bodies[i] == kGround) continue;
        Eigen::Ref<Eigen::VectorXd> part = phi_v.segment(pair.offset(i), pair.body[i]->size());
        masses_[bodies[i]].triangularView<Eigen::Lower>().solveInPlace(part);
      }
      if (joint.rows[k].inertia > 0.0) phi_v.setZero();  // a rotor is no condition
      const double size = phi_v.norm();
      if (size > 0.0 && layout_.shared[row] == 0) scale[row] = 1.0 / size;
      for (int i = 0; i < 2; ++i) {
        if (bodies[i] == kGround) continue;
        const int v = layout_.body_v[bodies[i]];
        for (int l = 0; l < pair.body[i]->size(); ++l)
          entries.emplace_back(v + l, row, scale[row] * phi_v[pair.offset(i) + l]);
      }
    }
  }
  const SparseMatrix before = std::move(transposed_);
  transposed_.resize(layout_.v_size, m);
  transposed_.setFromTriplets(entries.begin(), entries.end());
  transposed_.makeCompressed();
  // The rows of gears are sums: their lengths are known only here.
  for (int row = 0; row < m; ++row) {
    if (layout_.shared[row] == 0) continue;
    const double size = transposed_.col(row).norm();
    if (size > 0.0) scale[row] = 1.0 / size;
    transposed_.col(row) *= scale[row];
  }
  const bool same = before.nonZeros() == transposed_.nonZeros() &&
                    std::equal(before.valuePtr(), before.valuePtr() + before.nonZeros(), transposed_.valuePtr());
  if (!same) factors_.reset();
}

ConstraintRows::Factors& ConstraintRows::factors(double rank_tolerance) {
  if (!factors_ || factors_->tolerance != rank_tolerance)
    factors_ = std::make_unique<Factors>(split_.any() ? split_.split(transposed_) : transposed_, rank_tolerance);
  return *factors_;
}

Eigen::Index ConstraintRows::factor_entries(double rank_tolerance) { return factors(rank_tolerance).R.nonZeros(); }

Eigen::VectorXd ConstraintRows::correction(const Eigen::VectorXd& defect, double rank_tolerance) {
  // B^T P = Q [R; 0]: B x = d becomes R^T z = P^T d, x = Q [z; 0]. Links of split bodies are closed.
  Factors& qr = factors(rank_tolerance);
  Eigen::VectorXd d = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(qr.order.size()));
  for (Eigen::Index k = 0; k < d.size(); ++k) {
    const int row = qr.order[k];
    if (row < layout_.row_count) d[k] = scale[row] * defect[row];
  }
  Eigen::VectorXd z;
  if (qr.rank == d.size()) {
    z = qr.R.transpose().triangularView<Eigen::Lower>().solve(d);
  } else {
    if (!qr.least_squares) {
      qr.least_squares = std::make_unique<Eigen::SPQR<SparseMatrix>>();
      qr.least_squares->setPivotThreshold(0.0);
      qr.least_squares->compute(SparseMatrix(qr.R.transpose()));
    }
    z = qr.least_squares->solve(d);
  }
  Eigen::VectorXd x = -(split_.any() ? split_.joined(qr.in_range(z)) : qr.in_range(z));
  for (int i = 0; i < model_.body_count(); ++i) {
    Eigen::Ref<Eigen::VectorXd> part = x.segment(layout_.body_v[i], kinematics_.of(i).size());
    masses_[i].transpose().triangularView<Eigen::Upper>().solveInPlace(part);
  }
  return x;
}

bool ConstraintRows::is_rotor(int row) const {
  const std::size_t joint = static_cast<std::size_t>(layout_.row_joint[row]);
  return model_.joint(static_cast<int>(joint)).rows[row - layout_.joint_row[joint]].inertia > 0.0;
}

// Every column of R behind the first `rank` ones is a combination of these, R x = the column: y = [x; -1] is a null vector of
// B^T. Its rows of joints alone are one as well: links cancel in the sum over the copies of a body.
std::vector<ConstraintRows::Combination> ConstraintRows::combinations(double rank_tolerance) {
  const Factors& qr = factors(rank_tolerance);
  const auto row_of = [&](Eigen::Index k) {
    const int row = qr.order[k];
    return row < layout_.row_count ? row : -1;
  };
  std::vector<Combination> out;
  BackSubstitution substitution(qr.R);
  for (Eigen::Index k = qr.rank; k < qr.R.cols(); ++k) {
    Combination combination;
    combination.follows = row_of(k);
    if (combination.follows >= 0) {
      if (is_rotor(combination.follows)) continue;
      combination.entries.emplace_back(combination.follows, -1.0);
    }
    substitution.solve(k, [&](Eigen::Index i, double x) {
      if (row_of(i) >= 0 && std::abs(x) > kTakesPart) combination.entries.emplace_back(row_of(i), x);
    });
    out.push_back(std::move(combination));
  }
  return out;
}

std::vector<RedundantGroup> ConstraintRows::redundant(double rank_tolerance) {
  const std::vector<Combination> found = combinations(rank_tolerance);
  const auto joint_of = [&](int row) { return layout_.row_joint[row]; };

  // One group per set of joints with common combinations.
  std::vector<int> parent(static_cast<std::size_t>(model_.joint_count()));
  std::iota(parent.begin(), parent.end(), 0);
  for (const Combination& combination : found)
    for (const auto& [row, y] : combination.entries)
      parent[root(parent, joint_of(row))] = root(parent, joint_of(combination.entries.front().first));
  std::map<int, std::vector<const Combination*>> of_group;
  for (const Combination& combination : found)
    of_group[root(parent, joint_of(combination.entries.front().first))].push_back(&combination);
  std::map<int, RedundantGroup> groups;
  for (int j = 0; j < model_.joint_count(); ++j) {
    if (of_group.count(root(parent, j)) == 0) continue;
    RedundantGroup& group = groups[root(parent, j)];
    group.joints.push_back(j);
    group.joint_size.push_back(static_cast<int>(model_.joint(j).rows.size()));
    for (std::size_t i = 0; i < model_.joint(j).rows.size(); ++i)
      group.rows.push_back(layout_.joint_row[j] + static_cast<int>(i));
  }
  std::vector<RedundantGroup> out;
  for (auto& [key, group] : groups) {
    complete(of_group.at(key), group);
    out.push_back(std::move(group));
  }
  return out;
}

void ConstraintRows::complete(const std::vector<const Combination*>& combinations, RedundantGroup& group) const {
  const Eigen::Index m = static_cast<Eigen::Index>(group.rows.size());
  const Eigen::Index columns = static_cast<Eigen::Index>(combinations.size());
  Eigen::MatrixXd Y = Eigen::MatrixXd::Zero(m, columns);
  std::vector<Eigen::Index> links;
  for (Eigen::Index k = 0; k < columns; ++k) {
    const Combination& combination = *combinations[k];
    for (const auto& [row, y] : combination.entries)
      Y(std::lower_bound(group.rows.begin(), group.rows.end(), row) - group.rows.begin(), k) = y;
    group.dropped.push_back(combination.follows);
    if (combination.follows < 0) links.push_back(k);
  }
  // Where a link follows, a row follows as well: the pivots of these combinations, which leave all others.
  if (!links.empty()) {
    Eigen::MatrixXd of_links(m, static_cast<Eigen::Index>(links.size()));
    for (std::size_t k = 0; k < links.size(); ++k) of_links.col(static_cast<Eigen::Index>(k)) = Y.col(links[k]);
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(of_links);
    const Eigen::VectorXi moved_to = lu.permutationP().indices();
    std::vector<Eigen::Index> pivots(links.size());
    for (Eigen::Index i = 0; i < m; ++i)
      if (moved_to[i] < of_links.cols()) pivots[moved_to[i]] = i;
    Eigen::MatrixXd block(of_links.cols(), of_links.cols());
    for (std::size_t k = 0; k < pivots.size(); ++k) block.row(static_cast<Eigen::Index>(k)) = of_links.row(pivots[k]);
    of_links *= Eigen::FullPivLU<Eigen::MatrixXd>(-block).inverse();
    for (std::size_t k = 0; k < links.size(); ++k) {
      group.dropped[links[k]] = group.rows[pivots[k]];
      Y.col(links[k]) = of_links.col(static_cast<Eigen::Index>(k));
    }
    for (Eigen::Index k = 0; k < columns; ++k) {
      if (combinations[k]->follows < 0) continue;
      for (std::size_t l = 0; l < links.size(); ++l)
        Y.col(k) += Y(pivots[l], k) * of_links.col(static_cast<Eigen::Index>(l));
    }
  }
  group.s = joint_lengths(group);
  for (Eigen::Index k = 0; k < columns; ++k) {
    std::set<int> from;
    for (Eigen::Index i = 0; i < m; ++i) {
      const int row = group.rows[i];
      if (std::abs(Y(i, k)) > kTakesPart && row != group.dropped[k]) from.insert(layout_.row_joint[row]);
    }
    group.sources.emplace_back(from.begin(), from.end());
    for (Eigen::Index i = 0; i < m; ++i) Y(i, k) = group.s[i] * scale[group.rows[i]] * Y(i, k);
  }
  group.U = Eigen::HouseholderQR<Eigen::MatrixXd>(Y).householderQ() * Eigen::MatrixXd::Identity(m, Y.cols());
}

Eigen::VectorXd ConstraintRows::joint_lengths(const RedundantGroup& group) const {
  Eigen::VectorXd s(static_cast<Eigen::Index>(group.rows.size()));
  const auto row_of = [&](int row) -> const ConstraintRow& {
    const int joint = layout_.row_joint[row];
    return model_.joint(joint).rows[row - layout_.joint_row[joint]];
  };
  const auto joint_of = [&](std::size_t i) { return layout_.row_joint[group.rows[i]]; };
  for (std::size_t begin = 0, end = 0; begin < group.rows.size(); begin = end) {  // rows of a joint
    while (end < group.rows.size() && joint_of(end) == joint_of(begin)) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      double sum = 0.0;
      int count = 0;
      for (std::size_t k = begin; k < end; ++k) {
        if (row_of(group.rows[k]).unit != row_of(group.rows[i]).unit) continue;
        sum += 1.0 / (scale[group.rows[k]] * scale[group.rows[k]]);
        ++count;
      }
      s[static_cast<Eigen::Index>(i)] = std::sqrt(sum / count);
    }
  }
  return s;
}

Redundancy::Redundancy(const RedundantGroup& group)
    : joints_(group.joints), rows_(group.rows), count_(static_cast<int>(group.U.cols())), s_(group.s) {
  Y_ = Eigen::MatrixXd::Zero(group.U.rows(), group.U.cols());
  rest(group.U);
}

void Redundancy::rest(const Eigen::MatrixXd& combinations) {
  resting_.clear();
  if (combinations.cols() == 0) return;
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(combinations);
  const Eigen::VectorXi moved_to = lu.permutationP().indices();  // row i is the moved_to[i]-th pivot
  for (Eigen::Index i = 0; i < moved_to.size(); ++i)
    if (moved_to[i] < combinations.cols()) resting_.push_back(static_cast<int>(i));
}

void Redundancy::set_combination(int k, const Eigen::Ref<const Eigen::VectorXd>& y) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    Y_(static_cast<Eigen::Index>(i), k) = s_[static_cast<Eigen::Index>(i)] * y[rows_[i]];
}

}  // namespace footfall
