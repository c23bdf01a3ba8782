// Bodies are checked here: mass and inertia must belong to a solid, and modes must not move the mass centre.

#include "mbd_solver/model/body.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/mass_properties.h"

namespace footfall {
namespace {

// Mass and inertia of a solid: positive, symmetric, positive definite, triangle inequality.
const Eigen::Matrix3d& checked(const std::string& name, double mass, const Eigen::Matrix3d& inertia) {
  const std::string where = "body \"" + name + "\": ";
  if (!(std::isfinite(mass) && mass > 0.0))
    throw InputError(code::kMassProperties, where + "mass is " + number_text(mass) + " kg; it must be positive.");
  if (!inertia.allFinite() || (inertia - inertia.transpose()).norm() > 1e-9 * inertia.norm())
    throw InputError(code::kMassProperties, where + "the inertia matrix must be finite and symmetric.");
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(principal[0] > 0.0))
    throw InputError(code::kMassProperties, where + "smallest principal inertia is " + number_text(principal[0]) +
                                                " kg m2; it must be positive.");
  if (principal[0] + principal[1] < principal[2] * (1.0 - 1e-9))
    throw InputError(code::kMassProperties, where + "no solid has principal inertias " + number_text(principal[0]) +
                                                ", " + number_text(principal[1]) + ", " + number_text(principal[2]) +
                                                " kg m2: the two smaller ones must add up to at least the largest.");
  return inertia;
}

const ModalBody& present(const std::string& name, const std::shared_ptr<const ModalBody>& modal) {
  if (!modal) throw InputError(code::kMassProperties, "body \"" + name + "\": no modal body given.");
  return *modal;
}

// sum_j J_j - m_j rho0_j~ rho0_j~, or from the mass matrix
Eigen::Matrix3d nodal_inertia(const ModalBody& body) {
  if (body.mass.size() > 0) return mass_properties(body.rho0, body.mass).inertia;
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  for (int j = 0; j < body.node_count(); ++j) {
    const Eigen::Vector3d rho = body.rho0.col(j);
    J += body.node_mass[j] * (rho.squaredNorm() * Eigen::Matrix3d::Identity() - rho * rho.transpose());
    if (!body.node_inertia.empty()) J += body.node_inertia[j];
  }
  return J;
}

}  // namespace

Body::Body(std::string name, double mass, const Eigen::Matrix3d& inertia)
    : name_(std::move(name)), inertia_(mass, checked(name_, mass, inertia)), rigid_inertia_(inertia) {}

Body::Body(std::string name, std::shared_ptr<const ModalBody> modal)
    : name_(std::move(name)),
      modal_(std::move(modal)),
      inertia_(present(name_, modal_)),
      rigid_inertia_(nodal_inertia(*modal_)) {
  checked(name_, inertia_.mass(), rigid_inertia_);
  // Mean axes: no mode may move the mass centre, because gravity acts at Bo. The tolerance covers round-off.
  const double size = modal_->rho0.cwiseAbs().maxCoeff();
  for (int k = -1; k < mode_count(); ++k) {
    Eigen::VectorXd a = Eigen::VectorXd::Zero(mode_count());
    if (k >= 0) a[k] = size * std::sqrt(inertia_.mass());
    if (inertia_.centre_of_mass(a).norm() > 1e-6 * size)
      throw InputError(code::kModesMoveCentre,
                       "body \"" + name_ +
                           "\": " + (k < 0 ? "the nodes" : "mode " + std::to_string(k + 1) + " of the basis") +
                           " must keep the mass centre at the origin of the body frame (mean axes).");
  }
}

}  // namespace footfall
