#include "coupler/tangent_load.h"

namespace footfall {

Eigen::Vector3d surplus_impulse(const TangentLoad& load, const BodyMotion& start, const BodyMotion& end, double H) {
  // Means over the window of the cubic through both ends.
  Vector6d x, v;
  x << 0.5 * (start.r + end.r) + H / 12.0 * (start.dr - end.dr) - load.r_mean,
      0.5 * (rotation_vector(load.L_mean, start.L) + rotation_vector(load.L_mean, end.L)) +
          H / 12.0 * (start.w - end.w);
  v << (end.r - start.r) / H, rotation_vector(start.L, end.L) / H;
  v -= load.v_mean;
  const Vector6d reaction = load.K * x + load.C * v;
  return -H * reaction.head<3>();
}

}  // namespace footfall
