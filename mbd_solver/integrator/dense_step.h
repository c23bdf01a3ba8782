#pragma once
// The continuous extension of a step that has been accepted (DenseWeights): states within it, and
// where a mode changes.

#include "mbd_solver/integrator/step_stages.h"

namespace footfall {

class DenseStep {
 public:
  // Both must outlive this.
  DenseStep(Equations& equations, const StepData& step);

  // An accepted step of length h [s], from this state; the step before remains known.
  void begin(const State& start, double h);
  void forget();

  const State& start() const { return start_; }
  const State& start_before() const { return start_before_; }  // of the step before
  // State and rates at a time [s] in the step, without projection; valid until the next call.
  State& at(double time);
  const State& state() const { return state_; }
  Eigen::VectorXd& rates() { return rates_; }
  // The first change of a mode, in the middle or the end of the step [s]; HUGE_VAL: none.
  double time_of_switch(double end, const Inputs& inputs);

 private:
  Equations& equations_;
  const StepData& step_;
  State start_before_, start_;  // at the starts of the last two steps
  double h_ = 0.0;              // [s]
  State state_;
  Eigen::VectorXd rates_, known_;
};

}  // namespace footfall
