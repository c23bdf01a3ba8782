#pragma once
// Rates at the start of a step, K[0] with multipliers: the rates at the end of the last step, unless the
// window is another one. A window that continues the last window starts from its rates, corrected for
// the change of loads with existing factors of the saddle matrix.

#include <limits>

#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/step_stages.h"

namespace footfall {

class StartRates {
 public:
  // All must outlive this.
  StartRates(Equations& equations, const IntegratorOptions& options, StepData& step, ErrorNorm& norm,
             IntegratorStatistics& statistics);

  // y, K[0] and energy[0] of the step under the loads of this window; true: they are new.
  void start_window(const Inputs& inputs, const State& state);
  void renew(const Inputs& inputs, const State& state);  // likewise, whatever was before
  // Before a step from t [s]: multipliers of K[0] belong to the present resting rows.
  void follow_resting_rows(double t);
  void keep_resting_rows() { resting_row_changes_ = equations_.saddle().resting_row_changes(); }
  // At the end of a window: rates with the smallest multipliers.
  void end_window(const State& state);
  const Eigen::VectorXd& at_window_end() const { return rates_; }
  void forget() { left_time_ = -std::numeric_limits<double>::infinity(); }

 private:
  bool follow(const Inputs& inputs, const State& state);  // K[0] from K[0] of the previous window
  void pack(const Inputs& inputs, const State& state);    // y and energy[0], with K[0]

  Equations& equations_;
  const IntegratorOptions& options_;
  StepData& step_;
  ErrorNorm& norm_;
  IntegratorStatistics& statistics_;
  long resting_row_changes_ = 0;                                 // to which the multipliers of K[0] belong
  Eigen::VectorXd rates_;                                        // at the end of the last window,
  Eigen::VectorXd left_;                                         // y there, without drift,
  double left_time_ = -std::numeric_limits<double>::infinity();  // and its time [s]
  Eigen::VectorXd change_;                                       // scratch
};

}  // namespace footfall
