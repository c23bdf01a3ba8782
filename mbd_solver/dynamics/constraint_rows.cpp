// Rows are scaled by the Cholesky factors of the masses; SPQR orders them, and rows behind its rank are combinations of the
// others.

#include "mbd_solver/dynamics/constraint_rows.h"

#include <Eigen/SPQRSupport>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/body_force.h"

namespace footfall {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr double kTakesPart = 1e-6;  // smallest share of a unit row in a combination

// A P = Q [R; 0], R with `rank` rows, its first columns upper triangular. Columns of A are unit vectors; one with an
// independent part below `tolerance` is a combination of the others and follows them.
struct SparseQr {
  SparseQr(const SparseMatrix& A, double tolerance) : size(A.rows()) {
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

  Eigen::SPQR<SparseMatrix> qr;
  Eigen::Index size = 0, rank = 0;
  SparseMatrix R;
  std::vector<int> order;  // column k of A P is column order[k] of A
};

// Representative of the set that `i` belongs to, paths shortened.
int root(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    parent[static_cast<std::size_t>(i)] = parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(i)])];
    i = parent[static_cast<std::size_t>(i)];
  }
  return i;
}

}  // namespace

ConstraintRows::ConstraintRows(const Model& model, const Layout& layout)
    : model_(model), layout_(layout), kinematics_(model) {}

void ConstraintRows::evaluate(const State& state) {
  const int m = layout_.row_count;
  kinematics_.load(layout_, state.q, state.v, Eigen::VectorXd());
  kinematics_.load_turns(layout_, state.z);
  factors_.clear();
  for (int i = 0; i < model_.body_count(); ++i) {
    const int n = kinematics_.of(i).size();
    Eigen::MatrixXd M(n, n);
    InertiaScratch scratch(n - 6);
    body_mass_matrix(model_.body(i), kinematics_.of(i), scratch, M);
    factors_.push_back(M.llt().matrixL());
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
      const int row = layout_.joint_row[static_cast<std::size_t>(j)] + static_cast<int>(k);
      const RowValue value = evaluate_row(joint.rows[k], state.time, vectors, phi_v, kinematics_.turns(j));
      phi[row] += value.phi;
      rate[row] += value.rate;
      for (int i = 0; i < 2; ++i) {  // C^-1 of each body
        if (bodies[i] == kGround) continue;
        Eigen::Ref<Eigen::VectorXd> part = phi_v.segment(pair.offset(i), pair.body[i]->size());
        factors_[static_cast<std::size_t>(bodies[i])].triangularView<Eigen::Lower>().solveInPlace(part);
      }
      if (joint.rows[k].inertia > 0.0) phi_v.setZero();  // a rotor is no condition
      const double size = phi_v.norm();
      if (size > 0.0 && layout_.shared[static_cast<std::size_t>(row)] == 0) scale[row] = 1.0 / size;
      for (int i = 0; i < 2; ++i) {
        if (bodies[i] == kGround) continue;
        const int v = layout_.body_v[static_cast<std::size_t>(bodies[i])];
        for (int l = 0; l < pair.body[i]->size(); ++l)
          entries.emplace_back(v + l, row, scale[row] * phi_v[pair.offset(i) + l]);
      }
    }
  }
  transposed_.resize(layout_.v_size, m);
  transposed_.setFromTriplets(entries.begin(), entries.end());
  transposed_.makeCompressed();
  // The rows of gears are sums: their lengths are known only here.
  for (int row = 0; row < m; ++row) {
    if (layout_.shared[static_cast<std::size_t>(row)] == 0) continue;
    const double size = transposed_.col(row).norm();
    if (size > 0.0) scale[row] = 1.0 / size;
    transposed_.col(row) *= scale[row];
  }
}

Eigen::VectorXd ConstraintRows::correction(const Eigen::VectorXd& defect, double rank_tolerance) const {
  // B^T P = Q [R; 0]: B x = d becomes R^T z = P^T d, x = Q [z; 0].
  const SparseQr qr(transposed_, rank_tolerance);
  Eigen::VectorXd d(layout_.row_count);
  for (Eigen::Index k = 0; k < d.size(); ++k) {
    const int row = qr.order[static_cast<std::size_t>(k)];
    d[k] = scale[row] * defect[row];
  }
  Eigen::VectorXd z;
  if (qr.rank == layout_.row_count) {
    z = qr.R.transpose().triangularView<Eigen::Lower>().solve(d);
  } else {  // more rows than rank: least squares, R^T P = Q' [R'; 0]
    const SparseMatrix Rt = qr.R.transpose();
    Eigen::SPQR<SparseMatrix> least_squares;
    least_squares.setPivotThreshold(0.0);
    least_squares.compute(Rt);
    z = least_squares.solve(d);
  }
  Eigen::VectorXd x = -qr.in_range(z);
  for (int i = 0; i < model_.body_count(); ++i) {
    Eigen::Ref<Eigen::VectorXd> part = x.segment(layout_.body_v[static_cast<std::size_t>(i)], kinematics_.of(i).size());
    factors_[static_cast<std::size_t>(i)].transpose().triangularView<Eigen::Upper>().solveInPlace(part);
  }
  return x;
}

std::vector<RedundantGroup> ConstraintRows::redundant(double rank_tolerance) const {
  const SparseQr qr(transposed_, rank_tolerance);
  const Eigen::Index rank = qr.rank;
  if (rank == layout_.row_count) return {};
  const SparseMatrix R = qr.R.leftCols(rank);
  const auto order = [&](Eigen::Index k) { return qr.order[static_cast<std::size_t>(k)]; };

  // Every remaining row is a combination of the others, R x = its column: y = [x; -1] is a null vector of B^T.
  std::vector<int> parent(static_cast<std::size_t>(model_.joint_count()));
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<Eigen::SparseVector<double>> null_vectors;
  std::vector<std::vector<int>> sources;
  std::vector<int> followers;  // the remaining row
  const auto is_rotor = [&](int row) {
    const std::size_t joint = static_cast<std::size_t>(layout_.row_joint[static_cast<std::size_t>(row)]);
    return model_.joint(static_cast<int>(joint))
               .rows[static_cast<std::size_t>(row - layout_.joint_row[joint])]
               .inertia > 0.0;
  };
  for (Eigen::Index k = rank; k < layout_.row_count; ++k) {
    if (is_rotor(order(k))) continue;
    followers.push_back(order(k));
    Eigen::VectorXd x = qr.R.col(k);
    R.triangularView<Eigen::Upper>().solveInPlace(x);
    const int joint = layout_.row_joint[static_cast<std::size_t>(order(k))];
    Eigen::SparseVector<double> y(layout_.row_count);
    std::vector<int> from;
    y.coeffRef(order(k)) = -1.0;
    for (Eigen::Index i = 0; i < rank; ++i) {
      if (std::abs(x[i]) <= kTakesPart) continue;
      y.coeffRef(order(i)) = x[i];
      const int other = layout_.row_joint[static_cast<std::size_t>(order(i))];
      parent[static_cast<std::size_t>(root(parent, other))] = root(parent, joint);
      if (std::find(from.begin(), from.end(), other) == from.end()) from.push_back(other);
    }
    std::sort(from.begin(), from.end());
    null_vectors.push_back(std::move(y));
    sources.push_back(std::move(from));
  }

  // One group per set of joints with common combinations.
  std::map<int, RedundantGroup> groups;
  for (std::size_t k = 0; k < null_vectors.size(); ++k) {
    const int row = followers[k];
    RedundantGroup& group = groups[root(parent, layout_.row_joint[static_cast<std::size_t>(row)])];
    group.dropped.push_back(row);
    group.sources.push_back(sources[k]);
  }
  for (int j = 0; j < model_.joint_count(); ++j) {
    const auto found = groups.find(root(parent, j));
    if (found == groups.end()) continue;
    found->second.joints.push_back(j);
    found->second.joint_size.push_back(static_cast<int>(model_.joint(j).rows.size()));
    for (std::size_t i = 0; i < model_.joint(j).rows.size(); ++i)
      found->second.rows.push_back(layout_.joint_row[static_cast<std::size_t>(j)] + static_cast<int>(i));
  }
  std::vector<RedundantGroup> out;
  for (auto& [key, group] : groups) {
    const Eigen::Index m = static_cast<Eigen::Index>(group.rows.size());
    group.s = joint_lengths(group);
    Eigen::MatrixXd Y = Eigen::MatrixXd::Zero(m, static_cast<Eigen::Index>(group.dropped.size()));
    Eigen::Index column = 0;
    for (std::size_t k = 0; k < null_vectors.size(); ++k) {
      const int row = followers[k];
      if (root(parent, layout_.row_joint[static_cast<std::size_t>(row)]) != key) continue;
      for (Eigen::SparseVector<double>::InnerIterator entry(null_vectors[k]); entry; ++entry) {
        const auto at = std::lower_bound(group.rows.begin(), group.rows.end(), static_cast<int>(entry.index()));
        Y(at - group.rows.begin(), column) = group.s[at - group.rows.begin()] * scale[entry.index()] * entry.value();
      }
      ++column;
    }
    group.U = Eigen::HouseholderQR<Eigen::MatrixXd>(Y).householderQ() * Eigen::MatrixXd::Identity(m, Y.cols());
    out.push_back(std::move(group));
  }
  return out;
}

Eigen::VectorXd ConstraintRows::joint_lengths(const RedundantGroup& group) const {
  Eigen::VectorXd s(static_cast<Eigen::Index>(group.rows.size()));
  const auto row_of = [&](int row) -> const ConstraintRow& {
    const int joint = layout_.row_joint[static_cast<std::size_t>(row)];
    return model_.joint(joint).rows[static_cast<std::size_t>(row - layout_.joint_row[static_cast<std::size_t>(joint)])];
  };
  for (std::size_t i = 0; i < group.rows.size(); ++i) {
    double sum = 0.0;
    int count = 0;
    for (const int row : group.rows) {
      if (layout_.row_joint[static_cast<std::size_t>(row)] !=
              layout_.row_joint[static_cast<std::size_t>(group.rows[i])] ||
          row_of(row).unit != row_of(group.rows[i]).unit)
        continue;
      sum += 1.0 / (scale[row] * scale[row]);
      ++count;
    }
    s[static_cast<Eigen::Index>(i)] = std::sqrt(sum / count);
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
