#pragma once
// The effective mass that the contacts of a body move, including joints and prescribed motions. theory 7.9.

#include "coupler/archive.h"
#include "coupler/modal_boundary.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// A load Q = [F; T; Q_a] on the body gives the mechanism the accelerations M^-1 Q that its joints allow:
//   1/m = q . M^-1 q,   q = Q / |F|
// For a force through the mass centre of a free body m is its mass; where a joint, a prescribed motion or the ground
// supports the load, m is infinite. Forces that cancel leave a moment and no force: T / |F| is limited by the reach of
// the boundary, Q_a / |F| by the largest modal displacement of its nodes, the limits for a single contact.
class ContactMass {
 public:
  // equations must outlive this; body: index in the model.
  ContactMass(Equations& equations, int body, const ModalBoundary& boundary);

  // Effective mass [kg] at `state` under the load on the body. Without a force: the last value; at the start the mass of
  // the body. H [s]: of the window; a mode of angular frequency Omega that vibrates within it deflects as a spring and
  // not as a mass, and counts with 1 / (1 + (Omega H)^4), as in slow_down_fast_modes().
  double along(const ExternalLoad& load, const State& state, double H);
  double last() const { return mass_; }              // last result [kg]
  bool solves_equations() const { return joined_; }  // along() solves for accelerations of the mechanism
  void visit(Archive& archive) { archive("mass", mass_); }

 private:
  Equations& equations_;
  int body_;
  bool joined_;            // a joint holds the body: the whole mechanism counts
  double mass_;            // [kg]
  double reach_;           // largest |rho0| [m]
  double largest_mode_;    // of all nodes: largest |Phi_j|
  Eigen::VectorXd q_;      // generalized force of 1 N
  Eigen::VectorXd moved_;  // M^-1 q
};

}  // namespace footfall
