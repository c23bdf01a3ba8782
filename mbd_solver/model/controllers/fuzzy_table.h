#pragma once
// A fuzzy system computed once on a grid over its four inputs and then only interpolated (multilinear):
// "computed offline, fast real-time implementation" [Lin25 section 2.2.2].
//
// Grid: the points of an axis are shared out over the intervals between the corners of the input's terms,
// where the voltages have kinks, and stand closer towards them: at the mean of even and cosine spacing.
// Intervals with the same, even number of points are best: the kinks of min(., .) then run through the
// corners of cells. The default does that for inputs/controllers/lander.fll (16 each).

#include <vector>

#include "mbd_solver/model/controllers/fuzzy.h"

namespace footfall {

using FuzzyGrid = std::array<int, kFuzzyInputs>;           // points along a, da, alpha, beta, each >= 2
constexpr FuzzyGrid kDefaultFuzzyGrid = {49, 17, 33, 33};  // 907 137 points, 29 MB for four outputs

class FuzzyTable {
 public:
  // Throws InputError for a grid that is too large, or has fewer points along an input than its terms have
  // corners.
  FuzzyTable(const FuzzySystem& system, const FuzzyGrid& grid);

  int output_count() const { return outputs_; }
  void evaluate(const FuzzyInput& input, Eigen::Ref<Eigen::VectorXd> voltages) const;  // clamps the inputs

  // Largest |table - system| over all outputs at `samples` random points of the input box (seeded: the same
  // every time).
  double largest_difference(const FuzzySystem& system, int samples = 2000) const;

 private:
  std::array<Eigen::VectorXd, kFuzzyInputs> nodes_;
  int outputs_;
  std::vector<double> values_;  // [a][da][alpha][beta][output]
};

}  // namespace footfall
