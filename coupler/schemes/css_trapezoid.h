#pragma once
// `css-trapezoid`: the straight path, and the impulse that velocity Verlet really applies. The default.

#include "coupler/schemes/constant_load.h"

namespace footfall {

class CssTrapezoid : public ConstantLoadScheme {
 public:
  static constexpr std::string_view kName = "css-trapezoid";
  std::string_view name() const override { return kName; }
  void predict(const BodyMotion& start, double tau, BodyMotion& out) const override;
  StepWeights weights() const override { return {0.5, 0.5}; }
  bool continuous_path() const override { return true; }

 private:
  int path_degree() const override { return 1; }
};

}  // namespace footfall
