#pragma once
// Diagonally implicit Runge-Kutta methods with an explicit first stage (tableau.h): one step, L-stable, stiffly accurate.
// A new window with another load costs them neither order nor steps, which is why they are the default.
//   stage i:  known = y + h sum_{j<i} a_ij K_j,   Y_i = known + h gamma K_i,   F(t + c_i h, Y_i, K_i) = 0
//   estimate: e = h sum (b - b^)_i K_i, filtered by the iteration matrix, so that stiff parts do not shrink the step
// Positions follow from velocities in closed form, so Newton iterates [v; z; lambda] alone, with the reduced Jacobian at
// c = 1 / (h gamma). Multipliers have no rates. The Jacobian and its factors are kept while Newton converges fast.
// Newton stops when what it leaves is small beside the error of the step itself (as the step before lets expect), so that
// smaller steps have smaller errors although there are more of them.
//
// Windows that one step does not fill may go by a method of higher order (IntegratorOptions::window_order,
// method_choice.h).

#include <limits>
#include <vector>

#include "mbd_solver/dynamics/sparse_lu.h"
#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/integrator/method_choice.h"
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

  // The step with the Jacobian that there is; where Newton fails with that of its start, then with those of its stages.
  Outcome try_with_newer_jacobians(double t, double h, const Inputs& inputs);
  Outcome try_step(double t, double h, const Inputs& inputs);  // from y_, K_[0] to the last Y_; leaves error_
  void predict(int stage, double h);                           // K_[stage]
  std::size_t last() const { return static_cast<std::size_t>(tableau_->last()); }
  bool solve_stage(int stage, double t, double h, const Inputs& inputs);
  // Jacobian at y with rates K, and its factors.
  bool refresh(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& K, double c, const Inputs& inputs);
  // y_, K_[0] and energy_[0] under the loads of this window.
  void start_window(const Inputs& inputs, const State& state);
  bool follow_rates(const Inputs& inputs, const State& state);  // K_[0] from that of the window before
  bool close_end(double t);  // end_ where it is to be taken; false: projection would take energy away
  // Moves state on, gives the rows on the way; false: one of them has ended the window.
  bool accept(double t, double h, double t_new, double t_end, const Inputs& inputs, const Rows& rows, State& state);
  void start_clean(const Inputs& inputs, State& state);        // without drift, rates anew
  void renew_rates(const Inputs& inputs, const State& state);  // y_, K_[0] and energy_[0]
  void interpolate(double time, double h);                     // row_ and row_rates_, within the step h from start_
  double predictor_time(std::size_t k) const;                  // of before_[k] within its step
  // Singular positions. After a step that failed: true where another than a shorter one is to be tried.
  bool finds_another_step(double h, double planned, const Inputs& inputs, State& state);
  void look_ahead(const State& state);            // singular_time_ from the last two steps
  double planned_step(double t, double h) const;  // h, or one with which no stage is near a singular position
  double first_step();                            // [s]
  double next_step(double h) const;               // after a step h of error error_
  [[noreturn]] void give_up(double t, const std::string& what) const;

  // Convergence rate above which the Jacobian is renewed before the next step. It pays earlier where a step has many stages;
  // a mechanism that may pass singular positions keeps it longer, as there the rate falls off by itself.
  static constexpr double kSlow = 0.2, kSlowForManyStages = 0.05;
  static constexpr int kManyStages = 4;
  double slow() const { return tableau_->stages < kManyStages || may_be_singular_ ? kSlow : kSlowForManyStages; }

  Equations& equations_;
  IntegratorOptions options_;
  const Tableau &usual_, &high_;  // the latter in windows where choice_ says so
  MethodChoice choice_;
  const Tableau* tableau_;  // of the step that is tried
  IntegratorStatistics statistics_;
  ErrorNorm norm_;
  ThinLu lu_;
  double factored_c_ = 0.0;        // c of the factors, 0: none
  bool fresh_ = false;             // the Jacobian belongs to this step
  bool at_stages_ = false;         // it is renewed at every stage
  bool may_be_singular_;           // conditions of joints follow from others
  double rate_ = 1.0;              // last convergence rate of Newton
  double error_ = 0.0;             // of the last step, 1 = tolerance
  double newton_tolerance_ = 0.0;  // of the step that is tried
  long rest_choices_ = 0;          // those that the multipliers of K_[0] belong to
  int worst_ = -1;                 // entry of y that failed last
  std::string complaint_;          // of a force law that had no value

  Eigen::VectorXd y_;               // at the start of the step
  std::vector<Eigen::VectorXd> K_;  // rates of the stages; multipliers in the tail; as many as any method has
  std::vector<Eigen::VectorXd> Y_;  // values of the stages; Y_[0] is not used
  Eigen::VectorXd left_;            // y at the end of the last window, without drift
  double left_time_ = -std::numeric_limits<double>::infinity();  // its time [s]
  Eigen::VectorXd Ydot_, known_, F_, change_, dx_, rates_, expected_;
  std::vector<EnergySample> energy_;  // powers at the stages

  std::vector<Eigen::VectorXd> before_;      // rates of the last step: its first stages, then its end
  const Tableau* tableau_before_ = nullptr;  // that of the last step
  double h_before_ = 0.0;                    // 0: no step before
  double error_before_ = 0.0;                // its error, 1 = tolerance

  State start_before_, start_, row_, end_;  // at the start of a step, in it, and at its end without drift
  Drift end_drift_;              // what was removed there
  bool closed_ = false;                     // end_ is to be taken
  int trouble_ = 0, careful_ = 0;           // failures of late; steps that go on without drift
  double singular_time_ = std::numeric_limits<double>::infinity();  // where a singular position is expected [s],
  double looked_time_ = std::numeric_limits<double>::quiet_NaN();   // as it was seen from there; NaN: not known
  double limit_ = 1.0;                                              // of error_ in the step that is tried
  int crossings_ = 0;                                               // steps over it that have failed
  Eigen::VectorXd row_rates_;
  double row_time_ = 0.0;  // of the next row [s]
};

}  // namespace footfall
