#pragma once
// The mean load of one window on one body, and its work. [Lin25 35], theory 7.2.

#include "coupler/body_motion.h"
#include "coupler/schemes/scheme.h"
#include "coupler/window.h"

namespace footfall {

// Convention of both programs:
//   F_W  mean force in W:            the linear impulse F_W H is exact, however the body turns
//   T_B  mean moment about Bo, in B: it turns with the body, so the result does not depend on H through rotation
//   Q_a  mean modal force
struct MeanLoad {
  explicit MeanLoad(int modes = 0) : Q_a(Eigen::VectorXd::Zero(modes)) {}
  void set_zero();

  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();  // [N]
  Eigen::Vector3d T_B = Eigen::Vector3d::Zero();  // [N m]
  Eigen::VectorXd Q_a;                            // s
  double work = 0.0;       // of the grains on the boundary along its path, including the jump [J]
  double jump_work = 0.0;  // the part of `work` by the jump at the start of the window [J]
  Eigen::Vector3d impulse_W =
      Eigen::Vector3d::Zero();  // applied by velocity Verlet: half weights in every scheme [N s]
};

// The force at the start of a DEM step, equal to the force at the end of the step before. F_W, T_B, Q_a as above.
struct OpeningForce {
  explicit OpeningForce(int modes = 0) : Q_a(Eigen::VectorXd::Zero(modes)) {}

  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d T_B = Eigen::Vector3d::Zero();
  Eigen::VectorXd Q_a;
};

// A mean load on a body in this motion: F_W, T_W = R_WB T_B, Q_a.
void apply(const MeanLoad& mean, const BodyMotion& motion, GeneralizedForce& out);

// Averages the forces of the DEM steps. All results are linear in the forces: each MPI rank averages its own, and the
// ranks' results are summed once per window. Every force acts at the path's pose() of its time.
class LoadAverage {
 public:
  LoadAverage(const Scheme& scheme, int modes);

  // The force at the start of the next DEM step, as evaluated in the set-up of a run; replaces the previous force.
  void set_opening_force(const GeneralizedForce& Q, const BodyMotion& pose);
  void set_opening_force(const OpeningForce& force) { opening_ = force; }
  const OpeningForce& opening_force() const { return opening_; }
  // Begins a window: `jump` and `pose` come from the path after its begin_window. The opening force is unchanged.
  void begin_window(const BoundaryStep& jump, const BodyMotion& pose);
  // After a DEM step of dt [s] that moved the boundary by `step` to `pose`, where the forces are Q. Returns the mean
  // force of the DEM step [N].
  Eigen::Vector3d add_step(const GeneralizedForce& Q, const BodyMotion& pose, const BoundaryStep& step, double dt);
  // Mean since begin_window. Precondition: at least one step.
  const MeanLoad& finish();

 private:
  StepWeights weights_;
  OpeningForce opening_;
  MeanLoad sum_;       // time integrals, then means
  double time_ = 0.0;  // since begin_window [s]
};

}  // namespace footfall
