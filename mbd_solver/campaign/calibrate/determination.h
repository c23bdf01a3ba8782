#pragma once
// How well the targets determine the parameters: to first order about the best set, and without linearity from the sets
// that were run.
//
// With r the weighted residuals, J their derivatives by the positions in the ranges (central differences), m rows that depend
// on a parameter, n parameters:
//
//   C = s2 (J^T J)^-1,   s2 = max(1, Phi / (m - n))          Gauss-Newton
//   interval of u_i:      u_i +- q sqrt(C_ii)
//
// q: of the normal distribution where s2 = 1 (tolerances are taken as standard deviations), of Student's t with m - n where
// the misfit exceeds the tolerances. For m <= n, s2 = 1. Directions that no target determines leave the interval at the
// whole range. On a logarithmic scale the interval is one of factors.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "mbd_solver/campaign/calibrate/evaluations.h"

namespace footfall {

struct Interval {
  double least = 0.0, most = 0.0;  // values, within the range
  double share = 1.0;              // width over the range, 0 to 1
  bool at_edge = false;            // the best value is an end of the range

  // "yes"; "weakly" from a quarter of the range on; "no" from three quarters on.
  std::string is_determined() const;
};

struct Determination {
  Eigen::MatrixXd sensitivity;  // of each target [tolerances per range]; a curve: root mean square over its rows
  std::vector<Interval> intervals;
  Eigen::MatrixXd correlation;
  double scale = 1.0;                  // s2
  int rows = 0;                        // m
  double gain = 0.0;                   // decrease of the misfit by a Gauss-Newton step: large before the search's end
  std::vector<Eigen::VectorXd> loose;  // directions (unit length) that no target determines within the range
};

// The sets for the differences: best + and - step along each parameter, limited to the range.
std::vector<UnitPoint> difference_sets(const CalibrationSpec& spec, const UnitPoint& best);
// `around`: as difference_sets.
Determination determination_of(const CalibrationSpec& spec, const EvaluatedPoint& best, const Sets& around);

// The set near the completely run set that should meet more targets, to first order; complete runs differ from the
// cheaper runs of a search:
//
//   y_t(u) = y_t of the whole runs at u0 + S_t . (u - u0),   least  Phi(y(u)) + |u - u0|^2 / h^2,   |u_i - u0_i| <= h
//
// S: sensitivity from the search's differences, h their step, the range of validity. Bands count kInsideBounds tolerances
// narrower, because a set on a bound is as likely outside as inside. Curves are left out. Returns the set of `whole` when no
// step is better.
constexpr double kInsideBounds = 0.5;  // [tolerances]
UnitPoint adjusted(const CalibrationSpec& spec, const EvaluatedPoint& whole, const Eigen::MatrixXd& sensitivity);

double weight_met(const CalibrationSpec& spec,
                  const EvaluatedPoint& set);  // sum of the weights of the targets it meets
// The set with the largest value; among equals the set with the least misfit.
const EvaluatedPoint* most_met(const CalibrationSpec& spec, const Sets& sets);

// Targets that no set meets, and pairs that some sets meet one by one, but none together.
struct Conflicts {
  std::vector<std::size_t> never;
  struct Pair {
    std::size_t a, b;
    int met_a, met_b;  // number of sets
  };
  std::vector<Pair> pairs;
};
Conflicts conflicts_of(const CalibrationSpec& spec, const Sets& sets);

}  // namespace footfall
