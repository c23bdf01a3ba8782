#pragma once
// Schemes under which a body carries the mean load of the grains during the window and nothing else: css-trapezoid, css,
// quadratic and frozen. They differ in the predicted path and in the weights of the mean.

#include "coupler/schemes/scheme.h"

namespace footfall {

class ConstantLoadScheme : public Scheme {
 public:
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

 private:
  // Highest power of tau in the path: 0 at rest, 1 with velocity, 2 with acceleration.
  virtual int path_degree() const = 0;
};

// `css-trapezoid`: the straight path, and the mean whose impulse velocity Verlet applies. The default.
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

// `css`: the straight path, and the mean over steps 1..n as published [Lin25 35].
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

// `quadratic`: as css-trapezoid, with half the accelerations times tau^2 in the path.
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

// `frozen`: the boundary rests in its pose at t_k during the whole window. For teaching and tests only: it creates
// energy.
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
