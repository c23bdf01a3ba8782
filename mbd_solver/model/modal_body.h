#pragma once
// A flexible body reduced to modal coordinates, from beam elements, plate elements or a file of a finite-element code; its
// stresses and the range of its linear modes. [Lin25 5-12], theory 1.2.

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <optional>
#include <string>
#include <vector>

namespace footfall {

// Position of node j, in the body frame B:   rho_j = rho0_j + Phi_j a            [m]
// Small rotation of node j, in B:            theta_j = Psi_j a                   [rad]
// Kinetic energy: 1/2 sum_j m_j |dr_j|^2 + 1/2 sum_j (w_B + Psi_j da)^T J_j (w_B + Psi_j da), or the energy of a mass matrix.
// Strain energy: 1/2 a^T K a;  modal damping force: -C da.
// Floating frame: MEAN AXES always. Origin Bo = centre of mass, undeformed; the modes have no rigid-body content:
//   sum_j m_j Phi_j = 0 and sum_j (m_j rho0_j x Phi_j + J_j Psi_j) = 0 (to round-off), for every kind of basis.
// Modes are mass-orthonormal: sum_j (m_j Phi_j^T Phi_j + Psi_j^T J_j Psi_j) = I, K = diag(omega_k^2).
struct ModalBody {
  std::string name;
  Eigen::Matrix3Xd rho0;                      // 3 x N node positions in B [m]
  Eigen::VectorXd node_mass;                  // N lumped masses [kg]
  std::vector<Eigen::Matrix3d> node_inertia;  // N lumped rotary inertias in B [kg m2] (zero for shells)
  // 6N x 6N, in B, order 6 j + i (displacements, then rotations of node j): a mass matrix that couples nodes or motions. Then
  // all masses of this page follow from it, and node_mass only weighs nodes. Empty: the lumped masses and inertias.
  Eigen::SparseMatrix<double> mass;
  Eigen::MatrixXd Phi;        // 3N x s translational mode shapes [m per unit of a]
  Eigen::MatrixXd Psi;        // 3N x s rotational mode shapes [rad per unit of a]
  Eigen::VectorXd stiffness;  // s: omega_k^2 [1/s2] (mass-orthonormal modes)
  Eigen::VectorXd damping;    // s: 2 zeta_k omega_k [1/s]
  // Largest relative error of static deflection against the full model (fe/modal_basis.cpp); empty if nothing is attached
  // or the model is not known.
  std::optional<double> static_error;
  // Stress recovery: sigma = stress_modes * a, six components (xx yy zz xy yz zx, element axes) per stress point.
  Eigen::MatrixXd stress_modes;  // 6 P x s [Pa per unit of a]; may be empty
  // Surface and beam connectivity of the same nodes, for boundaries and for pictures.
  std::vector<Eigen::Vector3i> triangles;  // node indices; may be empty
  std::vector<Eigen::Vector2i> segments;   // node indices; may be empty

  int node_count() const { return static_cast<int>(rho0.cols()); }
  int mode_count() const { return static_cast<int>(stiffness.size()); }
};

// --- Range of validity. The floating frame with linear modes has no geometric stiffening (centrifugal tension does not
// stiffen bending) and assumes small deflections. theory 1.4.

// |w| over the lowest elastic angular frequency of the free body: below this limit the error of bending frequencies is less
// than one percent, clamped or free; it grows with the square.
constexpr double kSpinRange = 0.04;
// Largest deflection from mean axes over the extent of the body: below this limit the error of deflection is less than one
// percent; it grows with the square.
constexpr double kDeflectionRange = 0.01;

// Lowest elastic angular frequency of the free body [rad/s]; the body must have modes.
double lowest_frequency(const ModalBody& body);
// Diagonal of the box around the nodes, undeformed [m].
double extent(const ModalBody& body);

// --- Stress and deflection in a given state: for output.

// Von Mises stress [Pa] of each stress point; empty if the body has none.
Eigen::VectorXd von_mises_of_points(const ModalBody& body, const Eigen::VectorXd& a);
// Largest von Mises stress [Pa] of each triangle, then of each segment; empty if stress points do not belong to them.
Eigen::VectorXd von_mises_of_cells(const ModalBody& body, const Eigen::VectorXd& a);
// Largest von Mises stress of a body, asked for many states. A norm of sums is at most the sum of norms, so that most points need not be
// evaluated:  sigma_v(sum_k a_k sigma_k) <= sum_k |a_k| sigma_v(sigma_k).
class LargestStress {
 public:
  explicit LargestStress(const ModalBody& body);  // which must outlive this
  double at(const Eigen::VectorXd& a);            // [Pa]; 0 without stress points or modes

 private:
  double of_point(Eigen::Index point, const Eigen::VectorXd& a) const;

  const ModalBody& body_;
  Eigen::MatrixXd of_modes_;  // P x s: of each mode alone [Pa per unit of a]
  Eigen::VectorXd most_;      // bounds of the last state [Pa]
  Eigen::Index last_ = 0;     // the point of the last state's largest
};
// Largest |Phi_j a| over the nodes [m].
double largest_deflection(const ModalBody& body, const Eigen::VectorXd& a);

}  // namespace footfall
