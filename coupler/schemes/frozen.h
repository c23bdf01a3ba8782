#pragma once
// `frozen`: the boundary rests in its pose at t_k during the whole window. For teaching and tests only: it pumps
// energy.

#include "coupler/schemes/constant_load.h"

namespace footfall {

class Frozen : public ConstantLoadScheme {
 public:
  static constexpr std::string_view kName = "frozen";
  std::string_view name() const override { return kName; }
  void predict(const BodyMotion& start, double tau, BodyMotion& out) const override;
  StepWeights weights() const override { return {0.5, 0.5}; }
  bool continuous_path() const override { return false; }

 private:
  int path_degree() const override { return 0; }
};

}  // namespace footfall
