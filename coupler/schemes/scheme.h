#pragma once
// A scheme of the staggered coupling: both halves of it. [Lin25 section 4.2, 35], theory 7.3.
//
// DEM side: the path of the boundary within a window, and the mean of the forces of its DEM steps.
// Multibody side: the rates that are sent for the path, and the load on the body once the grains' mean is known.

#include <optional>
#include <string_view>

#include "coupler/body_motion.h"
#include "coupler/schemes/window_map.h"

namespace footfall {

struct BodyLoad;  // messages.h
struct MeanLoad;  // load_average.h

// Weights of the forces at the start and at the end of a DEM step in its mean force; they sum to 1. {1/2, 1/2} gives the
// impulse that velocity Verlet applies; {0, 1} is the mean over steps 1..n as published.
struct StepWeights {
  double opening = 0.5;
  double closing = 0.5;
};

// The path of a boundary among the grains during a window, as the multibody side predicts it.
struct PredictedPath {
  // Computed minus predicted motion at the end of the window: [m], and a rotation vector [rad].
  Vector6d gap(const BodyMotion& computed) const;
  // Predicted end minus mean pose, in the same form.
  Vector6d end_from_mean() const;

  // Means are weighted as the forces are.
  Eigen::Vector3d r_mean = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector4d L_mean = Eigen::Vector4d::UnitX();
  Vector6d v_mean = Vector6d::Zero();               // [dr; w] [m/s, rad/s]
  Eigen::Vector3d r_end = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector4d L_end = Eigen::Vector4d::UnitX();
  Eigen::VectorXd a_end;                  // modal coordinates
  Vector6d left_open = Vector6d::Zero();  // of carried gaps: [r_end; L_end] minus the end of the prediction [m, rad]
};

// The grains' loads of two consecutive windows.
struct AnsweredLoads {
  const BodyLoad& load;    // of this window
  const MeanLoad& before;  // of the window before
  double ratio;            // length of this window over the previous one; 0: there was none [-]
};

// A scheme has no state and may be shared by all bodies. All functions are pure: a scheme that lacks one does not
// compile. registry.cpp lists all schemes.
class Scheme {
 public:
  virtual ~Scheme() = default;
  virtual std::string_view name() const = 0;

  // --- DEM side.
  // Predicted position and velocity (r, L, a, dr, w, da) a time tau [s] after `start`, the motion that was sent;
  // accelerations are unchanged. `out` has the size of `start`. No allocation.
  virtual void predict(const BodyMotion& start, double tau, BodyMotion& out) const = 0;
  virtual StepWeights weights() const = 0;
  // True: the boundary starts each window at its current position and reaches the new prediction at the end of the
  // window. False: it jumps to the prediction at the start, and the work of the jump is reported.
  virtual bool continuous_path() const = 0;
  // True: the DEM side also returns the tangent stiffness and damping of each body's contacts.
  virtual bool requires_tangent() const = 0;

  // --- Multibody side.
  // motion: the computed state at the start of a window of H [s]; the rates of the path replace its rates.
  // M: rigid inertia on (r, theta) in W [kg, kg m2]; last: the grains' load of the previous window (empty: none).
  virtual void set_path_rates(const Matrix6d& M, const BodyLoad& last, double H, BodyMotion& motion) const = 0;
  // The reaction of the load within the window, around the mean load of the grains; none: only the mean load acts.
  virtual std::optional<TangentLoad> reaction(const Matrix6d& M, const BodyLoad& load, const PredictedPath& path,
                                              double H) const = 0;
  // Work [J] of the contacts on the boundary between its predicted end and the computed motion. The body has received it
  // already; the grains do it only when the next window closes the gap.
  virtual double pending_work(const AnsweredLoads& loads, const PredictedPath& path,
                              const BodyMotion& computed) const = 0;

  // --- Stability: one window of n DEM steps of the model problem in window_map.h.
  virtual MapState window_map(double omega_h, int n, const MapState& z) const = 0;

  // DEM steps of window k of a run with n DEM steps per window. The slopes of contacts that exist at the start are found
  // in a first window of one DEM step.
  int substeps(int n, long k) const { return requires_tangent() && k == 0 ? 1 : n; }
};

// The straight path, of css, css-trapezoid and tangent: r + dr tau,  exp(w tau) L,  a + da tau;  constant rates.
void predict_linear(const BodyMotion& start, double tau, BodyMotion& out);

}  // namespace footfall
