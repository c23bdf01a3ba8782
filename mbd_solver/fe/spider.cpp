// Rigid sets follow their node; of an averaged set six displacements follow from its node and all others.

#include "mbd_solver/fe/spider.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Sparse = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

constexpr std::size_t kMostAveraged = 1000;  // nodes; each couples with each
constexpr double kOnALine = 1e-8;            // smallest moment of the set's points over the largest

Vector3d mean_of(const FeModel& model, const std::vector<int>& nodes) {
  Vector3d sum = Vector3d::Zero();
  for (const int j : nodes) sum += model.nodes.col(j);
  return sum / static_cast<double>(nodes.size());
}

// sum (|r|^2 1 - r r^T) of the points about c [m2]
Matrix3d moment_of(const FeModel& model, const std::vector<int>& nodes, const Vector3d& c) {
  Matrix3d J = Matrix3d::Zero();
  for (const int j : nodes) {
    const Matrix3d r = skew(Vector3d(model.nodes.col(j) - c));
    J -= r * r;
  }
  return J;
}

double smallest_over_largest(const Matrix3d& J) {
  // det / trace^3 <= smallest / largest for a symmetric positive matrix.
  const double trace = J.trace();
  return trace > 0.0 ? J.determinant() / (trace * trace * trace) : 0.0;
}

// Motion of the node [u; theta] by the displacements of the set (6 x 3m): the mean displacement, and the rotation with the
// same mean moment, theta = J^-1 sum r x u (as RBE3 of Nastran with equal weights).
MatrixXd average(const FeModel& model, const Spider& spider) {
  const Vector3d c = mean_of(model, spider.nodes), arm = model.nodes.col(spider.node) - c;
  const Matrix3d inverse = moment_of(model, spider.nodes, c).inverse();
  const auto m = static_cast<Index>(spider.nodes.size());
  MatrixXd A(6, 3 * m);
  for (Index k = 0; k < m; ++k) {
    const Matrix3d r = skew(Vector3d(model.nodes.col(spider.nodes[k]) - c));
    const Matrix3d theta = inverse * r;
    A.block<3, 3>(0, 3 * k) = Matrix3d::Identity() / static_cast<double>(m) - skew(arm) * theta;
    A.block<3, 3>(3, 3 * k) = theta;
  }
  return A;
}

// Six columns of A, by elimination with the largest pivot each; rows are scaled to one size.
std::array<Index, 6> independent_columns(MatrixXd A) {
  for (Index i = 0; i < 6; ++i) A.row(i) /= A.row(i).norm();
  std::array<Index, 6> columns{};
  std::array<bool, 6> used{};
  for (std::size_t k = 0; k < 6; ++k) {
    double best = 0.0;
    Index row = 0;
    for (Index j = 0; j < A.cols(); ++j)
      for (Index i = 0; i < 6; ++i)
        if (!used[i] && std::abs(A(i, j)) > best) {
          best = std::abs(A(i, j));
          row = i;
          columns[k] = j;
        }
    FOOTFALL_DEMAND(best > 0.0);
    used[row] = true;
    const Eigen::VectorXd pivot = A.col(columns[k]);
    for (Index i = 0; i < 6; ++i)
      if (i != row) A.row(i) -= (pivot(i) / pivot(row) * A.row(row)).eval();
  }
  return columns;
}

// Rows and columns of a node in front.
Sparse shifted(const Sparse& matrix, int rows, int columns) {
  std::vector<Triplet> entries;
  entries.reserve(static_cast<std::size_t>(matrix.nonZeros()));
  for (Index j = 0; j < matrix.outerSize(); ++j)
    for (Sparse::InnerIterator it(matrix, j); it; ++it)
      entries.emplace_back(static_cast<int>(it.row()) + rows, static_cast<int>(j) + columns, it.value());
  Sparse result(matrix.rows() + rows, matrix.cols() + columns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

MatrixXd with_rows_in_front(const MatrixXd& x) {
  MatrixXd result = MatrixXd::Zero(x.rows() + 6, x.cols());
  result.bottomRows(x.rows()) = x;
  return result;
}

}  // namespace

void add_spider(FeModel& model, std::vector<int> nodes, SpiderKind kind, const Vector3d* point,
                const std::string& who) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  FOOTFALL_DEMAND(!nodes.empty() && nodes.front() >= 0 && nodes.back() < model.node_count());
  const Vector3d x = point != nullptr ? *point : mean_of(model, nodes);
  if (kind == SpiderKind::kAveraged) {
    if (nodes.size() > kMostAveraged)
      throw InputError(code::kFeModel, who + ": an averaged set of " + std::to_string(nodes.size()) +
                                           " nodes, expected at most " + std::to_string(kMostAveraged) +
                                           ". Name a smaller set, or kind = \"rigid\".");
    if (!(smallest_over_largest(moment_of(model, nodes, mean_of(model, nodes))) > kOnALine))
      throw InputError(code::kFeModel, who + ": an averaged set of " + std::to_string(nodes.size()) +
                                           " nodes on one line, which have no mean rotation. Name more nodes.");
  }
  for (const Spider& other : model.spiders)
    for (const int j : nodes)
      if (std::binary_search(other.nodes.begin(), other.nodes.end(), j) || other.node == j)
        throw InputError(code::kFeModel, who + ": a node at (" + plain_text(model.nodes(0, j)) + ", " +
                                             plain_text(model.nodes(1, j)) + ", " + plain_text(model.nodes(2, j)) +
                                             ") m belongs to another set as well. Sets must not overlap.");
  const bool lumped = model.mass.size() == 0;
  Eigen::Matrix3Xd places(3, model.node_count() + 1);
  places << x, model.nodes;
  model.nodes = places;
  model.stiffness = shifted(model.stiffness, 6, 6);
  if (!lumped) model.mass = shifted(model.mass, 6, 6);
  Eigen::VectorXd mass(model.node_mass.size() + 1);
  mass << 0.0, model.node_mass;
  model.node_mass = mass;
  model.node_inertia.insert(model.node_inertia.begin(), Matrix3d::Zero());
  model.stress = shifted(model.stress, 0, 6);
  for (Eigen::Vector3i& t : model.triangles) t.array() += 1;
  for (Eigen::Vector2i& e : model.segments) e.array() += 1;
  if (model.known_shapes.size() > 0) {
    model.known_shapes = with_rows_in_front(model.known_shapes);
    model.known_stresses = with_rows_in_front(model.known_stresses);
  }
  for (int& j : nodes) ++j;
  for (Spider& other : model.spiders) {
    ++other.node;
    for (int& j : other.nodes) ++j;
  }
  model.spiders.push_back({0, std::move(nodes), kind});
  model.rotations = true;
}

Constrained constrained(const FeModel& model) {
  const Index size = model.stiffness.rows();
  std::vector<bool> follows(static_cast<std::size_t>(size), false);
  std::vector<Triplet> entries;
  for (const Spider& spider : model.spiders) {
    const int ref = 6 * spider.node;
    if (spider.kind == SpiderKind::kRigid) {
      for (const int j : spider.nodes) {
        const Vector3d arm = model.nodes.col(j) - model.nodes.col(spider.node);
        const Matrix3d turn = -skew(arm);
        for (int i = 0; i < 3; ++i) {
          entries.emplace_back(6 * j + i, ref + i, 1.0);
          entries.emplace_back(6 * j + 3 + i, ref + 3 + i, 1.0);
          for (int k = 0; k < 3; ++k)
            if (turn(i, k) != 0.0) entries.emplace_back(6 * j + i, ref + 3 + k, turn(i, k));
        }
        for (int i = 0; i < 6; ++i) follows[6 * j + i] = true;
      }
      continue;
    }
    const MatrixXd A = average(model, spider);
    const std::array<Index, 6> six = independent_columns(A);
    Eigen::Matrix<double, 6, 6> of_six;
    for (std::size_t k = 0; k < 6; ++k) of_six.col(static_cast<Index>(k)) = A.col(six[k]);
    const Eigen::Matrix<double, 6, 6> inverse = of_six.partialPivLu().inverse();
    const MatrixXd others = -inverse * A;
    const auto row_of = [&](Index column) { return 6 * spider.nodes[column / 3] + static_cast<int>(column % 3); };
    for (std::size_t k = 0; k < 6; ++k) {
      const int row = row_of(six[k]);
      follows[row] = true;
      for (int i = 0; i < 6; ++i) entries.emplace_back(row, ref + i, inverse(static_cast<Index>(k), i));
      for (Index j = 0; j < A.cols(); ++j)
        if (std::find(six.begin(), six.end(), j) == six.end())
          entries.emplace_back(row, row_of(j), others(static_cast<Index>(k), j));
    }
  }
  for (int i = 0; i < size; ++i)
    if (!follows[i]) entries.emplace_back(i, i, 1.0);
  Constrained result;
  result.T.resize(size, size);
  result.T.setFromTriplets(entries.begin(), entries.end());
  result.model = model;
  const Sparse transposed = result.T.transpose();
  result.model.stiffness = transposed * model.stiffness * result.T;
  result.model.mass = transposed * mass_matrix(model) * result.T;
  result.model.spiders.clear();
  result.model.follows = std::move(follows);
  return result;
}

}  // namespace footfall
