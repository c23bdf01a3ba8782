#pragma once
// Inertia of one body in its own frame B, rigid (s = 0) or flexible, at a cost of O(s^2) per evaluation:
// the sums over nodes are done once, at construction (inertia shape integrals).

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/model/flexible/modal_body.h"

namespace footfall {

// All components in B:  v = [dr; w; da] (6+s), dv = its components' rates as used in theory:
//   ddr_j = ddr + dw x rho_j + Phi_j dda + w_j,   w_j = 2 w x (Phi_j da) + w x (w x rho_j).
//   M(a) dv + h(a, v) = applied generalized force,  h = sum_j m_j B_j^T w_j + rotary terms of J_j + [0; 0; C da + K a].
// Elastic and damping forces are part of h. For s = 0: M = diag(m I, J), h = [m w x (w x c); w x J w] with c = 0.
class ModalInertia {
 public:
  // Rigid body: mass [kg], inertia about the centre of mass in B [kg m2].
  ModalInertia(double mass, const Eigen::Matrix3d& inertia);
  explicit ModalInertia(const ModalBody& body);

  int mode_count() const { return modes_; }
  double mass() const { return mass_; }

  // M(a): (6+s) x (6+s), symmetric positive definite.
  void mass_matrix(const Eigen::Ref<const Eigen::VectorXd>& a, Eigen::Ref<Eigen::MatrixXd> M) const;
  // h(a, v): 6+s.
  void velocity_and_elastic_force(const Eigen::Ref<const Eigen::VectorXd>& a, const Eigen::Ref<const Eigen::VectorXd>& v,
                                  Eigen::Ref<Eigen::VectorXd> h) const;
  // Derivatives of g = M(a) dv + h(a, v) at fixed dv: dg_da (6+s) x s, dg_dv (6+s) x (6+s). (dg_ddv is M.)
  void derivatives(const Eigen::Ref<const Eigen::VectorXd>& a, const Eigen::Ref<const Eigen::VectorXd>& v,
                   const Eigen::Ref<const Eigen::VectorXd>& dv, Eigen::Ref<Eigen::MatrixXd> dg_da,
                   Eigen::Ref<Eigen::MatrixXd> dg_dv) const;
  // 1/2 v^T M(a) v  and  1/2 a^T K a [J];  da^T C da [W].
  double kinetic_energy(const Eigen::Ref<const Eigen::VectorXd>& a, const Eigen::Ref<const Eigen::VectorXd>& v) const;
  double strain_energy(const Eigen::Ref<const Eigen::VectorXd>& a) const;
  double damping_power(const Eigen::Ref<const Eigen::VectorXd>& da) const;
  // sum_j m_j rho_j(a) / m: centre of mass relative to Bo, in B [m] (zero for s = 0).
  Eigen::Vector3d centre_of_mass(const Eigen::Ref<const Eigen::VectorXd>& a) const;

 private:
  int modes_ = 0;
  double mass_ = 0.0;                       // [kg]
  Eigen::Matrix3d J0_;                      // [kg m2]
  Eigen::Vector3d S0_;                      // sum m rho0 [kg m]
  Eigen::MatrixXd S1_;                      // 3 x s: sum m Phi
  Eigen::MatrixXd C0_;                      // 3 x s: sum m rho0~ Phi + J Psi
  std::vector<Eigen::Matrix3d> G0_;         // s: -sum m rho0~ (Phi_k)~   (so J = J0 + sum a_k (G0_k + G0_k^T) + ...)
  std::vector<Eigen::Matrix3d> G1_;         // s*s: -sum m (Phi_l)~ (Phi_k)~, index l*s+k
  std::vector<Eigen::Vector3d> c1_;         // s*s: sum m Phi_l x Phi_k, index l*s+k
  Eigen::MatrixXd Mff_;                     // s x s
  std::vector<Eigen::MatrixXd> unused_{};   // implementers may replace the private part as they see fit
  Eigen::VectorXd K_, C_;
};

}  // namespace footfall
