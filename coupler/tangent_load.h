#pragma once
// A load that reacts within the window, linearly in the motion of the body. theory 7.6.

#include "coupler/body_motion.h"

namespace footfall {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// [F; T] -= K dx + C dv, all in W:
//   dx = [r - r_mean; rotation from L_mean to L]
//   dv = [dr; w] - v_mean
//   rotation = 1/2 sum_k A_mean e_k x A e_k, to third order the rotation vector
struct TangentLoad {
  Matrix6d K = Matrix6d::Zero();                     // [N/m, N, N m/m, N m]
  Matrix6d C = Matrix6d::Zero();                     // [N s/m, ...]
  Eigen::Vector3d r_mean = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector4d L_mean = Eigen::Vector4d::UnitX();
  Vector6d v_mean = Vector6d::Zero();  // [dr; w] [m/s, rad/s]
};

// Impulse [N s] that a body has felt in a window of H [s] beyond what the grains gave, because it moved otherwise than
// predicted: it is reaction to grains that stood where they were; grains that gave way never gave it. From the states
// at both ends of the window.
Eigen::Vector3d surplus_impulse(const TangentLoad& load, const BodyMotion& start, const BodyMotion& end, double H);

}  // namespace footfall
