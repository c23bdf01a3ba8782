#pragma once
// Diagonally implicit Runge-Kutta methods with an explicit first stage (tableau.h): one step, L-stable, stiffly accurate. The
// default, because a new window with another load costs neither order nor additional steps.
//   stage i:  known = y + h sum_{j<i} a_ij K_j,   Y_i = known + h gamma K_i,   F(t + c_i h, Y_i, K_i) = 0
//   estimate: e = h sum (b - b^)_i K_i, filtered by the iteration matrix, so that stiff parts do not shrink the step
// Newton's method solves the stages (stage_newton.h); the step length follows from the estimate, and passes over singular
// positions (singular_position.h). Windows that one step does not fill may use a method of higher order
// (IntegratorOptions::window_order, MethodChoice).

#include <limits>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/turn_follower.h"
#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/integrator/rate_predictor.h"
#include "mbd_solver/integrator/singular_position.h"
#include "mbd_solver/integrator/stage_newton.h"
#include "mbd_solver/integrator/step_control.h"
#include "mbd_solver/integrator/tableau.h"

namespace footfall {

class OneStep : public Integrator {
 public:
  OneStep(Equations& equations, const IntegratorOptions& options);

  std::string name() const override { return "one_step"; }
  void advance(State& state, double t_end, const Inputs& inputs, const Rows& rows) override;
  const Eigen::VectorXd& end_rates() const override { return rates_; }
  void forget() override;
  const IntegratorStatistics& statistics() const override { return statistics_; }
  std::string warning() const override;
  void resume(const IntegratorStatistics& so_far) override {
    forget();
    statistics_ = so_far;
  }

 private:
  enum class Outcome { kAccepted, kTooInaccurate, kNoConvergence };

  // The step with the current Jacobian; if Newton fails, with one at its start, then with those of its stages.
  Outcome try_with_newer_jacobians(double t, double h, const Inputs& inputs);
  Outcome try_step(double t, double h, const Inputs& inputs);   // from y_, K_[0] to the last Y_; sets error_
  double estimated_error(double t, double h);                   // of the step that is tried, 1 = tolerance
  double work_error(double t, double h, const Inputs& inputs);  // the same of its time integrals of powers
  std::size_t last() const { return static_cast<std::size_t>(tableau_->last()); }
  // y_, K_[0] and energy_[0] under the loads of this window.
  void start_window(const Inputs& inputs, const State& state);
  bool follow_rates(const Inputs& inputs, const State& state);  // K_[0] from that of the previous window
  bool close_end(double t);  // end_ without drift, if it is to be used; false: projection would remove energy
  // Advances the state and reports the rows on the way; false: one of them has ended the window.
  bool accept(double h, double t_new, double t_end, const Inputs& inputs, const Rows& rows, State& state);
  void start_clean(const Inputs& inputs, State& state);        // without drift, with new rates
  void renew_rates(const Inputs& inputs, const State& state);  // y_, K_[0] and energy_[0]
  class View;                                                  // of the step that has been accepted
  void interpolate(double time, double h);                     // row_ and row_rates_, within the step h from start_
  double time_of_switch(double h, double end, const Inputs& inputs);  // in the step h from start_ [s]; infinity: none
  void switch_modes(const Inputs& inputs, State& state);              // at the change of a mode; begins the next step
  // After a failed step: true if another step than a shorter one is to be tried.
  bool finds_another_step(double h, double planned, const Inputs& inputs, State& state);
  void look_ahead(const State& state);
  double planned_step(double t, double h) const { return crossing_.planned_step(*tableau_, t, h, options_.max_step); }
  double first_step();               // [s]
  double next_step(double h) const;  // after a step h of error error_
  [[noreturn]] void give_up(const MessageCode& code, double t, const std::string& what) const;

  // Convergence rate above which the Jacobian is renewed before the next step. It pays earlier for methods with many stages; a
  // mechanism that may pass singular positions keeps it longer, because the rate drops there in any case.
  static constexpr double kSlow = 0.2, kSlowForManyStages = 0.05;
  static constexpr int kManyStages = 4;
  double slow() const { return tableau_->stages < kManyStages || may_be_singular_ ? kSlow : kSlowForManyStages; }

  Equations& equations_;
  IntegratorOptions options_;
  const Tableau &usual_, &high_;  // the latter in windows selected by choice_
  MethodChoice choice_;
  const Tableau* tableau_;  // of the step that is tried
  IntegratorStatistics statistics_;
  ErrorNorm norm_;
  StepFailure failure_;
  StageNewton newton_;
  RatePredictor predictor_;
  SingularCrossing crossing_;
  TurnFollower turns_;
  TurnFollower::Motion turning_, turning_next_;  // at the start and the end of the step
  bool at_stages_ = false;                       // the Jacobian is renewed at every stage
  bool may_be_singular_;                         // there are redundant conditions
  double error_ = 0.0;                           // of the last step, 1 = tolerance
  double error_before_ = 0.0;                    // of the step before
  double limit_ = 1.0;                           // of error_ in the step that is tried
  long resting_row_changes_ = 0;                 // to which the multipliers of K_[0] belong

  Eigen::VectorXd y_;                                            // at the start of the step
  std::vector<Eigen::VectorXd> K_;                               // rates of the stages, with multipliers at the end
  std::vector<Eigen::VectorXd> Y_;                               // values of the stages; Y_[0] is not used
  std::vector<EnergySample> energy_;                             // powers at the stages
  WorkError step_error_;                                         // of the time integrals, in this step
  double work_scale_ = 0.0;                                      // of the run so far [J]
  double state_error_ = 0.0;                                     // of y in the step that is tried, 1 = tolerance
  Eigen::VectorXd rates_;                                        // at the end of the last window,
  Eigen::VectorXd left_;                                         // y there, without drift,
  double left_time_ = -std::numeric_limits<double>::infinity();  // and its time [s]
  State start_before_, start_;                                   // at the starts of the last two steps
  State end_;                                                    // of the step that is tried, without drift
  Drift end_drift_;                                              // removed there
  bool closed_ = false;                                          // end_ is to be used
  bool switched_ = false;                                        // a mode changed at the end of the last step
  State row_;
  Eigen::VectorXd row_rates_;
  double row_time_ = 0.0;                           // of the next row [s]
  Eigen::VectorXd Ydot_, known_, F_, change_, dx_;  // scratch
};

}  // namespace footfall
