// Joints of the scene, drawn in D, as markers on the bodies.

#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/build/time_functions.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

// Displacements along x, y, z of the joint's frame (z = axis, x near axis2) and rotation about z; what is not given is
// free.
Joint prescribed(const JointSpec& spec, const Model& model, int a, int b, const Placement& placement) {
  const MotionSpec& motion = *spec.motion;
  PrescribedMotion prescribed;
  constexpr TableShape kShape = TableShape::kSpline;
  prescribed.translation = {time_function(motion.x, kShape), time_function(motion.y, kShape),
                            time_function(motion.z, kShape)};
  prescribed.rotation = time_function(motion.rotation, kShape);
  prescribed.rotation_axis = 2;
  prescribed.hold_other_rotations = motion.hold_other_rotations;
  const Eigen::Matrix3d axes_W = placement.R_WD * axes_with_z(spec.axis, spec.axis2);
  return prescribed_joint(spec.name, model.marker_at(a, placement.point(spec.point_a), axes_W),
                          model.marker_at(b, placement.point(spec.point_b), axes_W), prescribed);
}

Joint build(const JointSpec& spec, const Model& model, int a, int b, const Placement& placement) {
  const Eigen::Vector3d p_a = placement.point(spec.point_a), p_b = placement.point(spec.point_b);
  const auto markers = [&](const Eigen::Matrix3d& axes_a, const Eigen::Matrix3d& axes_b) {
    return std::pair(model.marker_at(a, p_a, placement.R_WD * axes_a),
                     model.marker_at(b, p_b, placement.R_WD * axes_b));
  };
  const Eigen::Matrix3d along_z = axes_with_z(spec.axis);
  const auto along_axis = [&](Joint (*joint)(std::string, Marker, Marker)) {
    const auto [m1, m2] = markers(along_z, along_z);
    return joint(spec.name, m1, m2);
  };
  switch (spec.type) {
    case JointType::kFixed: return along_axis(fixed_joint);
    case JointType::kSpherical: return along_axis(spherical_joint);
    case JointType::kRevolute: return along_axis(revolute_joint);
    case JointType::kPrismatic: return along_axis(prismatic_joint);
    case JointType::kCylindrical: return along_axis(cylindrical_joint);
    case JointType::kPlanar: {
      const Eigen::Matrix3d axes = axes_with_z(spec.axis, spec.axis2);
      const auto [m1, m2] = markers(axes, axes);
      return planar_joint(spec.name, m1, m2);
    }
    case JointType::kConstantVelocity: return along_axis(constant_velocity_joint);
    case JointType::kUniversal: {
      const Eigen::Vector3d across = spec.axis.cross(spec.axis2);  // x of a along `axis`, y of b along `axis2`
      const auto [m1, m2] = markers(axes_with_z(across, spec.axis), axes_with_z(across, spec.axis2.cross(across)));
      return universal_joint(spec.name, m1, m2);
    }
    case JointType::kPrescribed: return prescribed(spec, model, a, b, placement);
    case JointType::kDistance: {
      const auto [m1, m2] = markers(along_z, along_z);
      return distance_joint(spec.name, m1, m2, spec.length.value_or((spec.point_b - spec.point_a).norm()));
    }
    case JointType::kRolling: {
      const bool disc = spec.source.given("axis2");
      const auto [m1, m2] = markers(along_z, disc ? axes_with_z(spec.axis2) : along_z);
      return rolling_joint(spec.name, m1, m2, *spec.radius, disc);
    }
    case JointType::kPointOnPlane: {
      const auto [m1, m2] = markers(along_z, along_z);
      return point_on_plane_joint(spec.name, m1, m2);
    }
  }
  FOOTFALL_DEMAND(false);
}

}  // namespace

void add_joints(const Scene& scene, Mechanism& mechanism) {
  for (const JointSpec& spec : scene.joints)
    mechanism.model.add_joint(build(spec, mechanism.model, scene.body_index(spec.bodies[0]),
                                    scene.body_index(spec.bodies[1]), mechanism.placement));
}

}  // namespace footfall
