#pragma once
// Newton's method on the equations of one stage of a one-step method, with a Jacobian that serves many steps.
//   Y = known + K / c,  F(t, Y, K) = 0
// Positions follow from velocities in closed form, so that Newton iterates [v; z; lambda] alone, with the reduced
// Jacobian at c. Multipliers have no rates. Newton stops when its remaining error is small relative to the error of
// the step. A stiff force whose direction turns within a step makes later stages converge much more slowly than the
// one before: their first iteration is judged by the slowest stage so far, and after such a step all of them more
// strictly, because remaining errors add up over many steps.

#include <string>

#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/integrator/reduced_system.h"

namespace footfall {

// Why the last step failed.
struct StepFailure {
  int worst = -1;      // entry of y
  std::string reason;  // of a force law without a value, or a joint that remains open; ends with its code
};

class StageNewton {
 public:
  // All must outlive this object.
  StageNewton(Equations& equations, const ErrorNorm& norm, IntegratorStatistics& statistics, StepFailure& failure);

  void begin_step(bool stiff) {
    fresh_ = false;
    stiff_ = stiff;
    turns_ = false;
    slowest_before_ = slowest_;
    slowest_ = 0.0;
  }
  bool fresh() const { return fresh_; }                              // the Jacobian belongs to this step
  double rate() const { return rate_; }                              // last convergence rate
  bool has_stiff_force() const { return stiffness_ > stiff_from_; }  // at the last Jacobian
  // A stiff force turned in this step: a stage converged slowly with a Jacobian of this step.
  bool turns() const { return turns_; }
  void drop_factors() { factored_c_ = 0.0; }  // the next stage requires a new Jacobian
  void forget();

  // The factors are missing, or, in the first stage of a step, belong to another c or converge more slowly than `slow`.
  bool needs_jacobian(double c, bool first_stage, double slow) const;
  // Jacobian at y with rates K, and its factors. False: a law has no value, or the matrix is singular.
  bool refresh(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& K, double c, double slow,
               const Inputs& inputs);
  // Y and K of a stage, from their predictions. False: no convergence.
  bool solve(double t, double c, const Eigen::VectorXd& known, double tolerance, double slow, const Inputs& inputs,
             Eigen::VectorXd& Y, Eigen::VectorXd& K);
  // x = J^-1 x, with the current factors.
  void apply_inverse(Eigen::Ref<Eigen::VectorXd> x) { system_.solve(x); }

 private:
  Equations& equations_;
  const ErrorNorm& norm_;
  IntegratorStatistics& statistics_;
  StepFailure& failure_;
  ReducedSystem system_;
  double factored_c_ = 0.0;  // c of the factors; 0: none
  bool fresh_ = false, stiff_ = false, turns_ = false;
  // A force is stiff from this (gamma h)^2 K / M on; lower where multipliers may be large, near singular positions.
  static constexpr double kStiff = 20.0, kStiffIfSingular = 9.0;
  const double stiff_from_;
  double stiffness_ = 0.0;                       // (gamma h)^2 stiffness / mass, the largest
  double rate_ = 1.0;                            // last convergence rate
  double slowest_ = 0.0, slowest_before_ = 0.0;  // the largest rate of the stages of this step, and of the step before
  Eigen::VectorXd Ydot_, F_, change_, expected_;
};

}  // namespace footfall
