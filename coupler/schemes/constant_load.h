#pragma once
// Schemes under which a body carries the mean load of the grains during the window and nothing else: css-trapezoid, css,
// quadratic and frozen. They differ in the predicted path and in the weights of the mean.

#include "coupler/schemes/scheme.h"

namespace footfall {

class ConstantLoadScheme : public Scheme {
 public:
  std::string_view name() const override { return name_; }
  void predict(const BodyMotion& start, double tau, BodyMotion& out) const override;
  StepWeights weights() const override { return weights_; }
  bool continuous_path() const override { return path_degree_ > 0; }
  bool requires_tangent() const override { return false; }
  // The path has the rates of the computed state.
  void set_path_rates(const Matrix6d&, const BodyLoad&, double, BodyMotion&) const override {}
  std::optional<TangentLoad> reaction(const Matrix6d&, const BodyLoad&, const PredictedPath&, double) const override {
    return std::nullopt;
  }
  // By the mean loads of this window and of the previous one, extrapolated to the end of the window.
  double pending_work(const AnsweredLoads& loads, const PredictedPath& path, const BodyMotion& computed) const override;

  // f is the mean over the window of -K s(tau), tau = i/n:
  //   f = -K (x + mean_tau v + mean_tau2 a / 2 + mean_gap (s - x))
  //   x' = x + v + f/2,  v' = v + f,  a' = f
  MapState window_map(double omega_h, int n, const MapState& z) const override;

 protected:
  // path_degree: highest power of tau in the path: 0 at rest, 1 with velocity, 2 with acceleration.
  ConstantLoadScheme(std::string_view name, int path_degree, StepWeights weights)
      : name_(name), path_degree_(path_degree), weights_(weights) {}

 private:
  std::string_view name_;
  int path_degree_;
  StepWeights weights_;
};

// `css-trapezoid`: the straight path, and the mean whose impulse velocity Verlet applies. The default.
struct CssTrapezoid : ConstantLoadScheme {
  static constexpr std::string_view kName = "css-trapezoid";
  CssTrapezoid() : ConstantLoadScheme(kName, 1, {0.5, 0.5}) {}
};

// `css`: the straight path, and the mean over steps 1..n as published [Lin25 35].
struct Css : ConstantLoadScheme {
  static constexpr std::string_view kName = "css";
  Css() : ConstantLoadScheme(kName, 1, {0.0, 1.0}) {}
};

// `quadratic`: as css-trapezoid, with half the accelerations times tau^2 in the path.
struct Quadratic : ConstantLoadScheme {
  static constexpr std::string_view kName = "quadratic";
  Quadratic() : ConstantLoadScheme(kName, 2, {0.5, 0.5}) {}
};

// `frozen`: the boundary rests in its pose at t_k during the whole window. For teaching and tests only: it creates
// energy.
struct Frozen : ConstantLoadScheme {
  static constexpr std::string_view kName = "frozen";
  Frozen() : ConstantLoadScheme(kName, 0, {0.5, 0.5}) {}
};

}  // namespace footfall
