// A free finite-element model from MatrixMarket files; declared in modal_body_file.h.

#include <algorithm>
#include <cctype>

#include "coupler/base/errors.h"
#include "mbd_solver/fe/modal_body_file.h"
#include "mbd_solver/fe/text_records.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Sparse = Eigen::SparseMatrix<double>;

constexpr int kMaxSize = 100000000;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// `%%MatrixMarket matrix coordinate real symmetric`, comments with %, `rows columns entries`, then `i j
// value` from 1.
Sparse read_matrix(const std::string& path) {
  const std::string expected = "\"%%MatrixMarket matrix coordinate real symmetric\" (or general, or integer)";
  TextRecords header(path, '\0');
  header.require_next(expected);
  const std::vector<std::string>& w = header.words();
  if (w.size() != 5 || lower(w[0]) != "%%matrixmarket" || lower(w[1]) != "matrix" || lower(w[2]) != "coordinate" ||
      (lower(w[3]) != "real" && lower(w[3]) != "integer") || (lower(w[4]) != "symmetric" && lower(w[4]) != "general"))
    header.fail("not a matrix that can be read, expected " + expected + ".");
  const bool symmetric = lower(w[4]) == "symmetric";

  TextRecords file(path, '%');
  file.require_next("rows, columns and entries");
  if (file.size() != 3) file.fail("expected three numbers: rows, columns and entries.");
  const int rows = file.integer(0, 1, kMaxSize);
  const int columns = file.integer(1, 1, kMaxSize);
  const int entries = file.integer(2, 1, kMaxSize);
  if (rows != columns) file.fail("expected a square matrix.");
  std::vector<Eigen::Triplet<double>> triplets;
  for (int e = 0; e < entries; ++e) {
    file.require_next("entry " + std::to_string(e + 1) + " of " + std::to_string(entries));
    if (file.size() != 3) file.fail("expected three numbers: row, column and value.");
    const int i = file.integer(0, 1, rows) - 1;
    const int j = file.integer(1, 1, columns) - 1;
    const double value = file.number(2);
    triplets.emplace_back(i, j, value);
    if (symmetric && i != j) triplets.emplace_back(j, i, value);
  }
  if (file.next()) file.fail("more entries than the " + std::to_string(entries) + " announced.");
  Sparse matrix(rows, columns);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

// From per_node rows per node to six.
Sparse six_per_node(const Sparse& matrix, int per_node) {
  std::vector<Eigen::Triplet<double>> triplets;
  const auto dof = [per_node](Index i) { return static_cast<int>(6 * (i / per_node) + i % per_node); };
  for (Index j = 0; j < matrix.cols(); ++j)
    for (Sparse::InnerIterator it(matrix, j); it; ++it) triplets.emplace_back(dof(it.row()), dof(j), it.value());
  const Index size = 6 * matrix.rows() / per_node;
  Sparse result(size, size);
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

// Diagonal terms scaled so that the total mass is kept (it is the same along x, y and z); an already lumped
// matrix stays as it is.
void lump(const Sparse& M, const std::string& path, FeModel& model) {
  const int n = model.node_count();
  Vector3d total, diagonal;
  for (int i = 0; i < 3; ++i) {
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(6 * n);
    for (int j = 0; j < n; ++j) unit(6 * j + i) = 1.0;
    total(i) = unit.dot(M * unit);
    diagonal(i) = unit.dot(M.diagonal());
  }
  const double mass = total.mean();
  if (!(diagonal.minCoeff() > 0.0 && total.minCoeff() > 0.0))
    throw InputError(path + ": mass matrix is not positive: the total mass is " + std::to_string(mass) + " kg.");
  if (!((total.array() - mass).abs().maxCoeff() <= 1e-6 * mass))
    throw InputError(path + ": the total mass differs along x, y and z (" + std::to_string(total.x()) + ", " +
                     std::to_string(total.y()) + ", " + std::to_string(total.z()) +
                     " kg), expected the same. Is the order of the rows node by node, x y z first?");
  const double factor = mass / diagonal.mean();
  model.node_mass.resize(n);
  for (int j = 0; j < n; ++j) {
    Matrix3d J;
    double m = 0.0;
    for (int i = 0; i < 3; ++i) {
      m += M.coeff(6 * j + i, 6 * j + i) / 3.0;
      for (int k = 0; k < 3; ++k) J(i, k) = factor * M.coeff(6 * j + 3 + i, 6 * j + 3 + k);
    }
    model.node_mass(j) = factor * m;
    model.node_inertia.push_back(0.5 * (J + J.transpose()));
  }
}

}  // namespace

FeModel read_matrix_market(const std::string& stiffness_path, const std::string& mass_path,
                           const std::string& nodes_path) {
  TextRecords file(nodes_path, '#');
  std::vector<Vector3d> nodes;
  while (file.next()) {
    if (file.size() != 3) file.fail(std::to_string(file.size()) + " numbers, expected three: x y z.");
    nodes.emplace_back(file.number(0), file.number(1), file.number(2));
  }
  if (nodes.empty()) throw InputError(nodes_path + ": no nodes, expected one \"x y z\" per line.");
  const Sparse K = read_matrix(stiffness_path);
  const Sparse M = read_matrix(mass_path);
  const auto n = static_cast<Index>(nodes.size());
  if (K.rows() != 3 * n && K.rows() != 6 * n)
    throw InputError(stiffness_path + ": " + std::to_string(K.rows()) + " rows for the " + std::to_string(n) +
                     " nodes of " + nodes_path + ", expected 3 or 6 per node: " + std::to_string(3 * n) + " or " +
                     std::to_string(6 * n) + ".");
  if (M.rows() != K.rows())
    throw InputError(mass_path + ": " + std::to_string(M.rows()) + " rows, expected " + std::to_string(K.rows()) +
                     " as in " + stiffness_path + ".");
  const int per_node = static_cast<int>(K.rows() / n);
  FeModel model;
  model.rotations = per_node == 6;
  model.nodes.resize(3, n);
  for (Index j = 0; j < n; ++j) model.nodes.col(j) = nodes[static_cast<std::size_t>(j)];
  model.stiffness = six_per_node(K, per_node);
  lump(six_per_node(M, per_node), mass_path, model);
  model.stress.resize(0, 6 * n);
  return model;
}

}  // namespace footfall
