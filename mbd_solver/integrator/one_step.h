#pragma once
// TR-BDF2 as a diagonally implicit Runge-Kutta method: one step, second order, L-stable, stiffly accurate,
// first stage explicit (Hosea and Shampine 1996). A new window with another load costs it neither order nor
// steps, which is why it is the default.
//   gamma = 1 - sqrt(2)/2,  w = sqrt(2)/4,  c = (0, 2 gamma, 1),  b = (w, w, gamma)
//   embedded third-order weights ((1-w)/3, (3w+1)/3, gamma/3) estimate the error; the estimate is filtered by
//   the iteration matrix, so that stiff parts do not shrink the step.
// A stage with rates K_i: y_i = known + h gamma K_i, F(t_i, y_i, K_i) = 0. Positions follow from velocities
// in closed form, so Newton iterates [v; z; lambda] alone, with the reduced Jacobian at c = 1 / (h gamma).
// Multipliers have no rates. The Jacobian and its factors are kept while Newton converges fast.

#include "mbd_solver/dynamics/sparse_lu.h"
#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/integrator.h"

namespace footfall {

class OneStep : public Integrator {
 public:
  OneStep(Equations& equations, const IntegratorOptions& options);

  std::string name() const override { return "one_step"; }
  void advance(State& state, double t_end, const Inputs& inputs) override;
  const Eigen::VectorXd& end_rates() const override { return rates_; }
  void forget() override;
  const IntegratorStatistics& statistics() const override { return statistics_; }

 private:
  enum class Outcome { kAccepted, kTooInaccurate, kNoConvergence };

  Outcome try_step(double t, double h, const Inputs& inputs);  // from y_, K_[0] to Y_[1]; leaves error_
  bool solve_stage(int stage, double t, double h, const Inputs& inputs);
  bool refresh(double t, double c, const Inputs& inputs);  // Jacobian at Y_[stage] and its factors
  void accept(double t, double h, const Inputs& inputs, State& state);
  void remove_drift(double t, State& state);  // from y_
  [[noreturn]] void give_up(double t) const;

  Equations& equations_;
  IntegratorOptions options_;
  IntegratorStatistics statistics_;
  ErrorNorm norm_;
  std::unique_ptr<SparseLu> lu_;
  double factored_c_ = 0.0;  // c of the factors, 0: none
  bool fresh_ = false;       // the Jacobian belongs to this step
  double rate_ = 1.0;        // last convergence rate of Newton
  double error_ = 0.0;       // of the last step, 1 = tolerance
  int worst_ = -1;           // entry of y that failed last
  std::string complaint_;    // of a force law that had no value

  Eigen::VectorXd y_;     // at the start of the step
  Eigen::VectorXd K_[3];  // rates of the stages; multipliers in the tail
  Eigen::VectorXd Y_[2];  // values of the two implicit stages
  Eigen::VectorXd Ydot_, known_, F_, change_, dx_, rates_;
  EnergySample energy_[3];  // powers at the stages
};

}  // namespace footfall
