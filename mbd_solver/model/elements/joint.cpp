// Each kind of joint is a list of rows: dot products of axes and of the difference of points.

#include "mbd_solver/model/elements/joint.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/elements/rolling.h"

namespace footfall {
namespace {

using Kind = Factor::Kind;

ConstraintRow row_of(ConstraintRow::Unit unit, Factor alpha, Factor beta) {
  ConstraintRow row;
  row.unit = unit;
  row.terms[0] = {alpha, beta};
  return row;
}

// e_i of marker 1 stays perpendicular to e_j of marker 2.
ConstraintRow perpendicular(int i, int j) {
  return row_of(ConstraintRow::Unit::kAngle, {Kind::kAxis1, i}, {Kind::kAxis2, j});
}

// The points keep their distance along e_i of marker 1: e_i.(p2 - p1) = offset.
ConstraintRow along(int i, double offset = 0.0) {
  ConstraintRow row = row_of(ConstraintRow::Unit::kLength, {Kind::kAxis1, i}, {Kind::kDifference, 0});
  row.offset = offset;
  return row;
}

void add_coincident(Joint& joint) {
  for (int k = 0; k < 3; ++k)
    joint.rows.push_back(row_of(ConstraintRow::Unit::kLength, {Kind::kWorldDirection, k}, {Kind::kDifference, 0}));
}

// z axes parallel.
void add_parallel(Joint& joint) {
  joint.rows.push_back(perpendicular(0, 2));
  joint.rows.push_back(perpendicular(1, 2));
}

Joint joint_of(std::string name, std::string kind, Marker m1, Marker m2) {
  if (m1.body == m2.body)
    throw InputError(code::kOneBodyOnly,
                     "joint \"" + name + "\": it must connect two different bodies, or a body and the ground.");
  Joint joint;
  joint.name = std::move(name);
  joint.kind = std::move(kind);
  joint.m1 = std::move(m1);
  joint.m2 = std::move(m2);
  return joint;
}

}  // namespace

Joint fixed_joint(std::string name, Marker m1, Marker m2) {
  Joint joint = joint_of(std::move(name), "fixed", std::move(m1), std::move(m2));
  add_coincident(joint);
  add_parallel(joint);
  joint.rows.push_back(perpendicular(0, 1));
  return joint;
}

Joint spherical_joint(std::string name, Marker m1, Marker m2) {
  Joint joint = joint_of(std::move(name), "spherical", std::move(m1), std::move(m2));
  add_coincident(joint);
  return joint;
}

Joint universal_joint(std::string name, Marker m1, Marker m2) {
  Joint joint = joint_of(std::move(name), "universal", std::move(m1), std::move(m2));
  add_coincident(joint);
  joint.rows.push_back(perpendicular(0, 1));
  return joint;
}

Joint revolute_joint(std::string name, Marker m1, Marker m2) {
  Joint joint = joint_of(std::move(name), "revolute", std::move(m1), std::move(m2));
  add_coincident(joint);
  add_parallel(joint);
  return joint;
}

Joint prismatic_joint(std::string name, Marker m1, Marker m2) {
  Joint joint = joint_of(std::move(name), "prismatic", std::move(m1), std::move(m2));
  joint.rows = {along(0), along(1)};
  add_parallel(joint);
  joint.rows.push_back(perpendicular(0, 1));
  return joint;
}

Joint cylindrical_joint(std::string name, Marker m1, Marker m2) {
  Joint joint = joint_of(std::move(name), "cylindrical", std::move(m1), std::move(m2));
  joint.rows = {along(0), along(1)};
  add_parallel(joint);
  return joint;
}

Joint planar_joint(std::string name, Marker m1, Marker m2) {
  Joint joint = joint_of(std::move(name), "planar", std::move(m1), std::move(m2));
  joint.rows = {along(2)};
  add_parallel(joint);
  return joint;
}

Joint constant_velocity_joint(std::string name, Marker m1, Marker m2) {
  Joint joint = joint_of(std::move(name), "constant_velocity", std::move(m1), std::move(m2));
  add_coincident(joint);
  // The rotation vector has no part along z: (y1.x2 - x1.y2) / 2 = 0.
  ConstraintRow row = perpendicular(1, 0);
  row.scale = 0.5;
  row.term_count = 2;
  row.terms[1] = {{Kind::kAxis1, 0}, {Kind::kAxis2, 1}};
  row.scale2 = -0.5;
  joint.rows.push_back(row);
  return joint;
}

Joint rotor(std::string name, Marker m1, Marker m2, Coordinate coordinate, double inertia) {
  FOOTFALL_DEMAND(std::isfinite(inertia) && inertia > 0.0);
  Joint joint = joint_of(std::move(name), "rotor", std::move(m1), std::move(m2));
  ConstraintRow row;
  row.coordinate = coordinate;
  row.inertia = inertia;
  joint.rows = {row};
  return joint;
}

Joint rolling_joint(std::string name, Marker m1, Marker m2, double radius, bool disc) {
  FOOTFALL_DEMAND(std::isfinite(radius) && radius > 0.0);
  Joint joint = joint_of(std::move(name), "rolling", std::move(m1), std::move(m2));
  ConstraintRow row;
  row.law = std::make_shared<Rolling>(radius, disc);
  for (row.law_row = 0; row.law_row < 3; ++row.law_row) joint.rows.push_back(row);
  return joint;
}

Joint distance_joint(std::string name, Marker m1, Marker m2, double length) {
  if (!(std::isfinite(length) && length > 0.0))
    throw InputError(code::kNoLength, "joint \"" + name + "\": length is " + plain_text(length) +
                                          " m; it must be positive (for zero use a spherical joint).");
  Joint joint = joint_of(std::move(name), "distance", std::move(m1), std::move(m2));
  // phi = (d.d - length^2) / (2 length): the gap itself to first order.
  ConstraintRow row = row_of(ConstraintRow::Unit::kLength, {Kind::kDifference, 0}, {Kind::kDifference, 0});
  row.scale = 0.5 / length;
  row.offset = 0.5 * length;
  joint.rows = {row};
  return joint;
}

Joint point_on_plane_joint(std::string name, Marker m1, Marker m2, double height) {
  Joint joint = joint_of(std::move(name), "point_on_plane", std::move(m1), std::move(m2));
  joint.rows = {along(2, height)};
  return joint;
}

Joint prescribed_joint(std::string name, Marker m1, Marker m2, const PrescribedMotion& motion) {
  FOOTFALL_DEMAND(motion.rotation_axis >= 0 && motion.rotation_axis < 3);
  Joint joint = joint_of(std::move(name), "prescribed", std::move(m1), std::move(m2));
  for (int k = 0; k < 3; ++k) {
    if (!motion.translation[k]) continue;
    ConstraintRow row = along(k);
    row.motion = motion.translation[k];
    joint.rows.push_back(row);
  }
  const int k = motion.rotation_axis, i = (k + 1) % 3, j = (k + 2) % 3;
  if (motion.hold_other_rotations) {
    joint.rows.push_back(perpendicular(i, k));
    joint.rows.push_back(perpendicular(j, k));
  }
  if (motion.rotation) {  // sin(angle - f) = cos(f) e_j1.e_i2 - sin(f) e_i1.e_i2
    ConstraintRow row = perpendicular(j, i);
    row.term_count = 2;
    row.terms[1] = {{Kind::kAxis1, i}, {Kind::kAxis2, i}};
    row.motion = motion.rotation;
    row.rotation = true;
    joint.rows.push_back(row);
  }
  if (joint.rows.empty())
    throw InputError(code::kNothingPrescribed,
                     "joint \"" + joint.name + "\": a prescribed motion must prescribe at least one coordinate.");
  return joint;
}

Vector6d joint_wrench(const Joint& joint, const PairMotion& pair, double t,
                      const Eigen::Ref<const Eigen::VectorXd>& lambda) {
  MarkerVectors vectors(pair, joint.m1, joint.m2);
  // On body 2; if body 2 is the ground, minus that on body 1.
  const int slot = pair.body[1]->ground ? 0 : 1;
  const BodyKinematics& body = *pair.body[slot];
  Vector6d wrench = Vector6d::Zero();
  Eigen::VectorXd phi_v(pair.size());
  for (std::size_t k = 0; k < joint.rows.size(); ++k) {
    evaluate_row(joint.rows[k], t, vectors, phi_v);
    wrench -= lambda[static_cast<Eigen::Index>(k)] * phi_v.segment<6>(pair.offset(slot));
  }
  if (slot == 0) wrench = -wrench;
  const Eigen::Vector3d point = KinematicVector::point(pair, 1, joint.m2).value();
  const Eigen::Vector3d arm = point - body.r;
  wrench.tail<3>() -= arm.cross(Eigen::Vector3d(wrench.head<3>()));
  return wrench;
}

}  // namespace footfall
