// The step that every flexible body goes through, whoever made its shapes: no rigid motion, mass-orthonormal,
// diagonal stiffness.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/fe/equal_frequencies.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/model/principal_axes.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kRigidShape = 1e-6;  // a shape that loses all but this fraction of its norm was a rigid motion
constexpr double kDependent = 1e-12;  // least eigenvalue of the Gram matrix of unit shapes
constexpr double kLowest = 0.1, kHighest = 1e6;  // plausible first elastic frequency [Hz]

// M-weighted inner products of two sets of shapes, [Phi; Psi] each.
MatrixXd inner(const ModalBody& body, const MatrixXd& Phi1, const MatrixXd& Psi1, const MatrixXd& Phi2,
               const MatrixXd& Psi2) {
  MatrixXd MPhi = Phi2, JPsi = Psi2;
  for (Index j = 0; j < body.node_count(); ++j) {
    MPhi.middleRows(3 * j, 3) *= body.node_mass(j);
    JPsi.middleRows(3 * j, 3) = (body.node_inertia[static_cast<std::size_t>(j)] * Psi2.middleRows(3 * j, 3)).eval();
  }
  return Phi1.transpose() * MPhi + Psi1.transpose() * JPsi;
}

MatrixXd gram(const ModalBody& body) { return inner(body, body.Phi, body.Psi, body.Phi, body.Psi); }

// Takes the rigid-body content out of the shapes: x - R (R^T M R)^-1 R^T M x, R = translations and rotations
// about Bo (the mass centre). Nodes keep their rotation only if they have one, i.e. if the model gave it.
void remove_rigid_motion(ModalBody& body, bool rotations) {
  const Index n = body.node_count();
  MatrixXd R_Phi = MatrixXd::Zero(3 * n, 6), R_Psi = MatrixXd::Zero(3 * n, 6);
  for (Index j = 0; j < n; ++j) {
    R_Phi.block<3, 3>(3 * j, 0).setIdentity();
    for (int i = 0; i < 3; ++i) R_Phi.block<3, 1>(3 * j, 3 + i) = Vector3d::Unit(i).cross(Vector3d(body.rho0.col(j)));
    if (rotations) R_Psi.block<3, 3>(3 * j, 3).setIdentity();
  }
  const MatrixXd rigid_mass = inner(body, R_Phi, R_Psi, R_Phi, R_Psi);
  const MatrixXd content = rigid_mass.ldlt().solve(inner(body, R_Phi, R_Psi, body.Phi, body.Psi));
  body.Phi -= R_Phi * content;
  body.Psi -= R_Psi * content;
}

void transform(ModalBody& body, const MatrixXd& Y) {
  body.Phi = (body.Phi * Y).eval();
  body.Psi = (body.Psi * Y).eval();
  if (body.stress_modes.rows() > 0) body.stress_modes = (body.stress_modes * Y).eval();
}

void part_equal_frequencies(ModalBody& body) {
  const Matrix3d weight = axis_weight(principal_axes(body));
  MatrixXd WPhi = body.Phi;
  for (Index j = 0; j < body.node_count(); ++j)
    WPhi.middleRows(3 * j, 3) = (body.node_mass(j) * weight * body.Phi.middleRows(3 * j, 3)).eval();
  transform(body, along_axes(body.stiffness, body.Phi.transpose() * WPhi));
}

// Signs do not matter to physics; fixed so that files and pictures can be compared: the largest displacement
// is positive.
void fix_signs(ModalBody& body) {
  VectorXd sign = VectorXd::Ones(body.mode_count());
  for (Index k = 0; k < body.mode_count(); ++k) {
    Index at = 0;
    body.Phi.col(k).cwiseAbs().maxCoeff(&at);
    if (body.Phi(at, k) < 0.0) sign(k) = -1.0;
  }
  transform(body, sign.asDiagonal());
}

std::string plausibility(const ModalBody& body) {
  if (body.mode_count() == 0) return "";
  const double first = frequencies(body)(0);
  if (first >= kLowest && first <= kHighest) return "";
  std::ostringstream text;
  text << "body \"" << body.name << "\": first elastic frequency is " << first << " Hz, expected between " << kLowest
       << " and " << kHighest
       << " Hz. Are lengths in metres, masses in kg and Young's modulus in Pa (units off by 1000)?";
  return text.str();
}

}  // namespace

ReducedBody orthonormalised(ModalBody body, const MatrixXd& stiffness, const BasisOptions& options) {
  const std::string who = "body \"" + body.name + "\"";
  const Index s = stiffness.cols();
  FOOTFALL_DEMAND(body.Phi.cols() == s && body.Psi.cols() == s && stiffness.rows() == s);
  if (options.mode_count && *options.mode_count > s)
    throw InputError(who + ": " + std::to_string(*options.mode_count) + " modes asked for, but there are only " +
                     std::to_string(s) + ".");
  ReducedBody result;
  result.p_DBo = body.rho0 * body.node_mass / body.node_mass.sum();
  body.rho0.colwise() -= result.p_DBo;
  const bool rotations = s > 0 && !body.Psi.isZero(0.0);

  MatrixXd K = stiffness;
  if (s > 0) {
    const VectorXd before = gram(body).diagonal().cwiseSqrt();
    remove_rigid_motion(body, rotations);
    const VectorXd norm = gram(body).diagonal().cwiseSqrt();
    for (Index k = 0; k < s; ++k)
      if (!(norm(k) > kRigidShape * before(k)))
        throw InputError(who + ": mode " + std::to_string(k) +
                         " moves no mass beyond a rigid-body motion, expected elastic modes only. The mass "
                         "matrix of this basis is "
                         "not positive; remove the mode.");
    const MatrixXd unit = norm.cwiseInverse().asDiagonal();
    transform(body, unit);
    K = unit * K * unit;
    const MatrixXd G = gram(body);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> independent(G);
    if (!(independent.eigenvalues()(0) > kDependent))
      throw InputError(who + ": the mass matrix of the basis is not positive: its " + std::to_string(s) +
                       " modes are not independent once rigid motion is removed. Remove modes that repeat others.");
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(0.5 * (K + K.transpose()),
                                                                   0.5 * (G + G.transpose()));
    if (!(eigen.eigenvalues()(0) > 0.0))
      throw InputError(who + ": the modal stiffness is not positive: least omega^2 is " +
                       std::to_string(eigen.eigenvalues()(0)) + " 1/s2. Every mode must store strain energy.");
    Index kept = options.mode_count ? *options.mode_count : s;
    if (options.max_frequency) {
      const double limit = std::pow(2.0 * kPi * *options.max_frequency, 2);
      kept = std::min<Index>(kept, (eigen.eigenvalues().array() <= limit).count());
    }
    transform(body, eigen.eigenvectors().leftCols(kept));
    body.stiffness = eigen.eigenvalues().head(kept);
    // Once more, for round-off: the first pass may have cancelled large rigid motions.
    remove_rigid_motion(body, rotations);
    if (kept > 0) {
      const Eigen::LLT<MatrixXd> cholesky(gram(body));
      transform(body, cholesky.matrixU().solve(MatrixXd::Identity(kept, kept)));
      part_equal_frequencies(body);
      fix_signs(body);
    }
  } else {
    body.stiffness.resize(0);
  }
  body.damping.resize(body.stiffness.size());
  for (Index k = 0; k < body.damping.size(); ++k) {
    const auto given = static_cast<Index>(options.damping_ratio.size());
    body.damping(k) =
        2.0 * options.damping_ratio[static_cast<std::size_t>(std::min(k, given - 1))] * std::sqrt(body.stiffness(k));
  }
  const std::string warning = plausibility(body);
  if (!warning.empty()) result.warnings.push_back(warning);
  if (body.mode_count() == 0 && !(options.mode_count && *options.mode_count == 0))
    result.warnings.push_back(who +
                              ": no elastic mode below the frequency limit, so the body is rigid. Raise the limit.");
  result.body = std::move(body);
  return result;
}

}  // namespace footfall
