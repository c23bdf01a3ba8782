#pragma once
// Inertia of one body in its own frame B, rigid (s = 0) or flexible, at a cost of O(s^2) per evaluation: sums over nodes are
// done once, at construction (inertia shape integrals).

#include <Eigen/Dense>

#include "mbd_solver/model/column_groups.h"
#include "mbd_solver/model/modal_body.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

// All components in B:  v = [dr; w; da] (6+s), dv = its components' rates as used in theory 1.2:
//   ddr_j = ddr + dw x rho_j + Phi_j dda + w_j,   w_j = 2 w x (Phi_j da) + w x (w x rho_j).
//   M(a) dv + h(a, v) = applied generalized force: Lagrange's equations of
//   T = 1/2 m |dr|^2 + dr . (w x S(a) + S1 da) + 1/2 w . J(a) w + w . C(a) da + 1/2 da^T Mff da
// with elastic and damping forces in h. The rotary inertia J_j of a node turns with it, by t_j = Psi_j a: to second
// order in a this is J_j + t~ J_j - J_j t~ + 1/2 (t~ t~ J_j + J_j t~ t~) - t~ J_j t~, with the node's angular
// velocity w + Psi_j da + 1/2 t x Psi_j da. This includes gyroscopic and centrifugal moments of discs on a shaft. In
// a mass matrix the rows of each node turn with it in the same way (theory 1.2). For s = 0: M = diag(m I, J), h = [m
// w x (w x c); w x J w] with c = 0.
class ModalInertia {
 public:
  // Rigid body: mass [kg], inertia about the centre of mass in B [kg m2].
  ModalInertia(double mass, const Eigen::Matrix3d& inertia);
  explicit ModalInertia(const ModalBody& body);

  int mode_count() const { return modes_; }
  double mass() const { return mass_; }
  // Number of products in the sums over two modes of one inertia_force: at most 15 s^2, fewer where sums are zero.
  Eigen::Index products() const { return by_a_.entries() + by_da_.entries(); }

  // M(a): (6+s) x (6+s), symmetric positive definite.
  void mass_matrix(const Eigen::Ref<const Eigen::VectorXd>& a, Eigen::Ref<Eigen::MatrixXd> M) const;
  // M(a) x and g = M(a) dv + h(a, v) (6+s each), without M itself. `scratch`: of this body.
  struct Scratch {
    explicit Scratch(int modes = 0) : by_a(9 * modes), by_da(6 * modes), sums(10 * modes) {}
    Eigen::VectorXd by_a;   // dJ/da_k in rows 6k.., then C_k in rows 6s + 3k..
    Eigen::VectorXd by_da;  // sum_l (dC_k/da_l - dC_l/da_k) da_l in rows 3k.., then 1/2 sum_l (.. + ..) da_l
    Eigen::VectorXd sums;
  };
  void mass_product(const Eigen::Ref<const Eigen::VectorXd>& a, const Eigen::Ref<const Eigen::VectorXd>& x,
                    Scratch& scratch, Eigen::Ref<Eigen::VectorXd> out) const;
  void inertia_force(const Eigen::Ref<const Eigen::VectorXd>& a, const Eigen::Ref<const Eigen::VectorXd>& v,
                     const Eigen::Ref<const Eigen::VectorXd>& dv, Scratch& scratch,
                     Eigen::Ref<Eigen::VectorXd> g) const;
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
  Eigen::Vector3d to_principal(const Eigen::Vector3d& of_body) const;
  Eigen::Vector3d to_body(const Eigen::Vector3d& of_principal) const;
  // The first six rows or columns are two vectors.
  void rows_to_body(Eigen::Ref<Eigen::MatrixXd> A) const;
  void columns_to_body(Eigen::Ref<Eigen::MatrixXd> A) const;
  void sum_over_nodes(const ModalBody& body);                                         // the integrals of lumped masses,
  void sum_over_mass_matrix(const ModalBody& body);                                   // and of a mass matrix
  void sum_by_a(const Eigen::Ref<const Eigen::VectorXd>& a, Scratch& scratch) const;  // by_a
  void times_modal_mass(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> out) const;  // Mff x
  // In the principal axes, as the integrals below:
  Eigen::Vector3d first_moment(const Eigen::Ref<const Eigen::VectorXd>& a) const;           // S(a)
  Eigen::Vector3d coupling(int k, const Eigen::Ref<const Eigen::VectorXd>& a) const;        // C_k(a), column of C
  Eigen::Matrix3d inertia(const Eigen::Ref<const Eigen::VectorXd>& a) const;                // J(a)
  Symmetric inertia_slope(int k, const Eigen::Ref<const Eigen::VectorXd>& a) const;         // dJ/da_k
  Symmetric inertia_curvature(int l, int k) const { return pairs_.block<6, 1>(6 * k, l); }  // d2J/da_l da_k
  Eigen::Vector3d coupling_slope(int l, int k) const { return pairs_.block<3, 1>(6 * modes_ + 3 * k, l); }  // dC_k/da_l

  // Shape integrals, in the principal axes of the body, where many sums over two modes are zero (column_groups.h); x~ is the skew matrix of x, sums over nodes j, t_k = Psi_k of the node.
  int modes_ = 0;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  // the principal axes in B, columns
  bool turned_ = false;                                 // they differ from the axes of B
  double mass_ = 0.0;                                   // sum m [kg]
  Eigen::Vector3d S0_;                                  // sum m rho0 [kg m]
  Eigen::Matrix3Xd S1_;                                 // 3 x s: sum m Phi
  Eigen::Matrix3d J0_;                                  // sum -m rho0~ rho0~ + J_j [kg m2]
  Eigen::Matrix<double, 6, Eigen::Dynamic> J1_;         // 6 x s: dJ/da_k at a = 0
  Eigen::Matrix3Xd C0_;                                 // 3 x s: sum m rho0~ Phi + J_j Psi
  // 9s x s, integrals with two modes:
  // rows 6k.., column l:  J2_lk = d2J/da_l da_k
  // rows 6s + 3k..:       C1_lk = dC_k/da_l = sum m Phi_l x Phi_k + t_l x J_j t_k - 1/2 J_j (t_l x t_k)
  Eigen::MatrixXd pairs_;
  ColumnGroups by_a_;        // pairs_ without zeros
  ColumnGroups by_da_;       // rows 3k..: C1_lk - C1_kl, then rows 3s + 3k..: 1/2 (C1_lk + C1_kl)
  Eigen::MatrixXd Mff_;      // s x s: sum m Phi^T Phi + Psi^T J_j Psi
  bool orthogonal_ = false;  // it is diagonal
  Eigen::VectorXd K_, C_;    // s: diagonal modal stiffness [1/s2] and damping [1/s]
};

}  // namespace footfall
