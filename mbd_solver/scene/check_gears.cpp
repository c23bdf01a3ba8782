// Gears: joints that exist and have the coordinate, a factor for each, and the curve of a cam.
#include <algorithm>
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

namespace {

// The joint of this index exists and leaves its coordinate free.
void check_member(const Scene& scene, const GearSpec& gear, std::size_t i, const EntryFindings& at) {
  const JointSpec* joint = find_joint(scene, at, "joints", gear.joints[i]);
  if (!joint) return;
  const std::vector<Coordinate> has = coordinates_of(joint->type);
  const std::string type(name_of(joint->type)), name = "\"" + joint->name + "\"";
  if (has.empty()) {
    at.error(kUnknownCoordinate, "joints",
             name + " is " + type +
                 "; a gear connects angles and displacements of revolute, prismatic, cylindrical or planar joints");
    return;
  }
  const std::string choice = i < gear.coordinates.size() ? gear.coordinates[i] : "auto";
  const std::string expected = "; expected " + coordinate_names(joint->type);
  if (choice != "auto" && !is_in(names_of<Coordinate>(), choice)) {
    at.error(kUnknownCoordinate, "coordinates",
             "contains \"" + choice + "\"" + expected + (has.size() == 1 ? " or \"auto\"" : "") + " for " + name);
  } else if (choice == "auto" && has.size() > 1) {
    at.error(kAmbiguousCoordinate, "coordinates",
             name + " is " + type + " and has " + (has.size() == 2 ? "two" : "three") + expected +
                 " for it, for example [\"" + (i == 0 ? "angle\", \"auto" : "auto\", \"angle") + "\"]");
  } else if (choice != "auto" &&
             std::none_of(has.begin(), has.end(), [&](Coordinate c) { return name_of(c) == choice; })) {
    at.error(kUnknownCoordinate, "coordinates",
             "contains \"" + choice + "\" for " + name + ", which a " + type + " joint does not have" + expected);
  }
  for (std::size_t k = 0; k < i; ++k) {
    const std::string before = k < gear.coordinates.size() ? gear.coordinates[k] : "auto";
    at.error_if(gear.joints[k] == gear.joints[i] && before == choice, kListedTwice, "joints",
                name + " is listed twice with the same coordinate; list it once with the sum of its factors");
  }
}

// The last joint moves the cam.
void check_cam(const Scene& scene, const GearSpec& gear, const EntryFindings& at) {
  const std::vector<Eigen::Vector2d>& curve = gear.curve;
  if (curve.empty()) {
    at.error_if(at.given("closed"), kNeedsOtherKey, "closed", "describes a curve; give `curve` as well");
    return;
  }
  if (gear.closed && curve.size() < 3) {
    at.error(kWrongCount, "curve", "is closed and has 2 points, expected at least 3");
    return;
  }
  at.error_if(gear.closed && curve.front()[1] != curve.back()[1], kCamCurve, "curve",
              "is closed, but begins with the value " + number_text(curve.front()[1]) + " and ends with " +
                  number_text(curve.back()[1]) + "; expected the same value at both ends");
  if (gear.joints.empty() || !find_joint(scene, at, "joints", gear.joints.back())) return;
  if (scene.coordinate_of(gear, gear.joints.size() - 1) != Coordinate::kAngle) return;
  const double span = curve.back()[0] - curve.front()[0];
  at.error_if(gear.closed ? std::abs(span - 2.0 * kPi) > 1e-3 : span > 2.0 * kPi + 1e-3, kCamCurve, "curve",
              "spans " + number_text(span) + " rad; expected " +
                  (gear.closed ? "one turn of a closed curve, 2 pi" : "at most one turn, 2 pi, of an angle"));
}

}  // namespace

void check_gears(const Scene& scene, Findings& findings) {
  check_unique_names(scene.gears, "gear", findings);
  for (const GearSpec& gear : scene.gears) {
    const EntryFindings at(findings, gear.source);
    const std::size_t joints = gear.joints.size();
    const auto one_for_each = [&](std::size_t count) {
      return "has " + std::to_string(count) + " entries for " + std::to_string(joints) +
             " joints; expected one for each";
    };
    for (const JointSpec& joint : scene.joints)
      at.error_if(!gear.name.empty() && joint.name == gear.name, kDuplicateName, "name",
                  "is also that of a joint (line " + std::to_string(joint.source.line) + "); names must differ");
    if (at.given("joints")) {
      at.error_if(joints < 2, kWrongCount, "joints",
                  "contains " + std::to_string(joints) + " names, expected two or more");
      for (std::size_t i = 0; i < joints; ++i) check_member(scene, gear, i, at);
    }
    at.error_if(at.given("joints") && at.given("factors") && gear.factors.size() != joints, kWrongCount, "factors",
                one_for_each(gear.factors.size()) + ": the sum of factor times coordinate stays zero");
    at.error_if(!gear.coordinates.empty() && gear.coordinates.size() != joints, kWrongCount, "coordinates",
                one_for_each(gear.coordinates.size()));
    check_cam(scene, gear, at);
    for (const double factor : gear.factors)
      at.error_if(factor == 0.0, kGearFactor, "factors",
                  "contains 0; remove that joint, or give its radius or number of teeth");
  }
}

}  // namespace footfall
