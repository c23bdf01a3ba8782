#pragma once
// What the boundary of one body does in the grains during a window, known here without being told: the grains' side
// walks the same path.

#include "coupler/window.h"
#include "mbd_solver/model/external_load.h"

namespace footfall {

// Scheme `tangent` needs the means of the predicted path: the mean load belongs to them, and with the path itself
// instead of its mean the scheme is unstable. The choice of windows needs the gap between computed and predicted
// motion.
class PredictedWindow {
 public:
  // The scheme must outlive this.
  PredictedWindow(const Scheme& scheme, const BodyMotion& initial) : scheme_(scheme), path_(scheme, initial) {}

  // A window of n substeps of dt [s] begins at the computed state `start`. Means are weighted as the forces are.
  void begin(const BodyMotion& start, int n, double dt);
  const Eigen::Vector3d& r_mean() const { return r_mean_; }  // [m]
  const Eigen::Vector4d& L_mean() const { return L_mean_; }
  const Vector6d& v_mean() const { return v_mean_; }  // [dr; w]
  // Computed minus predicted at the window's end: [m], and as a rotation vector [rad].
  Vector6d gap(const BodyMotion& computed) const;
  // Predicted end minus mean pose, likewise.
  Vector6d end_from_mean() const;

 private:
  const Scheme& scheme_;
  BoundaryPath path_;
  Eigen::Vector3d r_mean_ = Eigen::Vector3d::Zero();
  Eigen::Vector4d L_mean_ = Eigen::Vector4d::UnitX();
  Vector6d v_mean_ = Vector6d::Zero();
};

}  // namespace footfall
