#pragma once
// The mass that the contacts of a body meet: that of what they move, with joints and prescribed motions. theory 7.9.

#include "coupler/archive.h"
#include "coupler/modal_boundary.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// A load Q = [F; T; Q_a] on the body gives the mechanism the accelerations M^-1 Q that its joints leave:
//   1/m = q . M^-1 q,   q = Q / |F|
// For a force through the mass centre of a free body m is its mass; where a joint, a prescribed motion or the ground
// takes the load, m is infinite. Forces that cancel leave a moment and no force: T / |F| is cut off at the reach of
// the boundary, Q_a / |F| at the largest displacement of its nodes in the modes, the most that one contact can do.
class ContactMass {
 public:
  // equations must outlive this; body: index in the model.
  ContactMass(Equations& equations, int body, const ModalBoundary& boundary);

  // H [s] of the window: a mode of angular frequency Omega that swings within it yields as a spring and not as a mass,
  // and counts with 1 / (1 + (Omega H)^4), as in fast_modes.h.
  // [kg] at `state` under the load `felt` on the body. Without a force: as it was when there was one, at
  // the start the body's own.
  double along(const ExternalLoad& felt, const State& state, double H);
  double last() const { return mass_; }            // as it was found last [kg]
  bool asks_mechanism() const { return joined_; }  // along() solves for accelerations
  void visit(Archive& archive) { archive("mass", mass_); }

 private:
  Equations& equations_;
  int body_;
  bool joined_;            // some joint holds on to the body: the whole mechanism is asked
  double mass_;            // [kg]
  double reach_;           // largest |rho0| [m]
  double largest_mode_;    // of all nodes: largest |Phi_j|
  Eigen::VectorXd q_;      // as v: what pushes, 1 N
  Eigen::VectorXd moved_;  // M^-1 q
};

}  // namespace footfall
