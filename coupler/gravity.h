#pragma once
// The gravity of the script against that of the scene.

#include <Eigen/Dense>
#include <string>

namespace footfall {

// The same but for rounding [m/s2].
bool is_same_gravity(const Eigen::Vector3d& script, const Eigen::Vector3d& scene);
// What to say where they differ; without gravity of the script: that the grains have no weight. when: " at the start",
// of one that varies; else empty.
std::string gravity_differs(const Eigen::Vector3d& script, const Eigen::Vector3d& scene, const std::string& when);

}  // namespace footfall
