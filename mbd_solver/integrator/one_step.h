#pragma once
// Diagonally implicit Runge-Kutta methods with an explicit first stage (tableau.h): one step,
// L-stable, stiffly accurate. The default, because a new window with another load costs neither
// order nor additional steps. Stages and estimate are in step_stages.h, rates at the start in
// start_rates.h, states within a step in dense_step.h. This file controls the steps:
// their length follows from the estimate, and passes over singular positions (singular_position.h).
// Windows that one step does not fill may use a method of higher order
// (IntegratorOptions::window_order, MethodChoice).

#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/turn_follower.h"
#include "mbd_solver/integrator/dense_step.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/integrator/singular_position.h"
#include "mbd_solver/integrator/start_rates.h"
#include "mbd_solver/integrator/step_control.h"
#include "mbd_solver/integrator/step_stages.h"
#include "mbd_solver/integrator/tableau.h"

namespace footfall {

class OneStep : public Integrator {
 public:
  OneStep(Equations& equations, const IntegratorOptions& options);

  std::string name() const override { return "one_step"; }
  void begin(State& state, double t_end, const Inputs& inputs, const WindowStops& stops) override;
  WindowStop next() override;
  void end_window() override { window_.ended = true; }
  const Eigen::VectorXd& end_rates() const override { return start_.at_window_end(); }
  void forget() override;
  const IntegratorStatistics& statistics() const override { return statistics_; }
  std::string warning() const override;
  void resume(const IntegratorStatistics& so_far) override {
    forget();
    statistics_ = so_far;
  }

 private:
  enum class Outcome { kAccepted, kTooInaccurate, kNoConvergence };
  // The end of the step that is tried, without drift.
  struct CleanEnd {
    State state;
    Drift drift;        // removed there
    bool used = false;  // the next step begins at it
  };
  // The window that is open, with the step that has been accepted in it.
  struct Window {
    enum Phase { kTrying, kInRows, kAtRow, kAtEnd };
    Phase phase = kTrying;
    State* state = nullptr;
    double t_end = 0.0;  // [s]
    const Inputs* inputs = nullptr;
    WindowStops stops;
    ProgressWatch watch{0.0, 0.0};
    double required = 0.0;  // the next step as accuracy alone requires [s]
    bool diverged = false;  // Newton, in the last try
    bool ended = false;     // at a row or step
    double h = 0.0;         // [s]
    double change = 0.0;    // when a mode changes in it; HUGE_VAL: none
    double reached = 0.0;   // rows until then belong to it [s]
    double row_time = 0.0;  // of the next row [s]
    bool switched = false;  // a mode changed at the end of the step
  };
  // The view of the accepted step.
  class View : public StepView {
   public:
    explicit View(OneStep& steps) : steps_(steps) {}
    double begin() const override;
    double end() const override;
    void at(double time, State& state, Eigen::VectorXd& rates) override;

   private:
    OneStep& steps_;
  };

  // The step with the current Jacobian; if Newton fails, with the Jacobian at its start, then with the
  // Jacobians of its stages.
  Outcome try_with_newer_jacobians(double t, double h, const Inputs& inputs);
  // From step_.y and K[0] to the last Y; sets errors_.last. at_stages: the Jacobian is renewed at
  // every stage.
  Outcome try_step(double t, double h, bool at_stages, const Inputs& inputs);
  bool close_end(double t);             // end_, if it is to be used; false: projection would remove energy
  bool try_next_step();                 // false: it was not accepted
  void accept(double h, double t_new);  // advances the state to the end of the step, without its angles
  WindowStop read_row();
  void stay_at_row();  // which ends the window
  void reach_end();    // of the step, or where a mode changes in it
  void leave_end();    // begins the next step there
  void finish_step();
  void finish_window();
  void start_clean(const Inputs& inputs, State& state);   // without drift, with new rates
  void switch_modes(const Inputs& inputs, State& state);  // at the change of a mode; begins the next step
  // After a failed step: true if another step than a shorter one is to be tried.
  bool finds_another_step(double h, double planned, const Inputs& inputs, State& state);
  void look_ahead(const State& state);
  double planned_step(double t, double h) const {
    return crossing_.planned_step(*step_.tableau, t, h, options_.max_step);
  }
  double first_step();               // [s]
  double next_step(double h) const;  // after a step h of error errors_.last
  [[noreturn]] void give_up(const MessageCode& code, double t, const std::string& what);

  // Convergence rate above which the Jacobian is renewed before the next step. It pays earlier for
  // methods with many stages; a mechanism that may pass singular positions keeps it longer, because
  // the rate drops there in any case.
  static constexpr double kSlow = 0.2, kSlowForManyStages = 0.05;
  static constexpr int kManyStages = 4;
  double slow() const { return step_.tableau->stages < kManyStages || may_be_singular_ ? kSlow : kSlowForManyStages; }

  Equations& equations_;
  IntegratorOptions options_;
  const Tableau &usual_, &high_;  // the latter in windows selected by choice_
  MethodChoice choice_;
  IntegratorStatistics statistics_;
  StepData step_;  // that is tried
  StepStages stages_;
  StartRates start_;
  DenseStep dense_;
  SingularCrossing crossing_;
  TurnFollower turns_;
  TurnFollower::Motion turning_, turning_next_;  // at the start and the end of the step
  bool may_be_singular_;                         // there are redundant conditions
  CleanEnd end_;
  Window window_;
  View view_{*this};
  struct Errors {           // 1 = tolerance
    double last = 0.0;      // of the last step
    double before = 0.0;    // of the step before
    double of_state = 0.0;  // of the last step, of q, v and z alone
    double limit = 1.0;     // of the step that is tried
  } errors_;
  Eigen::VectorXd change_;  // scratch
};

}  // namespace footfall
