#pragma once
// A plain Mamdani system (min for "and" and implication, max for aggregation, centroid) evaluated on all
// points of a grid over its four inputs. The numbers are those of the general engine; only the order of work
// differs: memberships are looked up once per node of an axis and once per sample of an output, which takes
// about 1 us per point instead of 180.

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace footfall {

struct MamdaniRule {
  std::array<int, 4> term;                   // of each input, -1: the rule does not ask for this input
  double weight;                             // [-]
  std::vector<std::array<int, 2>> outcomes;  // output, its term
};

struct MamdaniOutput {
  double low, high;            // range
  double value_without_rule;   // when no rule fires
  Eigen::MatrixXd membership;  // samples of the centroid (midpoints of equal parts of the range) x terms
};

struct MamdaniSystem {
  std::vector<MamdaniRule> rules;
  std::vector<MamdaniOutput> outputs;
};

// axis[i]: nodes x terms, memberships of input i at its nodes. Answers [node 0][node 1][node 2][node
// 3][output].
std::vector<double> evaluate_on_grid(const MamdaniSystem& system, const std::array<Eigen::MatrixXd, 4>& axis);

}  // namespace footfall
