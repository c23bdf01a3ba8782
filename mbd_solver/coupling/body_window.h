#pragma once
// The windows of one coupled body on the multibody side: which motion is sent, which load is felt, and what is left
// over at the end. theory 7.1.

#include <optional>

#include "coupler/messages.h"
#include "mbd_solver/coupling/predicted_window.h"
#include "mbd_solver/model/body.h"
#include "mbd_solver/model/external_load.h"

namespace footfall {

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
