#pragma once
// `css`: the straight path, and the mean over steps 1..n as printed [Lin25 34].

#include "coupler/schemes/constant_load.h"

namespace footfall {

class Css : public ConstantLoadScheme {
 public:
  static constexpr std::string_view kName = "css";
  std::string_view name() const override { return kName; }
  void predict(const BodyMotion& start, double tau, BodyMotion& out) const override;
  StepWeights weights() const override { return {0.0, 1.0}; }
  bool continuous_path() const override { return true; }

 private:
  int path_degree() const override { return 1; }
};

}  // namespace footfall
