#pragma once
// Which way is up: against gravity; along z where there is none.

#include <Eigen/Core>

namespace footfall {

// Unit vector in W. gravity [m/s2], in W.
inline Eigen::Vector3d up_direction(const Eigen::Vector3d& gravity) {
  return gravity.norm() > 0.0 ? Eigen::Vector3d(-gravity.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

}  // namespace footfall
