#pragma once
// One step of a diagonally implicit Runge-Kutta method: its stages, solved by Newton's method
// (stage_newton.h), and the errors of the state and of the time integrals of powers.
//   stage i:  known = y + h sum_{j<i} a_ij K_j,   Y_i = known + h gamma K_i,   F(t + c_i h, Y_i, K_i) = 0
//   estimate: e = h sum (b - b^)_i K_i, filtered by the iteration matrix, so that stiff parts do not shrink the step

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/integrator/error_norm.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/integrator/stage_newton.h"
#include "mbd_solver/integrator/tableau.h"

namespace footfall {

// Predicts the rates of a stage from the rates of earlier stages and of the step before.
class RatePredictor {
 public:
  // stages: the smallest number of stages of a method in use; size: of y.
  RatePredictor(int stages, Eigen::Index size);

  bool has_step() const { return h_ > 0.0; }
  double step() const { return h_; }                   // of the last step [s]
  const Tableau* tableau() const { return tableau_; }  // of the last step
  void forget() { h_ = 0.0; }

  // K[stage], for a step h [s].
  void predict(const Tableau& tableau, int stage, double h, std::vector<Eigen::VectorXd>& K) const;
  // After an accepted step: takes the rates of its stages; K[0] becomes the rates of its end.
  void accept(const Tableau& tableau, double h, std::vector<Eigen::VectorXd>& K);

 private:
  std::vector<Eigen::VectorXd> before_;  // rates of the last step: its first stages, then its end
  const Tableau* tableau_ = nullptr;
  double h_ = 0.0;  // 0: no step before
};

// The trial step. A caller that moves to its end makes the last stage the first stage.
struct StepData {
  StepData(const Layout& layout, const Tableau& tableau, int most_stages);

  const Tableau* tableau;
  Eigen::VectorXd y;                 // at its start
  std::vector<Eigen::VectorXd> K;    // rates of the stages, with multipliers at the end
  std::vector<Eigen::VectorXd> Y;    // values of the stages; Y[0] is not used
  std::vector<EnergySample> energy;  // powers at the stages
  std::size_t last() const { return static_cast<std::size_t>(tableau->last()); }
};

class StepStages {
 public:
  // All must outlive this. stages: the smallest number of stages of a method in use.
  StepStages(Equations& equations, const IntegratorOptions& options, int stages, StepData& step,
             IntegratorStatistics& statistics);

  StageNewton& newton() { return newton_; }
  RatePredictor& predictor() { return predictor_; }
  ErrorNorm& norm() { return norm_; }
  StepFailure& failure() { return failure_; }

  // How Newton treats the stages of a step.
  struct Treatment {
    double error_before = 0.0;  // of the step before, 1 = tolerance: how exactly stages must be solved
    double slow = 0.0;          // convergence rate from which a Jacobian is renewed
    bool at_stages = false;     // the Jacobian is renewed at every stage
    bool stiff = false;         // or where a stage converges slowly
  };
  // All stages of a step h from t [s]; false: no convergence.
  bool solve(double t, double h, const Treatment& treatment, const Inputs& inputs);
  double estimated_error(double t, double h);  // 1 = tolerance
  // The same for its time integrals of powers, if work so far [J] has this size.
  double work_error(double t, double h, double work_scale, double state_error, const Inputs& inputs);
  const WorkError& work_error_parts() const { return work_error_; }  // of the last work_error()

 private:
  bool solve_stage(std::size_t i, double t, double h, double tolerance, const Treatment& treatment,
                   const Inputs& inputs);
  double newton_tolerance(double h, double error_before) const;

  Equations& equations_;
  const IntegratorOptions& options_;
  StepData& step_;
  ErrorNorm norm_;
  StepFailure failure_;
  StageNewton newton_;
  RatePredictor predictor_;
  WorkError work_error_;
  double mass_ = 0.0;                      // of all bodies [kg]
  Eigen::VectorXd Ydot_, known_, F_, dx_;  // scratch
};

}  // namespace footfall
