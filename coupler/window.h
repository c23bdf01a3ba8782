#pragma once
// The path of one body's boundary through the windows of a run: where the grains see it at every substep.
// theory: coupling (boundary jump; continuous path).

#include "coupler/body_motion.h"
#include "coupler/scheme.h"

namespace footfall {

// What the boundary did in one substep, in generalized coordinates: the displacement whose partner is the GeneralizedForce.
struct BoundaryStep {
  explicit BoundaryStep(int modes = 0) : a(Eigen::VectorXd::Zero(modes)) {}
  Eigen::Vector3d r = Eigen::Vector3d::Zero();        // [m]
  Eigen::Vector3d theta_W = Eigen::Vector3d::Zero();  // rotation vector [rad]
  Eigen::VectorXd a;                                  // s
};

// One body. Both programs may hold one: the DEM side to move nodes, the multibody side to know the mean predicted pose.
// Window: begin_window(state at t_k, n, dt), then advance() n times; after each, pose() is the path at t_k + i dt.
class BoundaryPath {
 public:
  // The boundary stands at `initial` until the first window. The scheme must outlive the path.
  BoundaryPath(const Scheme& scheme, const BodyMotion& initial);

  // New window of n substeps of dt [s] from the computed state `start`. If the path jumps, pose() jumps here and jump() tells by how much.
  void begin_window(const BodyMotion& start, int n, double dt);
  // One substep on. Precondition: fewer than n calls since begin_window.
  void advance();

  const BodyMotion& pose() const { return pose_; }           // r, L, a, dr, w, da of the boundary now
  const BoundaryStep& last_step() const { return step_; }    // done by the last advance()
  const BoundaryStep& jump() const { return jump_; }         // done by the last begin_window(); zero for a continuous path
  // True when this window is a translation at constant velocity from where the boundary stands, to round-off: nodes may then be
  // moved by x += dr * dt per substep, exactly as LIGGGHTS' own `fix move/mesh linear` does. pose() follows the same sums.
  bool steady_translation() const { return steady_; }
  int substeps_left() const { return n_ - i_; }

 private:
  void set_pose_at(double tau);

  const Scheme& scheme_;
  BodyMotion start_;      // computed state at t_k
  BodyMotion pose_;       // the path now
  BodyMotion before_;     // the path one substep ago
  BoundaryStep step_;
  BoundaryStep jump_;
  BoundaryStep gap_;      // from the state at t_k to where the boundary stood: closed linearly within the window
  int n_ = 0;             // substeps of this window
  int i_ = 0;             // substeps done
  double dt_ = 0.0;       // [s]
  bool steady_ = false;
};

}  // namespace footfall
