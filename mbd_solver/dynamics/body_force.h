#pragma once
// Inertia, elastic and gravity forces of one body, and the external load on it, in W, with derivatives.
// Inertia from ModalInertia in B is transformed to W: g_W = T g_B, T = diag(A, A, I). Rotating the body and rotating the frame
// are equivalent:  dg/dtheta = -g~ + (dg/dv) v~ + (dg/ddv) dv~  (block by block). Rigid bodies have a shorter path.

#include <Eigen/Dense>

#include "mbd_solver/model/body.h"
#include "mbd_solver/model/kinematic_vector.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// Scratch of one flexible body (6+s); empty for a rigid one.
struct InertiaScratch {
  explicit InertiaScratch(int modes);
  Eigen::VectorXd v, dv, g, force;
  Eigen::MatrixXd M, dg_da, dg_dv;
  ModalInertia::Scratch inertia;
};

// F += M dv + h - [m gravity; 0; 0], with the accelerations of `at`. F: 6+s.
void add_body_force(const Body& body, const BodyKinematics& at, const Eigen::Vector3d& gravity, InertiaScratch& scratch,
                    Eigen::Ref<Eigen::VectorXd> F);

// M in W: (6+s) x (6+s), overwritten.
void body_mass_matrix(const Body& body, const BodyKinematics& at, InertiaScratch& scratch,
                      Eigen::Ref<Eigen::MatrixXd> M);

// out = M x in W, both 6+s, without M itself.
void body_mass_product(const Body& body, const BodyKinematics& at, const Eigen::Ref<const Eigen::VectorXd>& x,
                       InertiaScratch& scratch, Eigen::Ref<Eigen::VectorXd> out);

// Derivatives of M dv + h: dF/dx, dF/dv, and M (= dF/ddv), all overwritten.
void body_derivatives(const Body& body, const BodyKinematics& at, InertiaScratch& scratch,
                      Eigen::Ref<Eigen::MatrixXd> dF_dx, Eigen::Ref<Eigen::MatrixXd> dF_dv,
                      Eigen::Ref<Eigen::MatrixXd> M);

// Q += generalized force of the load (6+s).
void add_load_force(const ExternalLoad& load, const BodyKinematics& at, Eigen::Ref<Eigen::VectorXd> Q);
// K += dQ/dx, D += dQ/dv.
void add_load_derivatives(const ExternalLoad& load, const BodyKinematics& at, Eigen::Ref<Eigen::MatrixXd> K,
                          Eigen::Ref<Eigen::MatrixXd> D);

}  // namespace footfall
