#pragma once
// What the targets say about the parameters, to first order about the best set. With r the weighted residuals, J their
// derivatives by the shares of the ranges (central differences), m rows that depend on a parameter, n parameters:
//
//   C = s2 (J^T J)^-1,   s2 = max(1, Phi / (m - n))          Gauss-Newton
//   interval of share i:  u_i +- q sqrt(C_ii)
//
// q: of the normal distribution where s2 = 1 (tolerances are believed), of Student's t with m - n where the misfit is
// larger than tolerances allow. For m <= n, s2 = 1. Directions that no target feels leave the interval at the whole
// range. On a logarithmic scale the interval is one of factors.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "mbd_solver/cli/calibrate/evaluations.h"

namespace footfall {

struct Interval {
  double least = 0.0, most = 0.0;  // values, within the range
  double share = 1.0;              // of the range that it takes, 0 to 1
  bool at_edge = false;            // the best value is an end of the range

  // "yes"; "weakly" from a quarter of the range on; "no" from three quarters on.
  std::string is_determined() const;
};

struct Determination {
  Eigen::MatrixXd jacobian;     // rows as Evaluation::residuals, one column per parameter
  Eigen::MatrixXd sensitivity;  // of each target [tolerances per range]; a curve: root mean square over its rows
  std::vector<Interval> intervals;
  Eigen::MatrixXd correlation;
  double scale = 1.0;                  // s2
  int rows = 0;                        // m
  double gain = 0.0;                   // of the misfit, by a Gauss-Newton step: large where the search has not ended
  std::vector<Eigen::VectorXd> loose;  // directions (shares, unit length) that nothing holds within the range
};

// The sets to be run for it: best + and - step along each parameter, cut at the range.
std::vector<Shares> difference_sets(const CalibrationSpec& spec, const Shares& best);
// `around`: as difference_sets.
Determination determination_of(const CalibrationSpec& spec, const Evaluation& best,
                               const std::vector<const Evaluation*>& around);

// To meet one target by the smallest step that does it to first order, and what that costs others.
struct Pull {
  std::size_t target = 0;
  bool felt = false;                                  // some parameter moves it
  Eigen::VectorXd step;                               // shares
  std::vector<std::pair<std::size_t, double>> costs;  // target, rise of |r| [tolerances], from 0.5 on, largest first
};
// Of the targets that are single numbers and not met.
std::vector<Pull> pulls_of(const CalibrationSpec& spec, const Evaluation& best,
                           const std::vector<const Evaluation*>& around);

// x that a standard normal variable exceeds with probability (1 - confidence) / 2.
double normal_quantile(double confidence);

}  // namespace footfall
