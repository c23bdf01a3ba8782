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

#include "mbd_solver/studies/evaluations.h"

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

// Whole runs differ from the cheap ones of a search: some targets are lost, some are won. The set next to one that was
// run whole which should meet more, to first order:
//
//   y_t(u) = y_t of the whole runs at u0 + S_t . (u - u0),   least  Phi(y(u)) + |u - u0|^2 / h^2,   |u_i - u0_i| <= h
//
// S: derivatives from the search's differences, and h their step: further away they say nothing. Bounds count from kInsideBounds tolerances within, because a set on a bound is
// as likely to be out as in. Curves have no part in it.

constexpr double kInsideBounds = 0.5;  // [tolerances]

// `sensitivity`: of Determination. Equal to the set of `whole` when no step is worth it.
Shares adjusted(const CalibrationSpec& spec, const Evaluation& whole, const Eigen::MatrixXd& sensitivity);

// A part of a calibration's page.

struct PagePart {
  std::string heading;                         // empty: goes on under the one before
  std::string text;                            // before the table
  std::vector<std::vector<std::string>> rows;  // the head first; empty: no table
  std::vector<std::string> pictures;           // PNG files
};

// Which targets come together, from sets that were run: no linearity is taken for granted.

// The set of those given that meets most targets, counted by their weights; the least misfit decides between equals.
const Evaluation* most_met(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets);
// The targets of the largest weight: all, unless some count less.
std::vector<std::size_t> weightiest(const CalibrationSpec& spec);
int met_of(const Evaluation& set, const std::vector<std::size_t>& targets);
// Pairs of targets that some set meets alone, and no set together; and targets that none meets.
struct Apart {
  std::vector<std::size_t> never;
  struct Pair {
    std::size_t a, b;
    int met_a, met_b;  // sets
  };
  std::vector<Pair> pairs;
};
Apart apart(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets);
// So many of the targets can come together at most, as far as these pairs and the targets that none meets tell: the
// largest choice of the others without a pair.
std::size_t most_without_a_pair(const Apart& apart, const std::vector<std::size_t>& targets);
// The same as sentences, and a table of the pairs.
PagePart apart_part(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets);

}  // namespace footfall
