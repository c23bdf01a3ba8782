#pragma once
// Up, for heights and vertical speeds.

#include <Eigen/Core>

namespace footfall {

// Against gravity g [m/s2]; along z without gravity. A unit vector of W.
inline Eigen::Vector3d up_direction(const Eigen::Vector3d& g) {
  return g.norm() > 0.0 ? Eigen::Vector3d(-g.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

}  // namespace footfall
