// Joints of the scene as markers on the bodies; the laws and drives on their coordinates; gears.

#include "coupler/base/errors.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/assemble/time_functions.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/gear.h"
#include "mbd_solver/model/laws/friction.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {
namespace {

// Displacements along x, y, z of the joint's frame (z = axis, x near axis2) and rotation about z; coordinates without
// a value are free.
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
    case JointType::kConstantVelocity: {
      // z of each marker along its shaft. Marker 2 is marker 1 bent about a normal of both shafts, without a turn about them.
      Eigen::Vector3d z_b = spec.source.given("axis2") ? spec.axis2 : spec.axis;
      if (z_b.dot(spec.axis) < 0.0) z_b = -z_b;
      const auto [m1, m2] = markers(along_z, Eigen::Quaterniond::FromTwoVectors(spec.axis, z_b) * along_z);
      return constant_velocity_joint(spec.name, m1, m2);
    }
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

// Forces on the coordinates of joints: stops, friction, springs, and the drives with their rotors.

using Laws = std::vector<std::unique_ptr<StrutLaw>>;

Laws laws_of(const CoordinateSpec& spec, double mass) {
  Laws laws;
  if (spec.stops) laws.push_back(std::make_unique<EndStop>(*spec.stops));
  if (spec.friction) {
    JointFrictionParameters friction = *spec.friction;
    friction.mass = mass;
    laws.push_back(std::make_unique<JointFriction>(friction));
  }
  if (spec.spring) laws.push_back(std::make_unique<LinearSpringDamper>(*spec.spring));
  return laws;
}

std::unique_ptr<StrutLaw> build(const DriveSpec& spec, double mass) {
  const TimeFunctionPtr command = time_function(spec.command, command_shape(spec.motor.kind));
  if (spec.motor.kind == MotorKind::kBrake) {
    BrakeParameters p;
    p.command = command;
    p.largest_force = spec.motor.gear_ratio * spec.motor.largest_torque.value_or(0.0);
    p.lag = spec.lag;
    p.mass = mass;
    p.damping_ratio = spec.stick_damping;
    return std::make_unique<Brake>(p);
  }
  MotorParameters p = spec.motor;
  p.command = command;
  return std::make_unique<Motor>(p);
}

Handle<JointForce> add_joint_force(const std::string& name, int joint, Coordinate coordinate, Laws laws, Model& model,
                                   int command = -1) {
  const Marker m1 = model.joint(joint).m1, m2 = model.joint(joint).m2;
  return model.add_force(std::make_unique<JointForce>(name, m1, m2, coordinate, std::move(laws), command));
}

}  // namespace

void add_joints(const Scene& scene, Mechanism& mechanism) {
  const Placement as_drawn;
  for (const JointSpec& spec : scene.joints) {
    const bool still = stands_still(scene, spec.bodies[0]) || stands_still(scene, spec.bodies[1]);
    Joint joint = build(spec, mechanism.model, scene.body_index(spec.bodies[0]), scene.body_index(spec.bodies[1]),
                        still ? as_drawn : mechanism.placement);
    joint.counts_turns = has_coordinate(spec.type, Coordinate::kAngle);
    mechanism.model.add_joint(std::move(joint));
  }
}

// Gears of the scene, between coordinates of its joints.
void add_gears(const Scene& scene, Mechanism& mechanism) {
  for (const GearSpec& spec : scene.gears) {
    std::vector<GearMember> members;
    for (std::size_t i = 0; i < spec.joints.size(); ++i)
      members.push_back({scene.joint_index(spec.joints[i]), scene.coordinate_of(spec, i), spec.factors[i]});
    if (!spec.curve.empty()) {
      auto [q, y] = columns_of(spec.curve);
      if (spec.closed && members.back().coordinate == Coordinate::kAngle) q.back() = q.front() + 2.0 * kPi;  // exactly
      members.back().curve =
          std::make_shared<CubicSpline>("gears." + spec.name + ".curve", q, y,
                                        spec.closed ? CubicSpline::Ends::kClosed : CubicSpline::Ends::kNatural);
    }
    mechanism.gears.push_back({spec.name, add_gear(mechanism.model, spec.name, members), members[0].coordinate});
  }
}

void add_drives(const Scene& scene, Mechanism& mechanism) {
  Model& model = mechanism.model;
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const JointSpec& spec = scene.joints[i];
    const int joint = static_cast<int>(i);
    for (const Coordinate coordinate : coordinates_of(spec.type)) {
      mechanism.coordinates.push_back({spec.name, joint, coordinate});
      if (const std::optional<CoordinateSpec>& acting = spec.acting_on(coordinate))
        add_joint_force("joint/" + spec.name + "/" + std::string(name_of(coordinate)), joint, coordinate,
                        laws_of(*acting, acting->friction ? moved_mass(scene, mechanism, joint, coordinate) : 0.0),
                        model);
    }
  }
  for (const DriveSpec& spec : scene.drives) {
    const int joint = scene.joint_index(spec.joint);
    const Coordinate coordinate = scene.coordinate_of(spec);
    Laws laws;
    const bool sticks = spec.motor.kind == MotorKind::kBrake;
    laws.push_back(build(spec, sticks ? moved_mass(scene, mechanism, joint, coordinate) : 0.0));
    const Handle<JointForce> force = add_joint_force("drive/" + spec.name, joint, coordinate, std::move(laws), model,
                                                     signal_place(mechanism, spec.command->signal));
    mechanism.drives.push_back({spec.name, force, coordinate});
    if (spec.rotor_inertia == 0.0) continue;
    const Marker m1 = model.joint(joint).m1, m2 = model.joint(joint).m2;
    model.add_joint(rotor("rotor/" + spec.name, m1, m2, coordinate,
                          spec.rotor_inertia * spec.motor.gear_ratio * spec.motor.gear_ratio));
  }
}

}  // namespace footfall
