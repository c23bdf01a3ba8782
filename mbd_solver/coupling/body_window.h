#pragma once
// The path that elastic modes take in the grains when a window is not short beside their period.

#include <Eigen/Core>
#include <optional>

#include "coupler/body_motion.h"
#include "coupler/messages.h"
#include "coupler/schemes/scheme.h"
#include "coupler/window.h"
#include "mbd_solver/model/body.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// A mode of angular frequency Omega swings Omega H = theta within a window: a straight path at its present rate da
// leaves its true mean place by more than its amplitude, and the contacts' answer to that pumps energy, per window
//   |lambda|^2 = 1 + kappa (1 - cos theta - theta/2 sin theta),  kappa = contact stiffness over the mode's own.
// A path whose MEAN is that of the free swing about a_s, where the present loads hold the mode,
//   a_s     = a + dda / Omega^2
//   da_path = 2/H [(a_s - a)(1 - sin theta / theta) + da (1 - cos theta) / (Omega theta)]
// does no work to first order in kappa at any theta. It replaces da with weight theta^4 / (1 + theta^4), and takes dda
// away with it, so that slow modes keep the path of their scheme. The least damping (0.001) then outweighs what is
// left. theory 7.5.
//
// motion: the state at the window's start, its da and dda replaced; before: the same before any other change;
// stiffness: Omega^2 of each mode [1/s2]; H [s].
void slow_down_fast_modes(const BodyMotion& before, const Eigen::VectorXd& stiffness, double H, BodyMotion& motion);

// What the boundary of one body does in the grains during a window, known here without being told: the grains' side
// walks the same path.

// Scheme `tangent` needs the means of the path: the mean load belongs to them, and with the path itself instead of its
// mean the scheme is unstable. The choice of windows needs the gap between computed and predicted motion.
class PredictedWindow {
 public:
  // The scheme must outlive this. The boundary stands at `initial` until the first window.
  PredictedWindow(const Scheme& scheme, const BodyMotion& initial);

  // A window of n substeps of dt [s] begins with the motion that is sent, `start`.
  void begin(const BodyMotion& start, int n, double dt);
  const PredictedPath& path() const { return path_; }
  void visit(Archive& archive) { walk_.visit(archive); }  // between two windows

 private:
  const Scheme& scheme_;
  BoundaryPath walk_;
  PredictedPath path_;
};

// The windows of one coupled body on the multibody side: which motion is sent, which load is felt, and what is left
// over at the end. theory 7.1.

// Life of a window: begin, then answer, then, once the body has been integrated to the window's end, pending_work and
// surplus_impulse with the motion computed there.
class BodyWindow {
 public:
  // Scheme and body must outlive this. initial: where the boundary stands until the first window; last: what the grains
  // answered before it, empty when a run starts.
  BodyWindow(const Scheme& scheme, const Body& body, const BodyMotion& initial, const BodyLoad& last = BodyLoad());

  // A window of n substeps of dt [s] begins at the state `motion`; its rates become those of the path that the grains
  // are sent: those of the scheme, then those of fast modes.
  void begin(int n, double dt, BodyMotion& motion);
  // The grains have answered: `felt` becomes the load on the body in this window.
  void answer(const BodyLoad& load, ExternalLoad& felt);

  // Work [J] that the contacts still owe, from the predicted end of the boundary to the computed motion.
  double pending_work(const BodyMotion& computed) const;
  // Impulse [N s] beyond what the grains gave; none when the load does not react within the window.
  std::optional<Eigen::Vector3d> surplus_impulse(const BodyMotion& computed) const;

  const PredictedPath& path() const { return predicted_.path(); }
  double length() const { return length_; }  // H [s]

  void visit(Archive& archive);  // between two windows

 private:
  Matrix6d rigid_inertia() const;  // M at the window's start, on (r, theta) in W

  const Scheme& scheme_;
  const Body& body_;
  PredictedWindow predicted_;
  BodyMotion start_;                     // computed state at the window's start
  BodyLoad load_;                        // the grains' last answer
  MeanLoad before_;                      // the mean of the one before
  std::optional<TangentLoad> reaction_;  // of this window
  double length_ = 0.0;                  // H of this window [s]
  int n_ = 0, n_before_ = 0;             // substeps of this window and of the one before
};

}  // namespace footfall
