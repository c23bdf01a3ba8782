// Matrices are compared by their products with two deflections without symmetry.

#include "mbd_solver/fe/turned_model.h"

#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Every vector of three in x, rotated.
Eigen::MatrixXd turned_vectors(const Eigen::MatrixXd& x, const Eigen::Matrix3d& R) {
  Eigen::MatrixXd out(x.rows(), x.cols());
  for (Index i = 0; i + 2 < x.rows(); i += 3) out.middleRows(i, 3) = R * x.middleRows(i, 3);
  return out;
}

bool same(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double size) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         (a.size() == 0 || (a - b).cwiseAbs().maxCoeff() <= kSameModel * size);
}

// `answer` equals B y: each block of `rows` entries to kSameModel of the size of its terms.
using Sparse = Eigen::SparseMatrix<double>;
bool same_answer(const VectorXd& answer, const Sparse& B, const VectorXd& y, Index rows) {
  const VectorXd off = answer - B * y, terms = B.cwiseAbs() * y.cwiseAbs();
  for (Index i = 0; i + rows <= off.size(); i += rows)
    if (off.segment(i, rows).cwiseAbs().maxCoeff() > kSameModel * terms.segment(i, rows).maxCoeff()) return false;
  return true;
}

// A deflection without symmetry and zeros.
VectorXd some_deflection(Index size, double start) {
  VectorXd x(size);
  double phase = start;
  for (Index i = 0; i < size; ++i) {
    phase += 0.6180339887498949;
    phase -= std::floor(phase);
    x[i] = phase < 0.5 ? -0.5 - phase : phase;
  }
  return x;
}

}  // namespace

std::optional<Eigen::Vector3d> place_of_copy(const FeModel& model, const FeModel& copy, const Eigen::Matrix3d& R) {
  const auto special = [](const FeModel& m) { return m.extra > 0 || !m.spiders.empty() || m.known_shapes.size() > 0; };
  if (special(model) || special(copy)) return std::nullopt;
  if (model.node_count() != copy.node_count() || model.rotations != copy.rotations ||
      model.stress.rows() != copy.stress.rows() || model.node_inertia.size() != copy.node_inertia.size() ||
      model.triangles != copy.triangles || model.segments != copy.segments)
    return std::nullopt;
  const Eigen::Vector3d centre = model.nodes.rowwise().mean(), centre_of_copy = copy.nodes.rowwise().mean();
  const Eigen::Vector3d p = centre_of_copy - R * centre;
  const double size = std::max(model.nodes.cwiseAbs().maxCoeff(), copy.nodes.cwiseAbs().maxCoeff());
  if (!same((R * model.nodes).colwise() + p, copy.nodes, size)) return std::nullopt;
  if (!same(model.node_mass, copy.node_mass, model.node_mass.maxCoeff())) return std::nullopt;
  if (model.mass.rows() != copy.mass.rows()) return std::nullopt;
  for (std::size_t j = 0; j < model.node_inertia.size(); ++j) {
    const Eigen::Matrix3d& inertia = model.node_inertia[j];
    if (!same(R * inertia * R.transpose(), copy.node_inertia[j], inertia.cwiseAbs().maxCoeff())) return std::nullopt;
  }
  for (const double start : {0.1, 0.7}) {
    const VectorXd x = some_deflection(model.stiffness.cols(), start), x_of_copy = turned_vectors(x, R);
    if (!same_answer(turned_vectors(model.stiffness * x, R), copy.stiffness, x_of_copy, 3) ||
        (model.mass.size() > 0 && !same_answer(turned_vectors(model.mass * x, R), copy.mass, x_of_copy, 3)) ||
        !same_answer(model.stress * x, copy.stress, x_of_copy, 6))
      return std::nullopt;
  }
  return p;
}

ReducedBody turned(const ReducedBody& reduced, const Eigen::Matrix3d& R, const Eigen::Vector3d& p,
                   const std::string& name) {
  FOOTFALL_DEMAND(reduced.warnings.empty());  // they name the body
  ReducedBody out = reduced;
  out.p_DBo = R * reduced.p_DBo + p;
  out.body.name = name;
  out.body.rho0 = R * reduced.body.rho0;
  for (Eigen::Matrix3d& inertia : out.body.node_inertia) inertia = R * inertia * R.transpose();
  if (reduced.body.mass.size() > 0) {
    std::vector<Eigen::Triplet<double>> entries;
    for (Index b = 0; b < reduced.body.mass.rows(); b += 3)
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          if (R(i, k) != 0.0) entries.emplace_back(static_cast<int>(b) + i, static_cast<int>(b) + k, R(i, k));
    Sparse T(reduced.body.mass.rows(), reduced.body.mass.cols());
    T.setFromTriplets(entries.begin(), entries.end());
    out.body.mass = T * reduced.body.mass * Sparse(T.transpose());
  }
  out.body.Phi = turned_vectors(reduced.body.Phi, R);
  out.body.Psi = turned_vectors(reduced.body.Psi, R);
  return out;
}

}  // namespace footfall
