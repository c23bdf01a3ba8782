#include "coupler/gravity.h"

#include "coupler/base/text.h"

namespace footfall {
namespace {

constexpr double kSameGravity = 1e-6;  // of the scene's

std::string gravity_text(const Eigen::Vector3d& v) {
  return "(" + number_text(v[0]) + ", " + number_text(v[1]) + ", " + number_text(v[2]) + ") m/s2";
}

}  // namespace

bool is_same_gravity(const Eigen::Vector3d& script, const Eigen::Vector3d& scene) {
  return (script - scene).norm() <= kSameGravity * scene.norm();
}

std::string gravity_differs(const Eigen::Vector3d& script, const Eigen::Vector3d& scene, const std::string& when) {
  if (script.isZero(0.0) && when.empty())
    return "the LIGGGHTS script has no fix gravity, the scene has gravity = " + gravity_text(scene) +
           ": the grains have no weight";
  return "the LIGGGHTS script has the gravity " + gravity_text(script) + when + " (fix gravity), the scene " +
         gravity_text(scene) +
         " (gravity): make them agree, or say that the grains have their own: fix ID all couple/mbd every N gravity "
         "script ...";
}

}  // namespace footfall
