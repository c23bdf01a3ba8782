// Gears: joints that exist and have the coordinate, a factor for each.
#include <algorithm>
#include <cmath>

#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

namespace {

// The joint of this index exists and leaves its coordinate free.
void check_member(const Scene& scene, const GearSpec& gear, std::size_t i, Findings& findings) {
  const JointSpec* joint = find_joint(scene, gear.source, "joints", gear.joints[i], findings);
  if (!joint) return;
  const std::vector<CoordinateChoice> has = coordinates_of(joint->type);
  const std::string type(name_of(joint->type)), name = "\"" + joint->name + "\"";
  if (has.empty()) {
    findings.error(
        gear.source, "joints",
        name + " is " + type +
            "; a gear connects angles and displacements of revolute, prismatic, cylindrical or planar joints");
    return;
  }
  const std::string choice = i < gear.coordinates.size() ? gear.coordinates[i] : "auto";
  const auto named = [&](CoordinateChoice c) { return name_of(c) == choice; };
  const std::vector<std::string> known = names_of<CoordinateChoice>();
  if (std::find(known.begin(), known.end(), choice) == known.end()) {
    findings.error(gear.source, "coordinates",
                   "has \"" + choice + "\"; expected " + coordinate_names(joint->type) +
                       (has.size() == 1 ? " or \"auto\"" : "") + " for " + name);
  } else if (choice == "auto" && has.size() > 1) {
    findings.error(gear.source, "coordinates",
                   name + " is " + type + " and has " + (has.size() == 2 ? "two" : "three") + "; expected " +
                       coordinate_names(joint->type) + " for it, for example [\"" +
                       (i == 0 ? "angle\", \"auto" : "auto\", \"angle") + "\"]");
  } else if (choice != "auto" && std::none_of(has.begin(), has.end(), named)) {
    findings.error(gear.source, "coordinates",
                   "has \"" + choice + "\" for " + name + ", which a " + type + " joint does not have; expected " +
                       coordinate_names(joint->type));
  }
  const std::size_t last = std::min(i, gear.coordinates.size());
  for (std::size_t k = 0; k < i; ++k) {
    if (gear.joints[k] != gear.joints[i]) continue;
    const std::string before = k < last ? gear.coordinates[k] : "auto";
    if (before == choice)
      findings.error(gear.source, "joints", name + " stands there twice with the same coordinate; add up its factors");
  }
}

// The last joint turns or pushes the cam.
void check_cam(const Scene& scene, const GearSpec& gear, Findings& findings) {
  const std::vector<Eigen::Vector2d>& curve = gear.curve;
  if (curve.empty()) {
    if (gear.source.given("closed"))
      findings.error(gear.source, "closed", "says how a curve goes on; give `curve` too");
    return;
  }
  if (gear.closed && curve.size() < 3) {
    findings.error(gear.source, "curve", "is closed and has 2 points, expected at least 3");
    return;
  }
  if (gear.closed && curve.front()[1] != curve.back()[1])
    findings.error(gear.source, "curve",
                   "is closed, but begins with the value " + number_text(curve.front()[1]) + " and ends with " +
                       number_text(curve.back()[1]) + "; expected the same value at both ends");
  if (gear.joints.empty() || !find_joint(scene, gear.source, "joints", gear.joints.back(), findings)) return;
  if (scene.coordinate_of(gear, gear.joints.size() - 1) != CoordinateChoice::kAngle) return;
  const double span = curve.back()[0] - curve.front()[0];
  if (gear.closed ? std::abs(span - 2.0 * kPi) > 1e-3 : span > 2.0 * kPi + 1e-3)
    findings.error(gear.source, "curve",
                   "spans " + number_text(span) + " rad; expected " +
                       (gear.closed ? "one turn of a closed curve, 2 pi" : "at most one turn, 2 pi, of an angle"));
}

}  // namespace

void check_gears(const Scene& scene, Findings& findings) {
  check_unique_names(scene.gears, "gear", findings);
  for (const GearSpec& gear : scene.gears) {
    for (const JointSpec& joint : scene.joints)
      if (!gear.name.empty() && joint.name == gear.name)
        findings.error(gear.source, "name",
                       "is that of a joint (line " + std::to_string(joint.source.line) + "); names must differ");
    if (gear.source.given("joints")) {
      if (gear.joints.size() < 2)
        findings.error(gear.source, "joints", "names " + std::to_string(gear.joints.size()) + ", expected two or more");
      for (std::size_t i = 0; i < gear.joints.size(); ++i) check_member(scene, gear, i, findings);
    }
    if (gear.source.given("joints") && gear.source.given("factors") && gear.factors.size() != gear.joints.size())
      findings.error(gear.source, "factors",
                     "has " + std::to_string(gear.factors.size()) + " numbers for " +
                         std::to_string(gear.joints.size()) +
                         " joints; expected one for each: the sum of factor times coordinate stays zero");
    if (!gear.coordinates.empty() && gear.coordinates.size() != gear.joints.size())
      findings.error(gear.source, "coordinates",
                     "has " + std::to_string(gear.coordinates.size()) + " for " + std::to_string(gear.joints.size()) +
                         " joints; expected one for each");
    check_cam(scene, gear, findings);
    for (const double factor : gear.factors)
      if (factor == 0.0)
        findings.error(gear.source, "factors", "has a 0; leave that joint out, or give it the radius or teeth it has");
  }
}

}  // namespace footfall
