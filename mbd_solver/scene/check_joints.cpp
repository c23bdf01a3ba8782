// Joints: two bodies, the points and axes their type needs, and no gap.
#include <cmath>

#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

namespace {

constexpr double kLargestGap = 1e-6;  // of the points of a joint in the drawing [m]; projection would move bodies by it
constexpr double kLargestCosine = 1e-3;  // of the two axes of a universal joint, as numbers of four digits give it

void check_points(const JointSpec& joint, Findings& findings) {
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
  if (!may_differ && gap > kLargestGap) {
    findings.error(source, "point_b",
                   "the joint is open by " + number_text(gap) + " m between \"" + joint.bodies[0] + "\" and \"" +
                       joint.bodies[1] + "\"; expected points within " + number_text(kLargestGap) +
                       " m in the design position");
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

}  // namespace

void check_joints(const Scene& scene, Findings& findings) {
  check_unique_names(scene.joints, "joint", findings);
  for (const JointSpec& joint : scene.joints) {
    if (!joint.source.given("type")) continue;
    check_pair(scene, joint.source, joint.bodies, findings);
    check_points(joint, findings);
    check_motion(joint, findings);
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
    if (joint.type == JointType::kPrescribed && cosine > 0.999)
      findings.error(joint.source, "axis2",
                     "is parallel to axis; expected the x direction of the joint, across its z = axis");
    if (traits.axis2 == KeyUse::kUnused && joint.source.given("axis2"))
      findings.error(joint.source, "axis2", "means nothing for this type of joint; leave it out");
    if (traits.length == KeyUse::kUnused && joint.source.given("length"))
      findings.error(joint.source, "length", "means nothing for this type of joint; leave it out");
  }
}

}  // namespace footfall
