#pragma once
// A fuzzy system computed once on a grid over its four inputs and then only interpolated (multilinear): "computed offline, fast
// real-time implementation" [Lin25 section 2.2.2].

#include <vector>

#include "mbd_solver/model/controllers/fuzzy.h"

namespace footfall {

using FuzzyGrid = std::array<int, kFuzzyInputs>;        // points along a, da, alpha, beta, each >= 2
constexpr FuzzyGrid kDefaultFuzzyGrid = {31, 13, 17, 17};

class FuzzyTable {
 public:
  FuzzyTable(const FuzzySystem& system, const FuzzyGrid& grid);  // throws InputError for a grid below 2 or too large

  int output_count() const { return outputs_; }
  void evaluate(const FuzzyInput& input, Eigen::Ref<Eigen::VectorXd> voltages) const;  // clamps the inputs

  // Largest |table - system| over all outputs at `samples` random points of the input box (seeded: the same every time).
  double largest_difference(const FuzzySystem& system, int samples = 2000) const;

 private:
  FuzzyGrid grid_;
  FuzzyInput lower_, upper_;
  int outputs_;
  std::vector<double> values_;  // [a][da][alpha][beta][output]
};

}  // namespace footfall
