// The order in which a scene is completed, with its paths and points of joints.
#include "mbd_solver/scene/resolve.h"

#include <filesystem>

#include "mbd_solver/scene/arrays.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/script_mesh.h"
#include "mbd_solver/scene/tracking_visitor.h"

namespace footfall {

namespace {

// Joins paths with the scene's folder and reports those that do not exist.
void resolve_paths(Scene& scene, Findings& findings) {
  namespace fs = std::filesystem;
  FieldWalk walk([&](const std::string& key, const FieldRef& ref, const Rule& rule, const FieldWalk& at) {
    std::string* path = member<std::string>(ref);
    if (rule.meaning != Meaning::kPath || !path || path->empty()) return;
    const fs::path full = (fs::path(scene.folder) / *path).lexically_normal();
    std::error_code ignored;
    if (!fs::is_regular_file(full, ignored))
      findings.error(code::kNoFile, *at.source(), at.local(key),
                     "the file \"" + *path + "\" does not exist (" + full.string() +
                         "); paths are relative to the scene's folder");
    *path = full.string();
  });
  visit_fields(walk, scene);
}

void resolve_joint_points(Scene& scene, Findings& findings) {
  for (JointSpec& joint : scene.joints) {
    if (!joint.point) continue;
    for (const char* key : {"point_a", "point_b"}) {
      if (joint.source.given(key))
        findings.error(code::kConflictingKeys, joint.source, key, "is given by \"point\" as well; keep one of the two");
    }
    joint.point_a = joint.point_b = *joint.point;
  }
}

}  // namespace

double total_mass(const Scene& scene) {
  double sum = 0.0;
  for (const BodySpec& body : scene.bodies) sum += body.mass;
  return sum;
}

Eigen::Vector3d mass_centre(const Scene& scene) {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const BodySpec& body : scene.bodies) moment += body.mass * body.position;
  const double mass = total_mass(scene);
  return mass > 0.0 ? Eigen::Vector3d(moment / mass) : Eigen::Vector3d::Zero();
}

void resolve_scene(Scene& scene, Findings& findings) {
  apply_arrays(scene, findings);
  resolve_paths(scene, findings);
  resolve_joint_points(scene, findings);
  resolve_segments(scene, findings);
  resolve_script_meshes(scene, findings);
  resolve_masses(scene, findings);
  resolve_box(scene, findings);
  scene.solver.atol = scene.solver.atol_position();
  if (!scene.flexible) {
    for (BodySpec& body : scene.bodies) {
      if (body.flexible) body.flexible->enabled = false;
    }
  }
}

}  // namespace footfall
