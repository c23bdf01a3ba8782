#pragma once
// A scheme of the staggered coupling, both halves of it. [Lin25 section 4.2, 34], theory 7.3.
//
// The grains' side: the path of the boundary while the bodies wait, and how the forces of the substeps become one mean.
// The body's side: which rates the path is sent with, and which load the body feels once the grains have answered.

#include <optional>
#include <string_view>

#include "coupler/body_motion.h"
#include "coupler/schemes/window_map.h"

namespace footfall {

struct BodyLoad;  // messages.h
struct MeanLoad;  // load_average.h

// Share of a substep's mean force that comes from the force standing at its start and at its end; the two sum to 1.
// {1/2, 1/2} is the impulse that velocity Verlet really applies; {0, 1} is the mean over steps 1..n as printed.
struct StepWeights {
  double opening = 0.5;
  double closing = 0.5;
};

// The path that a boundary has gone in the grains during a window, as the body's side knows it.
struct PredictedPath {
  // Computed minus predicted motion at the window's end: [m], and as a rotation vector [rad].
  Vector6d gap(const BodyMotion& computed) const;
  // Predicted end minus mean pose, likewise.
  Vector6d end_from_mean() const;

  // Means are weighted as the forces are.
  Eigen::Vector3d r_mean = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector4d L_mean = Eigen::Vector4d::UnitX();
  Vector6d v_mean = Vector6d::Zero();               // [dr; w] [m/s, rad/s]
  Eigen::Vector3d r_end = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector4d L_end = Eigen::Vector4d::UnitX();
};

// What the grains have answered to two windows in a row.
struct AnsweredLoads {
  const BodyLoad& load;    // of this window
  const MeanLoad& before;  // of the window before
  double ratio;            // length of this window over that one; 0: there was none [-]
};

// A scheme has no state: it may be shared by all bodies and both programs. Everything is pure here: a scheme that
// forgets a part does not compile. registry.cpp has the list of them.
class Scheme {
 public:
  virtual ~Scheme() = default;
  virtual std::string_view name() const = 0;

  // --- The grains' side.
  // Predicted position and velocity (r, L, a, dr, w, da) a time tau [s] after `start`, the motion that was sent;
  // accelerations are left alone. `out` is sized like `start`. No allocation.
  virtual void predict(const BodyMotion& start, double tau, BodyMotion& out) const = 0;
  virtual StepWeights weights() const = 0;
  // True: the boundary starts each window where the last one ended and reaches the new prediction at the window's end.
  // False: it jumps to the prediction at the window's start, and the work of the jump is counted and reported.
  virtual bool continuous_path() const = 0;
  // True: the grains' side also returns the tangent stiffness and damping of each body's contacts.
  virtual bool wants_tangent() const = 0;

  // --- The body's side.
  // `motion`: the computed state at the start of a window of H [s]; its rates become those that the path is sent with.
  // M: rigid inertia on (r, theta) in W [kg, kg m2]; last: what the grains answered to the window before (empty: none).
  virtual void set_path_rates(const Matrix6d& M, const BodyLoad& last, double H, BodyMotion& motion) const = 0;
  // How the load reacts within the window around the mean load of the grains; none: the body feels the mean alone.
  virtual std::optional<TangentLoad> reaction(const Matrix6d& M, const BodyLoad& load, const PredictedPath& path,
                                              double H) const = 0;
  // Work [J] that the contacts would still do on the boundary from its predicted end to the computed motion: the grains
  // do it only when the next window closes the gap, while the body has received it already.
  virtual double pending_work(const AnsweredLoads& loads, const PredictedPath& path,
                              const BodyMotion& computed) const = 0;

  // --- Its map: one window of n substeps of the simplest problem (window_map.h).
  virtual MapState window_map(double omega_h, int n, const MapState& z) const = 0;

  // Substeps of window k of a run that would have n: slopes of contacts that stand already are learnt in a window of
  // one substep.
  int substeps(int n, long k) const { return wants_tangent() && k == 0 ? 1 : n; }
};

// r + dr tau,  exp(w tau) L,  a + da tau;  its rates stay.
void predict_linear(const BodyMotion& start, double tau, BodyMotion& out);

}  // namespace footfall
