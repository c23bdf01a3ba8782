// Joints: two bodies, the points and axes their type needs, and no gap.
#include <algorithm>
#include <cmath>

#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/laws/cubic_spline.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

namespace {

constexpr double kLargestGap = 1e-6;  // of the points of a joint in the drawing [m]; projection would move bodies by it
constexpr double kLargestCosine = 1e-3;  // of the two axes of a universal joint, as numbers of four digits give it

void check_points(const JointSpec& joint, double largest_gap, Findings& findings) {
  const Source& source = joint.source;
  const bool both = source.given("point_a") && source.given("point_b");
  const bool may_differ = traits_of(joint.type).points_may_differ;
  if (!source.given("point") && !both) {
    findings.error(source, "point",
                   may_differ ? "is missing; give point_a and point_b in the drawing frame"
                              : "is missing; give the joint's point in the drawing frame (or point_a and point_b)");
    return;
  }
  const double gap = (joint.point_b - joint.point_a).norm();
  if (!may_differ && gap > largest_gap) {
    findings.error(source, "point_b",
                   "the joint is open by " + number_text(gap) + " m between \"" + joint.bodies[0] + "\" and \"" +
                       joint.bodies[1] + "\"; expected points within " + number_text(largest_gap) +
                       " m in the design position (initial.largest_gap closes larger gaps)");
  }
  if (joint.type == JointType::kRolling && joint.radius) {
    // A disc on its edge stands lower when it leans.
    const double lean = source.given("axis2") ? joint.axis.cross(joint.axis2).norm() : 1.0;
    const double height = joint.axis.dot(joint.point_b - joint.point_a);
    if (std::abs(height - *joint.radius * lean) > largest_gap)
      findings.error(source, "point_b",
                     "stands " + number_text(height) + " m above the plane, expected " +
                         number_text(*joint.radius * lean) + " m" +
                         (lean < 1.0 ? ", radius times the sine of the angle between axis and axis2" : ", the radius"));
  }
  if (joint.type != JointType::kDistance) return;
  if (gap == 0.0) {
    findings.error(source, "point_b", "is the same point as point_a; a distance joint needs two, some way apart");
  } else if (joint.length && std::abs(*joint.length - gap) > kLargestGap) {
    findings.error(source, "length",
                   "is " + number_text(*joint.length) + " m, but the points are " + number_text(gap) +
                       " m apart in the drawing; leave it out or move them");
  }
}

void check_motion(const JointSpec& joint, Findings& findings) {
  if (traits_of(joint.type).motion == KeyUse::kUnused) {
    if (joint.motion) findings.error(joint.source, "motion", "belongs to joints of type \"prescribed\" only");
    return;
  }
  const bool any = joint.motion && (joint.motion->x || joint.motion->y || joint.motion->z || joint.motion->rotation);
  if (!any)
    findings.error(joint.source, "motion",
                   "prescribes nothing; expected at least one of x, y, z, rotation, for example motion = { z = { "
                   "polynomial = [0, -0.1] } }");
  if (joint.motion && joint.motion->hold_other_rotations && !joint.motion->rotation)
    findings.error(joint.source, "motion.hold_other_rotations",
                   "needs a prescribed rotation, for example rotation = { polynomial = [0] }");
}

constexpr double kSameDirection = 0.999;  // cosine, as of axis and axis2 below

// f(0) [rad]: what counts against the drawing.
double at_start(const TimeFunctionSpec& f) {
  double value = f.amplitude * std::sin(f.phase);
  if (!f.polynomial.empty()) value += f.polynomial.front();
  // A spline is continued before its first point: only where it passes through t = 0 its value is known here.
  for (const Eigen::Vector2d& row : f.table)
    if (row.x() == 0.0) value += row.y();
  return value;
}

constexpr double kSwing = 0.05;  // of the range of a table's values: what its spline may leave it by

// A spline through points that are not smooth swings out beside them, and goes on beyond its last point.
void check_spline(const JointSpec& joint, const std::string& key, const TimeFunctionSpec& f, double end_time,
                  Findings& findings) {
  if (f.table.size() < 2) return;
  std::vector<double> times, values;
  for (const Eigen::Vector2d& row : f.table) {
    if (!times.empty() && !(row.x() > times.back())) return;  // told elsewhere
    times.push_back(row.x());
    values.push_back(row.y());
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double range = *most - *least;
  const CubicSpline spline("a table over time", times, values);
  double swing = 0.0, when = 0.0;
  constexpr int kLooks = 16;  // in each piece
  for (std::size_t i = 1; i < times.size(); ++i)
    for (int k = 1; k < kLooks; ++k) {
      const double t = times[i - 1] + (times[i] - times[i - 1]) * k / kLooks;
      const double value = spline.at(t).value;
      const double out = std::max({*least - value, value - *most, 0.0});
      if (out <= swing) continue;
      swing = out;
      when = t;
    }
  if (swing > kSwing * range && range > 0.0)
    findings.warning(joint.source, key + ".table",
                     "is a smooth curve through its points, and at " + number_text(when, 3) +
                         " s it leaves their range by " + number_text(swing, 3) +
                         "; give more points where the motion begins and ends");
  const double speed = spline.at(times.back()).slope;
  const double beyond = std::abs(speed) * (end_time - times.back());
  if (end_time > times.back() && beyond > kSwing * range)
    findings.warning(joint.source, key + ".table",
                     "ends at " + number_text(times.back(), 4) + " s; until " + number_text(end_time, 4) +
                         " s the motion goes on with its last speed, " + number_text(speed, 3) +
                         " per s; give more points, the last of them alike where it shall rest");
}

// The motion of one joint by itself.
void check_functions(const JointSpec& joint, double end_time, Findings& findings) {
  if (!joint.motion) return;
  const MotionSpec& m = *joint.motion;
  check_function(joint.source, "motion.x", m.x, findings);
  check_function(joint.source, "motion.y", m.y, findings);
  check_function(joint.source, "motion.z", m.z, findings);
  check_function(joint.source, "motion.rotation", m.rotation, findings);
  for (const auto& [key, function] : {std::pair("x", &m.x), {"y", &m.y}, {"z", &m.z}, {"rotation", &m.rotation}})
    if (*function) check_spline(joint, std::string("motion.") + key, **function, end_time, findings);
  for (const auto& [key, function] : {std::pair("x", &m.x), {"y", &m.y}, {"z", &m.z}, {"rotation", &m.rotation}})
    if (*function && !(*function)->signal.empty())
      findings.error(joint.source, std::string("motion.") + key + ".signal",
                     "cannot lead a motion, which needs two derivatives; use a [[drives]] entry of kind \"position\"");
  // sin(angle - f) = 0 holds half a turn off, too.
  if (m.rotation && !(std::cos(at_start(*m.rotation)) > 0.0))
    findings.error(joint.source, "motion.rotation",
                   "begins at " + number_text(at_start(*m.rotation) * 180.0 / kPi, 4) +
                       " degrees, but the bodies are drawn at 0; expected less than 90: draw them as they start, and "
                       "count the rotation from there");
}

// Directions of W that a joint prescribes, with their names.
std::vector<std::pair<std::string, Eigen::Vector3d>> displacements(const JointSpec& joint) {
  const Eigen::Vector3d z = joint.axis;
  const Eigen::Vector3d x = (joint.axis2 - joint.axis2.dot(z) * z).normalized();
  std::vector<std::pair<std::string, Eigen::Vector3d>> out;
  if (joint.motion->x) out.emplace_back("x", x);
  if (joint.motion->y) out.emplace_back("y", z.cross(x));
  if (joint.motion->z) out.emplace_back("z", z);
  return out;
}

// Two motions of the same coordinate of the same two bodies: one of them would be left out as redundant.
void check_motion_twice(const JointSpec& first, const JointSpec& second, Findings& findings) {
  const bool same_pair =
      first.bodies == second.bodies || (first.bodies[0] == second.bodies[1] && first.bodies[1] == second.bodies[0]);
  if (!first.motion || !second.motion || !same_pair) return;
  const auto complain = [&](const std::string& key) {
    findings.error(second.source, "motion." + key,
                   "moves what joint \"" + first.name + "\" (line " + std::to_string(first.source.line) +
                       ") moves already, between the same two bodies; keep one of them");
  };
  if (first.motion->rotation && second.motion->rotation && std::abs(first.axis.dot(second.axis)) > kSameDirection)
    complain("rotation");
  if ((first.point_b - second.point_b).norm() > kLargestGap) return;
  for (const auto& [name_1, direction_1] : displacements(first))
    for (const auto& [name_2, direction_2] : displacements(second))
      if (std::abs(direction_1.dot(direction_2)) > kSameDirection) complain(name_2);
}

}  // namespace

void check_function(const Source& source, const std::string& key, const std::optional<TimeFunctionSpec>& f,
                    Findings& findings) {
  if (!f) return;
  if (f->amplitude != 0.0 && f->frequency == 0.0)
    findings.error(source, key + ".frequency",
                   "is missing; an amplitude swings with it (Hz). For a constant use polynomial = [value]");
  for (std::size_t i = 1; i < f->table.size(); ++i) {
    if (f->table[i].x() > f->table[i - 1].x()) continue;
    findings.error(source, key + ".table",
                   "has time " + number_text(f->table[i].x()) + " s after " + number_text(f->table[i - 1].x()) +
                       " s; expected times that rise");
    break;
  }
}

void check_joints(const Scene& scene, Findings& findings) {
  check_unique_names(scene.joints, "joint", findings);
  for (const JointSpec& joint : scene.joints) {
    if (!joint.source.good("type")) continue;
    check_pair(scene, joint.source, joint.bodies, findings);
    check_points(joint, scene.initial.largest_gap, findings);
    check_motion(joint, findings);
    check_functions(joint, scene.end_time, findings);
    for (const JointSpec& before : scene.joints) {
      if (&before == &joint) break;
      check_motion_twice(before, joint, findings);
    }
    const JointTraits traits = traits_of(joint.type);
    if (traits.axis == KeyUse::kRequired && !joint.source.given("axis"))
      findings.error(joint.source, "axis", "is missing; this type of joint needs it");
    if (traits.axis2 == KeyUse::kRequired && !joint.source.given("axis2"))
      findings.error(joint.source, "axis2",
                     "is missing; a " + std::string(traits.name) + " joint has a second axis, fixed in \"" +
                         joint.bodies[1] + "\"");
    const double cosine = std::abs(joint.axis.dot(joint.axis2));
    if (joint.type == JointType::kUniversal && cosine > kLargestCosine)
      findings.error(joint.source, "axis2",
                     "makes " + number_text(std::acos(std::min(1.0, cosine)) * 180.0 / kPi) +
                         " degrees with axis; expected 90 in the design position");
    const bool planar = joint.type == JointType::kPlanar && joint.source.given("axis2");
    if ((joint.type == JointType::kPrescribed || planar) && cosine > kSameDirection)
      findings.error(joint.source, "axis2",
                     "is parallel to axis; expected the x direction of the joint, across its z = axis");
    if (traits.radius == KeyUse::kRequired && !joint.radius)
      findings.error(joint.source, "radius", "is missing; that of the wheel, m");
    if (joint.type == JointType::kRolling && joint.source.given("axis2") && cosine > kSameDirection)
      findings.error(joint.source, "axis2",
                     "is parallel to axis: the disc lies flat; expected it to stand on its edge");
    if (traits.radius == KeyUse::kUnused && joint.radius)
      findings.error(joint.source, "radius", "means nothing for this type of joint; leave it out");
    if (traits.axis2 == KeyUse::kUnused && joint.source.given("axis2"))
      findings.error(joint.source, "axis2", "means nothing for this type of joint; leave it out");
    if (traits.length == KeyUse::kUnused && joint.source.given("length"))
      findings.error(joint.source, "length", "means nothing for this type of joint; leave it out");
  }
}

}  // namespace footfall
