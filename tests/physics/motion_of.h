#pragma once
// Where the bodies of a mechanism are and how they move, free of the order of bodies, and how far two motions differ.

#include <algorithm>
#include <string>
#include <vector>

#include "tests/unit/dynamics/run.h"

namespace footfall::test {

struct BodyMotionAt {
  Eigen::Vector3d r, dr, w;  // [m, m/s, rad/s]
  Eigen::Matrix3d A;
};
using Motion = std::vector<BodyMotionAt>;

inline Motion motion_of(Run& run) {
  Motion out;
  for (int i = 0; i < run.equations.model().body_count(); ++i) {
    const BodyKinematics b = run.body(i);
    out.push_back({b.r, b.dr, b.w, b.A});
  }
  return out;
}

// Largest over the bodies: of the paths [m or rad], and of the speeds at both ends [m/s or rad/s].
struct Size {
  double path = 0.0, speed = 0.0;
};
inline Size size_of(const Motion& start, const Motion& end) {
  Size size;
  for (std::size_t i = 0; i < start.size(); ++i) {
    size.path = std::max({size.path, (end[i].r - start[i].r).norm(), (end[i].A - start[i].A).norm()});
    for (const BodyMotionAt& at : {start[i], end[i]}) size.speed = std::max({size.speed, at.dr.norm(), at.w.norm()});
  }
  return size;
}

// Largest difference, relative to the size of the motion [-].
inline double difference(const Motion& a, const Motion& b, const Size& size) {
  double path = 0.0, speed = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    path = std::max({path, (a[i].r - b[i].r).norm(), (a[i].A - b[i].A).norm()});
    speed = std::max({speed, (a[i].dr - b[i].dr).norm(), (a[i].w - b[i].w).norm()});
  }
  return std::max(path / size.path, speed / size.speed);
}

// Tolerances as a scene has them, and the method it takes without grains. No step is bounded but by its error.
inline IntegratorOptions as_a_scene(double rtol) {
  IntegratorOptions options;
  options.rtol = rtol;
  options.atol = 0.01 * rtol;
  options.atol_velocity = rtol;
  options.order = 5;
  return options;
}

}  // namespace footfall::test
