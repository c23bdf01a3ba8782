#pragma once
// `tangent`: a path that does not overshoot on stiff contacts, and a load that reacts within the window. The DEM side
// works as for css-trapezoid and also returns the slopes of the contacts. theory 7.6.

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
  bool requires_tangent() const override { return true; }

  // dr, w: mean_velocity with the slopes of the previous window. Modes move at da + H/2 dda.
  void set_path_rates(const Matrix6d& M, const BodyLoad& last, double H, BodyMotion& motion) const override;
  std::optional<TangentLoad> reaction(const Matrix6d& M, const BodyLoad& load, const PredictedPath& path,
                                      double H) const override;
  // By the mean load and its slopes.
  double pending_work(const AnsweredLoads& loads, const PredictedPath& path, const BodyMotion& computed) const override;
  // x'' = -K x - D (v - v_mean) exactly, path x + V tau, V: mean_velocity.
  MapState window_map(double omega_h, int n, const MapState& z) const override;
};

// Mean velocity [dr; w] over a window of H [s] of a body of rigid inertia M on contacts with the slopes of the previous
// window, by one L-stable second-order step of
//   M d'' = M a - K d - C (d' - v),  d(0) = 0,  d'(0) = v
// a: the current acceleration (all other forces are taken as constant; the inertia of bodies behind joints is left out).
// For omega H << 1 the result is v + a H/2; for omega H >> 1 it leads to the equilibrium of the contacts, through which
// v alone would drive the boundary.
Vector6d mean_velocity(const Matrix6d& M, const Vector6d& v, const Vector6d& a, const ContactTangent& slope, double H);

// [F; T] = mean load - K (x - x_mean) - (C + D) (v - v_mean), with means over the predicted path. K and C are the mean
// slopes of the window. Their change within it creates or dissipates energy where omega H is large; therefore
//   D = H/2 w^6/(1 + w^6) K,  w = omega H / 2
// damps motion that the window does not resolve: a damping ratio of w/2 for w >> 1, and of w^7/2 (no loss of order) for
// w << 1.
TangentLoad tangent_load(const ContactTangent& slope, const PredictedPath& path, double omega_h, double H);

}  // namespace footfall
