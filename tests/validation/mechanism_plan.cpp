#include "tests/validation/mechanism_plan.h"

#include <algorithm>
#include <utility>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/assembly.h"
#include "mbd_solver/model/elements/gear.h"
#include "mbd_solver/model/rotation.h"

namespace footfall::test {
namespace {

Joint build(const PlannedJoint& joint, const Model& model) {
  const bool rolls = joint.kind == JointKind::kDisc || joint.kind == JointKind::kSphere;
  const Marker m1 = model.marker_at(joint.body_1, joint.point_1, joint.axes),
               m2 = model.marker_at(joint.body_2, joint.point_2, rolls ? joint.axes_2 : joint.axes);
  const Eigen::Vector3d normal = joint.axes.col(2);
  const double height = normal.dot(joint.point_2 - joint.point_1);
  switch (joint.kind) {
    case JointKind::kFixed: return fixed_joint(joint.name, m1, m2);
    case JointKind::kSpherical: return spherical_joint(joint.name, m1, m2);
    case JointKind::kUniversal: return universal_joint(joint.name, m1, m2);
    case JointKind::kRevolute: return revolute_joint(joint.name, m1, m2);
    case JointKind::kPrismatic: return prismatic_joint(joint.name, m1, m2);
    case JointKind::kCylindrical: return cylindrical_joint(joint.name, m1, m2);
    case JointKind::kDistance: return distance_joint(joint.name, m1, m2, (joint.point_2 - joint.point_1).norm());
    case JointKind::kPlane:
    case JointKind::kAxialHold: return point_on_plane_joint(joint.name, m1, m2);
    case JointKind::kDisc: {
      const double s = normal.cross(Eigen::Vector3d(joint.axes_2.col(2))).norm();
      return rolling_joint(joint.name, m1, m2, height / s, true);
    }
    case JointKind::kSphere: return rolling_joint(joint.name, m1, m2, height, false);
    case JointKind::kDriven: {
      PrescribedMotion motion;
      for (TimeFunctionPtr& component : motion.translation) component = polynomial({0.0});
      motion.rotation = sum({polynomial({0.0, joint.drive_rate}), sine(joint.drive_sway, 1.0)});
      motion.hold_other_rotations = true;
      return prescribed_joint(joint.name, m1, m2, motion);
    }
  }
  FOOTFALL_DEMAND(false);
  return {};
}

int renumbered(int body, const std::vector<int>& order) {
  return body == kGround ? kGround : order[static_cast<std::size_t>(body)];
}

}  // namespace

Model build(const Plan& plan) {
  Model model(plan.gravity);
  for (const PlannedBody& body : plan.bodies) model.add_body(Body(body.name, body.mass, body.inertia), body.state);
  for (const PlannedJoint& joint : plan.joints) model.add_joint(build(joint, model));
  for (const PlannedForce& force : plan.forces)
    model.add_force(force.make(force.name, model.marker_at(force.body_1, force.point_1, force.axes),
                               model.marker_at(force.body_2, force.point_2, force.axes),
                               (force.point_2 - force.point_1).norm()));
  for (const PlannedRotor& planned : plan.rotors) {
    const Joint& joint = model.joint(joint_index(model, planned.joint));
    model.add_joint(rotor("rotor_" + planned.joint, joint.m1, joint.m2, planned.coordinate, planned.inertia));
  }
  for (const PlannedGear& gear : plan.gears) {
    std::vector<GearMember> members;
    for (const PlannedGear::Member& member : gear.members)
      members.push_back({joint_index(model, member.joint), member.coordinate, member.factor});
    add_gear(model, gear.name, members);
  }
  return model;
}

int joint_index(const Model& model, const std::string& name) {
  for (int j = 0; j < model.joint_count(); ++j)
    if (model.joint(j).name == name) return j;
  FOOTFALL_DEMAND(false);
  return -1;
}

Plan settled(Plan plan) {
  const Model model = build(plan);
  const Layout layout(model);
  const State state = assemble(model).state;
  for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
    BodyState& body = plan.bodies[i].state;
    body.r = state.q.segment<3>(layout.body_q[i]);
    body.L = state.q.segment<4>(layout.body_q[i] + 3).normalized();
    body.dr = state.v.segment<3>(layout.body_v[i]);
    body.w = state.v.segment<3>(layout.body_v[i] + 3);
  }
  return plan;
}

Plan moved(Plan plan, const Eigen::Matrix3d& R, const Eigen::Vector3d& d) {
  const auto move = [&](Eigen::Vector3d& p) { p = R * p + d; };
  plan.gravity = R * plan.gravity;
  for (PlannedBody& body : plan.bodies) {
    move(body.state.r);
    body.state.L = quaternion_from_matrix(R * rotation_matrix(body.state.L));
    body.state.dr = R * body.state.dr;
    body.state.w = R * body.state.w;
  }
  for (PlannedJoint& joint : plan.joints) {
    move(joint.point_1);
    move(joint.point_2);
    joint.axes = R * joint.axes;
    joint.axes_2 = R * joint.axes_2;
  }
  for (PlannedForce& force : plan.forces) {
    move(force.point_1);
    move(force.point_2);
    force.axes = R * force.axes;
  }
  return plan;
}

Plan reordered(Plan plan, const std::vector<int>& order) {
  std::vector<PlannedBody> bodies(plan.bodies.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    bodies[static_cast<std::size_t>(order[i])] = plan.bodies[i];
    bodies[static_cast<std::size_t>(order[i])].name = "renamed_" + std::to_string(order[i]);
  }
  plan.bodies = bodies;
  for (PlannedJoint& joint : plan.joints) {
    joint.name = "renamed_" + joint.name;
    joint.body_1 = renumbered(joint.body_1, order);
    joint.body_2 = renumbered(joint.body_2, order);
  }
  for (PlannedForce& force : plan.forces) {
    force.name = "renamed_" + force.name;
    force.body_1 = renumbered(force.body_1, order);
    force.body_2 = renumbered(force.body_2, order);
  }
  for (PlannedGear& gear : plan.gears) {
    for (PlannedGear::Member& member : gear.members) member.joint = "renamed_" + member.joint;
    std::reverse(gear.members.begin(), gear.members.end());
  }
  for (PlannedRotor& rotor : plan.rotors) rotor.joint = "renamed_" + rotor.joint;
  std::reverse(plan.joints.begin(), plan.joints.end());
  std::reverse(plan.forces.begin(), plan.forces.end());
  return plan;
}

Plan with_split_hinges(Plan plan) {
  std::vector<PlannedJoint> joints;
  for (PlannedJoint joint : plan.joints) {
    const bool hinge = joint.kind == JointKind::kRevolute;
    if (hinge) joint.kind = JointKind::kCylindrical;
    joints.push_back(joint);
    if (!hinge) continue;
    joint.kind = JointKind::kAxialHold;
    joint.name += "_hold";
    joints.push_back(joint);
  }
  plan.joints = joints;
  return plan;
}

Plan with_passenger(Plan plan, int index, double mass, const Eigen::Vector3d& offset) {
  const PlannedBody& host = plan.bodies[static_cast<std::size_t>(index)];
  PlannedBody passenger{"passenger", mass, 0.05 * mass * Eigen::Vector3d(1.0, 1.2, 1.4).asDiagonal(), host.state};
  passenger.state.r += offset;
  passenger.state.dr += host.state.w.cross(offset);
  PlannedJoint weld;
  weld.name = "weld";
  weld.body_1 = index;
  weld.body_2 = static_cast<int>(plan.bodies.size());
  weld.point_1 = weld.point_2 = host.state.r + 0.3 * offset;
  plan.bodies.push_back(passenger);
  plan.joints.push_back(weld);
  return plan;
}

Plan with_merged_passenger(Plan plan, int index, double mass, const Eigen::Vector3d& offset) {
  PlannedBody& host = plan.bodies[static_cast<std::size_t>(index)];
  const Eigen::Vector3d arm = rotation_matrix(host.state.L).transpose() * offset;
  const double reduced = host.mass * mass / (host.mass + mass);
  // The passenger has the host's attitude: inertias in the same axes, and Steiner's share of both.
  host.inertia +=
      Eigen::Matrix3d(0.05 * mass * Eigen::Vector3d(1.0, 1.2, 1.4).asDiagonal()) - reduced * skew(arm) * skew(arm);
  const Eigen::Vector3d shift = mass / (host.mass + mass) * offset;
  host.mass += mass;
  host.state.r += shift;
  host.state.dr += host.state.w.cross(shift);
  return plan;
}

}  // namespace footfall::test
