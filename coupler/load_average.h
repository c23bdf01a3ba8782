#pragma once
// The mean load of one window on one body, and the work that went with it. [Lin25 34], theory 7.2.

#include "coupler/body_motion.h"
#include "coupler/schemes/scheme.h"
#include "coupler/window.h"

namespace footfall {

// Convention, the same on both sides of the exchange:
//   F_W  mean force in W:            the linear impulse F_W H is exact, however the body turns
//   T_B  mean moment about Bo, in B: it turns with the body, so the result does not depend on H through rotation
//   Q_a  mean modal force
struct MeanLoad {
  explicit MeanLoad(int modes = 0) : Q_a(Eigen::VectorXd::Zero(modes)) {}
  void set_zero();

  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();  // [N]
  Eigen::Vector3d T_B = Eigen::Vector3d::Zero();  // [N m]
  Eigen::VectorXd Q_a;                            // s
  double work = 0.0;       // done by the grains on the boundary along its path, jump included [J]
  double jump_work = 0.0;  // the part of `work` done by the jump at the window's start [J]
  Eigen::Vector3d impulse_W = Eigen::Vector3d::Zero();  // what Verlet really gave: half weights in every scheme [N s]
};

// The force at the end of a substep: the next one opens with it. F_W, T_B, Q_a as above.
struct StandingForce {
  explicit StandingForce(int modes = 0) : Q_a(Eigen::VectorXd::Zero(modes)) {}

  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d T_B = Eigen::Vector3d::Zero();
  Eigen::VectorXd Q_a;
};

// The load at t as the bodies feel it under a mean load: F_W, T_W = R_WB T_B, Q_a.
void apply(const MeanLoad& mean, const BodyMotion& motion, GeneralizedForce& out);

// Collects the forces of the substeps. Everything is linear in the forces, so each MPI rank may hold its own
// and the ranks' results are summed once per window. Every force is the one standing at the path's pose() at
// that moment.
class LoadAverage {
 public:
  LoadAverage(const Scheme& scheme, int modes);

  // The force standing before the first substep (the set-up of a run evaluates it); replaces what the last
  // substep left.
  void set_standing(const GeneralizedForce& Q, const BodyMotion& pose);
  void set_standing(const StandingForce& force) { standing_ = force; }
  const StandingForce& standing() const { return standing_; }
  // A window begins: `jump` and `pose` are the path's after its begin_window. The force standing stays.
  void begin_window(const BoundaryStep& jump, const BodyMotion& pose);
  // After a substep of dt [s] that moved the boundary by `step` to `pose`, where the forces are now Q.
  void add_step(const GeneralizedForce& Q, const BodyMotion& pose, const BoundaryStep& step, double dt);
  // Mean since begin_window. Precondition: at least one step.
  const MeanLoad& finish();

 private:
  StepWeights weights_;
  StandingForce standing_;
  MeanLoad sum_;       // time integrals, then means
  double time_ = 0.0;  // since begin_window [s]
};

}  // namespace footfall
