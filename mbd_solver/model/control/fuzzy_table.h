#pragma once
// Fuzzy systems on a grid: the fast evaluation of plain Mamdani systems, and the table of outputs made with it.

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "mbd_solver/model/control/fuzzy.h"

namespace footfall {

// A plain Mamdani system (min for "and" and implication, max for aggregation, centroid). Its results equal the
// results of the general engine; memberships are computed once per node of an axis and once per sample of an output,
// which takes about 1 us per point instead of 180.
struct MamdaniRule {
  std::array<int, 4> term;                   // of each input; -1: the rule does not use this input
  double weight;                             // [-]
  std::vector<std::array<int, 2>> outcomes;  // output, its term
};

struct MamdaniOutput {
  double low, high;            // range
  double value_without_rule;   // if no rule fires
  Eigen::MatrixXd membership;  // samples of the centroid (midpoints of equal parts of the range) x terms
};

struct MamdaniSystem {
  std::vector<MamdaniRule> rules;
  std::vector<MamdaniOutput> outputs;
};

// axis[i]: nodes x terms, memberships of input i at its nodes. Returns [node 0][node 1][node 2][node 3][output].
std::vector<double> evaluate_on_grid(const MamdaniSystem& system, const std::array<Eigen::MatrixXd, 4>& axis);

using FuzzyGrid = std::array<int, kFuzzyInputs>;           // points along a, da, alpha, beta, each >= 2
constexpr FuzzyGrid kDefaultFuzzyGrid = {49, 17, 33, 33};  // 907 137 points, 29 MB for four outputs

// A fuzzy system computed once on a grid over its four inputs, then interpolated (multilinear): "computed offline, fast
// real-time implementation" [Lin25 section 2.2.2].
// Grid: the points of an axis are distributed over the intervals between the corners of the input's terms, where the outputs
// have kinks, and are denser towards them (mean of even and cosine spacing). Intervals with the same, even number of points
// are best, because kinks of min(., .) then pass through corners of cells. The default has 16 each for
// inputs/controllers/lander.fll.
class FuzzyTable {
 public:
  // Throws InputError if the grid is too large, or has fewer points along an input than its terms have corners.
  FuzzyTable(const FuzzySystem& system, const FuzzyGrid& grid);

  int output_count() const { return outputs_; }
  void evaluate(const FuzzyInput& input, Eigen::Ref<Eigen::VectorXd> voltages) const;  // clamps the inputs

  // Largest |table - system| over all outputs at `samples` random points of the input box (fixed seed).
  double largest_difference(const FuzzySystem& system, int samples = 2000) const;

 private:
  std::array<Eigen::VectorXd, kFuzzyInputs> nodes_;
  int outputs_;
  std::vector<double> values_;  // [a][da][alpha][beta][output]
};

}  // namespace footfall
