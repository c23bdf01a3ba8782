#pragma once
// `tangent`: a path for the grains that does not overshoot on stiff contacts, and a load that reacts within the window.
// On the grains' side as css-trapezoid, and the contacts' slopes are returned. theory 7.6.

#include "coupler/messages.h"
#include "coupler/schemes/scheme.h"

namespace footfall {

class Tangent : public Scheme {
 public:
  static constexpr std::string_view kName = "tangent";
  std::string_view name() const override { return kName; }
  void predict(const BodyMotion& start, double tau, BodyMotion& out) const override;
  StepWeights weights() const override { return {0.5, 0.5}; }
  bool continuous_path() const override { return true; }
  bool wants_tangent() const override { return true; }

  // dr, w: mean_velocity on the slopes of the window before. Modes run at da + H/2 dda.
  void set_path_rates(const Matrix6d& M, const BodyLoad& last, double H, BodyMotion& motion) const override;
  std::optional<TangentLoad> reaction(const Matrix6d& M, const BodyLoad& load, const PredictedPath& path,
                                      double H) const override;
  // By the mean load and its slope.
  double pending_work(const AnsweredLoads& loads, const PredictedPath& path, const BodyMotion& computed) const override;
  // x'' = -K x - D (v - v_mean) exactly, path x + V tau, V: mean_velocity.
  MapState window_map(double omega_h, int n, const MapState& z) const override;
};

// Mean velocity [dr; w] over a window of H [s] of a body of rigid inertia M on contacts of the slopes that it had in
// the last window, by one L-stable second-order step of
//   M d'' = M a - K d - C (d' - v),  d(0) = 0,  d'(0) = v
// a: the acceleration that it has (so every other force stays what it is; bodies behind joints lend it no inertia).
// For omega H << 1 it is v + a H/2; for omega H >> 1 it leads to where the contacts balance, while v alone would drive
// the boundary through them.
Vector6d mean_velocity(const Matrix6d& M, const Vector6d& v, const Vector6d& a, const ContactTangent& slope, double H);

// [F; T] = mean load - K (x - x_mean) - (C + D) (v - v_mean), means of the predicted path. K and C are the mean slopes
// of the window. Their change within it feeds or drains energy where omega H is large, so that
//   D = H/2 w^6/(1 + w^6) K,  w = omega H / 2
// damps what the window does not resolve: a damping ratio of w/2 for w >> 1, and of w^7/2 (no loss of order) for
// w << 1.
TangentLoad tangent_load(const ContactTangent& slope, const PredictedPath& path, double omega_h, double H);

}  // namespace footfall
