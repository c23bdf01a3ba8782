// Joints: two bodies, the points and axes that their type needs, no gap, and motions that can be followed.
#include <algorithm>
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/laws/curves.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

namespace {

constexpr double kLargestGap = 1e-6;      // between points that should coincide in D [m]
constexpr double kLargestCosine = 1e-3;   // of the two axes of a universal joint, given by numbers of four digits
constexpr double kSameDirection = 0.999;  // cosine of two axes that count as parallel
constexpr double kOvershoot = 0.05;       // of a spline beyond the range of its values

double degrees(double angle) { return angle * 180.0 / kPi; }

void check_points(const JointSpec& joint, double largest_gap, const EntryFindings& at) {
  const bool both = at.given("point_a") && at.given("point_b");
  const bool may_differ = traits_of(joint.type).points_may_differ;
  if (!at.given("point") && !both) {
    at.error(kMissingKey, "point",
             may_differ ? "is missing; give point_a and point_b"
                        : "is missing; give the joint's point (or point_a and point_b)");
    return;
  }
  const double gap = (joint.point_b - joint.point_a).norm();
  at.error_if(!may_differ && gap > largest_gap, kJointOpen, "point_b",
              "is " + number_text(gap) + " m from point_a: the joint between \"" + joint.bodies[0] + "\" and \"" +
                  joint.bodies[1] + "\" is open; expected points within " + number_text(largest_gap) +
                  " m (initial.largest_gap closes larger gaps)");
  if (joint.type == JointType::kRolling && joint.radius) {
    // The centre of a disc on its edge is lower when the disc leans.
    const double lean = at.given("axis2") ? joint.axis.cross(joint.axis2).norm() : 1.0;
    const double height = joint.axis.dot(joint.point_b - joint.point_a);
    at.error_if(std::abs(height - *joint.radius * lean) > largest_gap, kJointGeometry, "point_b",
                "is " + number_text(height) + " m above the plane, expected " + number_text(*joint.radius * lean) +
                    " m" +
                    (lean < 1.0 ? ", radius times the sine of the angle between axis and axis2" : ", the radius"));
  }
  if (joint.type != JointType::kDistance) return;
  if (gap == 0.0) {
    at.error(kJointGeometry, "point_b", "is the same point as point_a; a distance joint needs two different ones");
  } else if (joint.length && std::abs(*joint.length - gap) > kLargestGap) {
    at.error(kJointGeometry, "length",
             "is " + number_text(*joint.length) + " m, but the points are " + number_text(gap) +
                 " m apart; remove it, or move them");
  }
}

// f(0) [rad], against the reference configuration.
double initial_value(const TimeFunctionSpec& f) {
  double value = f.amplitude * std::sin(f.phase);
  if (!f.polynomial.empty()) value += f.polynomial.front();
  // A spline is continued before its first point: its value is known here only where it passes through t = 0.
  for (const Eigen::Vector2d& row : f.table)
    if (row.x() == 0.0) value += row.y();
  return value;
}

// A spline through points that are not smooth overshoots between them, and continues beyond its last point.
void check_spline(const EntryFindings& at, const std::string& key, const TimeFunctionSpec& f, double end_time) {
  if (f.table.size() < 2) return;
  std::vector<double> times, values;
  for (const Eigen::Vector2d& row : f.table) {
    if (!times.empty() && !(row.x() > times.back())) return;  // reported by check_function
    times.push_back(row.x());
    values.push_back(row.y());
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double range = *most - *least;
  const CubicSpline spline("a table over time", times, values);
  double overshoot = 0.0, when = 0.0;
  constexpr int kSamples = 16;  // of each piece
  for (std::size_t i = 1; i < times.size(); ++i)
    for (int k = 1; k < kSamples; ++k) {
      const double t = times[i - 1] + (times[i] - times[i - 1]) * k / kSamples;
      const double value = spline.at(t).value;
      const double out = std::max({*least - value, value - *most, 0.0});
      if (out <= overshoot) continue;
      overshoot = out;
      when = t;
    }
  if (overshoot > kOvershoot * range && range > 0.0)
    at.warning(kSplineOvershoot, key + ".table",
               "the smooth curve through the points leaves their range by " + number_text(overshoot, 3) + " at " +
                   number_text(when, 3) + " s; give more points where the motion begins and ends");
  const double speed = spline.at(times.back()).slope;
  const double beyond = std::abs(speed) * (end_time - times.back());
  if (end_time > times.back() && beyond > kOvershoot * range)
    at.warning(kMotionContinues, key + ".table",
               "ends at " + number_text(times.back(), 4) + " s; until " + number_text(end_time, 4) +
                   " s the motion continues at its last speed, " + number_text(speed, 3) +
                   " per s; give more points, the last ones equal where the motion should rest");
}

void check_motion(const JointSpec& joint, double end_time, const EntryFindings& at) {
  if (traits_of(joint.type).motion == KeyUse::kUnused) {
    at.error_if(joint.motion.has_value(), kMotion, "motion", "belongs to joints of type \"prescribed\"; remove it");
  } else {
    const bool any = joint.motion && (joint.motion->x || joint.motion->y || joint.motion->z || joint.motion->rotation);
    at.error_if(!any, kMotion, "motion",
                "prescribes nothing; expected at least one of x, y, z, rotation, for example motion = { z = { "
                "polynomial = [0, -0.1] } }");
    at.error_if(joint.motion && joint.motion->hold_other_rotations && !joint.motion->rotation, kNeedsOtherKey,
                "motion.hold_other_rotations",
                "needs a prescribed rotation, for example rotation = { polynomial = [0] }");
  }
  if (!joint.motion) return;
  const MotionSpec& m = *joint.motion;
  for (const auto& [name, function] : {std::pair("x", &m.x), {"y", &m.y}, {"z", &m.z}, {"rotation", &m.rotation}}) {
    const std::string key = std::string("motion.") + name;
    check_function(at, key, *function);
    if (!*function) continue;
    check_spline(at, key, **function, end_time);
    at.error_if(!(*function)->signal.empty(), kMotion, key + ".signal",
                "has no two derivatives, which a motion needs; use a [[drives]] entry of kind \"position\"");
  }
  // sin(angle - f) = 0 is also fulfilled half a turn away.
  if (m.rotation && !(std::cos(initial_value(*m.rotation)) > 0.0))
    at.error(kMotionStart, "motion.rotation",
             "begins at " + number_text(degrees(initial_value(*m.rotation)), 4) +
                 " degrees from the reference configuration, expected less than 90; draw the bodies as they start, and "
                 "count the rotation from there");
}

// The directions that a joint prescribes, with their names.
std::vector<std::pair<std::string, Eigen::Vector3d>> displacements(const JointSpec& joint) {
  const Eigen::Vector3d z = joint.axis;
  const Eigen::Vector3d x = (joint.axis2 - joint.axis2.dot(z) * z).normalized();
  std::vector<std::pair<std::string, Eigen::Vector3d>> out;
  if (joint.motion->x) out.emplace_back("x", x);
  if (joint.motion->y) out.emplace_back("y", z.cross(x));
  if (joint.motion->z) out.emplace_back("z", z);
  return out;
}

// Two motions of the same coordinate of the same two bodies: one of them would be dropped as redundant.
void check_motion_twice(const JointSpec& first, const JointSpec& second, Findings& findings) {
  const bool same_pair =
      first.bodies == second.bodies || (first.bodies[0] == second.bodies[1] && first.bodies[1] == second.bodies[0]);
  if (!first.motion || !second.motion || !same_pair) return;
  const auto report = [&](const std::string& key) {
    findings.error(kMotionTwice, second.source, "motion." + key,
                   "is already prescribed by joint \"" + first.name + "\" (line " + std::to_string(first.source.line) +
                       ") between the same two bodies; keep one of them");
  };
  if (first.motion->rotation && second.motion->rotation && std::abs(first.axis.dot(second.axis)) > kSameDirection)
    report("rotation");
  if ((first.point_b - second.point_b).norm() > kLargestGap) return;
  for (const auto& [name_1, direction_1] : displacements(first))
    for (const auto& [name_2, direction_2] : displacements(second))
      if (std::abs(direction_1.dot(direction_2)) > kSameDirection) report(name_2);
}

void check_axes(const JointSpec& joint, const EntryFindings& at) {
  const JointTraits traits = traits_of(joint.type);
  const double cosine = std::abs(joint.axis.dot(joint.axis2));
  at.missing_if(traits.axis == KeyUse::kRequired && !at.given("axis"), "axis", "this type of joint needs it");
  at.missing_if(traits.axis2 == KeyUse::kRequired && !at.given("axis2"), "axis2",
                "a " + std::string(traits.name) + " joint has a second axis, fixed in \"" + joint.bodies[1] + "\"");
  at.error_if(joint.type == JointType::kUniversal && cosine > kLargestCosine, kJointGeometry, "axis2",
              "makes " + number_text(degrees(std::acos(std::min(1.0, cosine)))) + " degrees with axis, expected 90");
  const bool has_x = joint.type == JointType::kPrescribed || (joint.type == JointType::kPlanar && at.given("axis2"));
  at.error_if(has_x && cosine > kSameDirection, kJointGeometry, "axis2",
              "is parallel to axis, expected the x direction of the joint, perpendicular to its z = axis");
  at.error_if(joint.type == JointType::kRolling && at.given("axis2") && cosine > kSameDirection, kJointGeometry,
              "axis2", "is parallel to axis, so the disc lies flat; expected a disc on its edge");
  at.missing_if(traits.radius == KeyUse::kRequired && !joint.radius, "radius", "the radius of the wheel [m]");
  for (const auto& [key, use] :
       {std::pair("radius", traits.radius), {"axis2", traits.axis2}, {"length", traits.length}})
    at.no_effect_if(use == KeyUse::kUnused && at.source().good(key), key, "this type of joint");
}

}  // namespace

void check_function(const EntryFindings& at, const std::string& key, const std::optional<TimeFunctionSpec>& f) {
  if (!f) return;
  at.missing_if(f->amplitude != 0.0 && f->frequency == 0.0, key + ".frequency",
                "an amplitude needs it (Hz). For a constant use polynomial = [value]");
  for (std::size_t i = 1; i < f->table.size(); ++i) {
    if (f->table[i].x() > f->table[i - 1].x()) continue;
    at.error(kNotRising, key + ".table",
             "has time " + number_text(f->table[i].x()) + " s after " + number_text(f->table[i - 1].x()) +
                 " s, expected rising times");
    break;
  }
}

void check_joints(const Scene& scene, Findings& findings) {
  check_unique_names(scene.joints, "joint", findings);
  for (const JointSpec& joint : scene.joints) {
    if (!joint.source.good("type")) continue;
    const EntryFindings at(findings, joint.source);
    check_pair(scene, at, joint.bodies);
    check_points(joint, scene.initial.largest_gap, at);
    check_motion(joint, scene.end_time, at);
    for (const JointSpec& before : scene.joints) {
      if (&before == &joint) break;
      check_motion_twice(before, joint, findings);
    }
    check_axes(joint, at);
  }
}

}  // namespace footfall
