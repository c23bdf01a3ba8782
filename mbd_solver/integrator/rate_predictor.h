#pragma once
// Predicts the rates of a stage from the rates of earlier stages and of the step before.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/integrator/tableau.h"

namespace footfall {

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

}  // namespace footfall
