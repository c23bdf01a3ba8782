#pragma once
// One body within a window: the path of its boundary in the grains, the load it receives and the work that is pending.

#include <Eigen/Core>
#include <optional>

#include "coupler/body_motion.h"
#include "coupler/messages.h"
#include "coupler/schemes/scheme.h"
#include "coupler/window.h"
#include "mbd_solver/model/body.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// The path of elastic modes whose period is not long compared with a window.
// A mode of angular frequency Omega turns by Omega H = theta within a window. On a straight path at its present rate da
// its mean position is wrong by more than its amplitude, and the contacts' reaction creates energy, per window
//   |lambda|^2 = 1 + kappa (1 - cos theta - theta/2 sin theta),  kappa = contact stiffness / stiffness of the mode.
// A path whose MEAN equals the mean of the free vibration about a_s, the equilibrium under the present loads,
//   a_s     = a + dda / Omega^2
//   da_path = 2/H [(a_s - a)(1 - sin theta / theta) + da (1 - cos theta) / (Omega theta)]
// does no work to first order in kappa for any theta. It replaces da with weight theta^4 / (1 + theta^4) and reduces
// dda by the same weight: slow modes keep the path of their scheme. The least damping (0.001) exceeds the remaining
// effect. theory 7.5.
//
// motion: the state at the window's start, its da and dda are replaced; before: the same before any other change;
// stiffness: Omega^2 of each mode [1/s2]; H [s].
void slow_down_fast_modes(const BodyMotion& before, const Eigen::VectorXd& stiffness, double H, BodyMotion& motion);

// The path of one boundary in the grains during a window, computed here as on the DEM side.
// Scheme `tangent` needs the means of the path: the mean load belongs to them, and with the path itself instead of its
// mean the scheme is unstable. The choice of windows needs the gap between computed and predicted motion.
class PredictedWindow {
 public:
  // The scheme must outlive this. initial: position of the boundary until the first window.
  PredictedWindow(const Scheme& scheme, const BodyMotion& initial);

  // A window of n DEM steps of dt [s] begins with the motion that is sent, `start`. closing, known: of
  // BoundaryPath::begin_window.
  void begin(const BodyMotion& start, int n, double dt, int closing = 0, const KnownPath& known = KnownPath());
  const PredictedPath& path() const { return path_; }
  bool is_known() const { return walk_.is_known(); }
  void visit(Archive& archive) { walk_.visit(archive); }  // between two windows

 private:
  const Scheme& scheme_;
  BoundaryPath walk_;
  PredictedPath path_;
};

// The windows of one coupled body on the multibody side: the motion sent, the load applied, the remainder at the end.
// theory 7.1.
// Order of calls in a window: begin, apply, then, when the body has been integrated to the window's end, pending_work
// and surplus_impulse with the motion computed there.
class BodyWindow {
 public:
  // Scheme and body must outlive this. initial: motion of the boundary until the first window; last: load of the window
  // before it, empty when a run starts.
  BodyWindow(const Scheme& scheme, const Body& body, const BodyMotion& initial, const BodyLoad& last = BodyLoad());

  // A window of n DEM steps of dt [s] begins at the state `motion`; the rates of the path replace its rates, as they
  // are sent to the grains: of the scheme, then of fast modes. closing, known: of BoundaryPath::begin_window.
  void begin(int n, double dt, BodyMotion& motion, int closing = 0, const KnownPath& known = KnownPath());
  // The grains' load of this window arrived: `applied` becomes the load on the body.
  void apply(const BodyLoad& load, ExternalLoad& applied);

  // The work received [J] equals the work of the grains, because they knew the motion: no work is left over.
  bool is_known() const { return predicted_.is_known() && body_.mode_count() == 0; }
  double work() const { return load_.mean.work; }  // of the grains on the boundary [J]

  // Work [J] that the contacts have not done yet, from the predicted end of the boundary to the computed motion.
  double pending_work(const BodyMotion& computed) const;
  // The same of the modes, from the predicted to the computed modal coordinates.
  double pending_modal_work(const BodyMotion& computed) const;
  // Impulse [N s] in addition to the grains' impulse; none when the load does not react within the window.
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
  BodyLoad load_;                        // last load of the grains
  MeanLoad before_;                      // mean load of the window before
  std::optional<TangentLoad> reaction_;  // of this window
  double length_ = 0.0;                  // H of this window [s]
  int n_ = 0, n_before_ = 0;             // DEM steps of this window and of the one before
};

}  // namespace footfall
