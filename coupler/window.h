#pragma once
// The path of one body's boundary through the windows of a run: its position for the grains at every DEM step. theory 7.4.
//
// Jump. At the end of a window the prediction misses the computed state by a gap e of O(H^2). Moving a loaded boundary
// by e at once creates energy. A continuous path starts at the boundary's current position and closes the gap within the
// window:
//   x(tau) = prediction(tau) + e g(u),  u = tau / H
//   g(u) = 1 - 4 u + 3 u^2
// g has zero mean: closing the gap changes neither the mean position over the window nor the elastic load. For a
// body on an elastic contact the amplification is then 1 up to omega H = 2. (Closing the gap by 1 - u shifts the mean by
// e/2, and the amplitude grows at any H.) The mean velocity is the predicted velocity - e / H, which is of second order
// although the prediction alone is of first order: contact damping does not reduce the order.
// Two-mass oscillator of theory 7.3 (H = 1 ms; linear prediction, trapezoid):
//                     error at 0.2 s, order   energy after 5 s   order with 100 N s/m in the contact
//   jump              3.1e-3, 2.0             1.008              1.0
//   closed by 1 - u   1.2e-2, 2.1             1.045              1.9
//   closed by g       2.7e-3, 2.0             1.001              2.0
// Contact damping acts on the derivative of the path.
//
// Catching up. A gap that a long window has made closes over that length, even if the present window is shorter: within few
// DEM steps the boundary would move much faster than the body ever did, and contact damping would do work that no part
// supplies. Such gaps are carried from window to window, each closed by its own g.
//
// Known motion. Where the joints alone decide how a body moves (prescribed motions), its poses are known for every
// DEM step, and the boundary follows them.

#include <vector>

#include "coupler/archive.h"
#include "coupler/body_motion.h"
#include "coupler/schemes/scheme.h"

namespace footfall {

// Displacement of the boundary in one DEM step, in generalized coordinates; conjugate to GeneralizedForce.
struct BoundaryStep {
  explicit BoundaryStep(int modes = 0) : a(Eigen::VectorXd::Zero(modes)) {}
  Eigen::Vector3d r = Eigen::Vector3d::Zero();        // [m]
  Eigen::Vector3d theta_W = Eigen::Vector3d::Zero();  // rotation vector [rad]
  Eigen::VectorXd a;                                  // s
};

// A known motion of a body in a window: after every DEM step r, L, dr, w (column by column). No columns: not known.
using KnownPath = Eigen::Matrix<double, 13, Eigen::Dynamic>;

// The path of one body. The DEM side moves nodes by it; the multibody side computes the mean predicted pose from it. Call
// begin_window(motion sent for t_k, n, dt), then advance() n times; after each, pose() is the path at t_k + i dt.
class BoundaryPath {
 public:
  // The boundary is at `initial` until the first window. The scheme must outlive the path.
  BoundaryPath(const Scheme& scheme, const BodyMotion& initial);

  // Begins a window of n DEM steps of dt [s] from `start`: position at t_k and rates of the path. If the path jumps,
  // pose() jumps here by jump(). closing: DEM steps in which the gap of the window before closes, at least n; 0: n.
  // known: of this window; modes still follow the scheme.
  void begin_window(const BodyMotion& start, int n, double dt, int closing = 0, const KnownPath& known = KnownPath());
  // Advances by one DEM step. Precondition: fewer than n calls since begin_window.
  void advance();

  const BodyMotion& pose() const { return pose_; }         // r, L, a, dr, w, da of the boundary now
  const BoundaryStep& last_step() const { return step_; }  // by the last advance()
  const BoundaryStep& jump() const { return jump_; }       // by the last begin_window(); zero for a continuous path
  // True when this window is a translation at constant velocity from the current position, to round-off. Nodes may then
  // be moved by x += dr * dt per DEM step, exactly as LIGGGHTS' own `fix move/mesh linear` does; pose() is summed up in
  // the same way.
  bool steady_translation() const { return steady_; }
  // The part of carried gaps that remains at the end of this window: path minus prediction.
  const BoundaryStep& left_open() const { return left_open_; }
  bool is_known() const { return is_known_; }  // in this window, or the last one
  int substeps_left() const { return n_ - i_; }
  bool first_substep() const { return i_ == 1; }

  void visit(Archive& archive);  // between two windows

 private:
  // A gap that closes over several windows.
  struct Carried {
    BoundaryStep gap;
    double elapsed = 0.0, duration = 0.0;  // at the start of this window; of its closing [s]
    void visit(Archive& archive);
  };
  void carry(int closing);
  bool gap_is_round_off() const;
  void set_pose_at(double tau);
  void follow_known_path();

  const Scheme& scheme_;
  BodyMotion start_;    // the motion sent: position at t_k, rates of the path
  BodyMotion pose_;     // the path now
  BodyMotion before_;   // the path one DEM step ago
  BodyMotion shifted_;  // start_ moved by the rest of the gap
  BoundaryStep step_;
  BoundaryStep jump_;
  BoundaryStep gap_;  // from the position at t_k to the end of the path before, without carried gaps
  BoundaryStep left_open_;
  std::vector<Carried> carried_;
  KnownPath known_;
  double travelled_ = 0.0;  // largest |r| so far, the scale of round-off in r [m]
  double amplitude_ = 0.0;  // largest |a| so far, likewise
  int n_ = 0;               // DEM steps of this window
  int i_ = 0;               // of them done
  double dt_ = 0.0;         // [s]
  bool steady_ = false, is_known_ = false;
};

}  // namespace footfall
