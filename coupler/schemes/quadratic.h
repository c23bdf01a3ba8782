#pragma once
// `quadratic`: as css-trapezoid, and half the accelerations times tau^2 in the path.

#include "coupler/schemes/constant_load.h"

namespace footfall {

class Quadratic : public ConstantLoadScheme {
 public:
  static constexpr std::string_view kName = "quadratic";
  std::string_view name() const override { return kName; }
  void predict(const BodyMotion& start, double tau, BodyMotion& out) const override;
  StepWeights weights() const override { return {0.5, 0.5}; }
  bool continuous_path() const override { return true; }

 private:
  int path_degree() const override { return 2; }
};

}  // namespace footfall
