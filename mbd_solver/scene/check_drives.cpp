// What acts on the coordinates of joints: stops, friction, springs, drives.
#include <algorithm>
#include <cmath>

#include "coupler/base/nearest_name.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/kind_keys.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

namespace {

// Types of joints that have this coordinate.
std::string joints_with(CoordinateChoice coordinate) {
  std::vector<std::string> names;
  for (const JointType type : every<JointType>())
    if (has_coordinate(type, coordinate)) names.emplace_back(name_of(type));
  return joined(names, " or ");
}

std::string no_coordinate(CoordinateChoice coordinate, JointType type) {
  const std::string names = coordinate_names(type);
  return "is no coordinate of a " + std::string(name_of(type)) + " joint; expected " +
         (names.empty() ? "" : names + " of it, or ") + "a joint of type " + joints_with(coordinate);
}

Unit unit_of(CoordinateChoice coordinate) {
  return coordinate == CoordinateChoice::kAngle ? Unit::kAngle : Unit::kLength;
}

void check_coordinate(const JointSpec& joint, CoordinateChoice coordinate, Findings& findings) {
  const std::optional<CoordinateSpec>& c = joint.acting_on(coordinate);
  if (!c) return;
  const std::string key(name_of(coordinate));
  if (!has_coordinate(joint.type, coordinate)) findings.error(joint.source, key, no_coordinate(coordinate, joint.type));
  if (!c->stops && !c->friction && !c->spring)
    findings.error(joint.source, key, "has nothing that acts; give at least one of stops, friction, spring");
  if (c->stops) {
    if (!c->stops->min && !c->stops->max)
      findings.error(joint.source, key + ".stops", "limit nothing; give min, max or both");
    if (c->stops->min && c->stops->max)
      check_min_below_max(joint.source, key + ".stops.", *c->stops->min, *c->stops->max, unit_of(coordinate), findings);
  }
  if (c->friction && c->friction->breakaway && *c->friction->breakaway < c->friction->coulomb)
    findings.error(joint.source, key + ".friction.breakaway",
                   "is " + number_text(*c->friction->breakaway) + ", less than coulomb " +
                       number_text(c->friction->coulomb) + "; what holds at rest is at least what slides");
  if (c->spring && c->spring->stiffness == 0.0 && c->spring->damping == 0.0)
    findings.error(joint.source, key + ".spring", "has neither stiffness nor damping");
}

// "20 degrees", "0.01 m".
std::string value_text(double value, Unit unit) {
  if (unit == Unit::kAngle) return number_text(value * 180.0 / kPi) + " degrees";
  return number_text(value) + (unit == Unit::kLength ? " m" : "");
}

void warn_of_start_beyond_stops(const JointSpec& joint, const InitialJointSpec& given, CoordinateChoice coordinate,
                                Findings& findings) {
  const std::optional<CoordinateSpec>& c = joint.acting_on(coordinate);
  if (!c || !c->stops) return;
  const double value = *given.value(coordinate);
  const bool below = c->stops->min && value < *c->stops->min, above = c->stops->max && value > *c->stops->max;
  if (!below && !above) return;
  const Unit unit = unit_of(coordinate);
  findings.warning(given.source, std::string(name_of(coordinate)),
                   "starts joint \"" + joint.name + "\" at " + value_text(value, unit) + ", beyond its stop at " +
                       value_text(below ? *c->stops->min : *c->stops->max, unit) +
                       ": the stop throws it back at once; start it within, or move the stop");
}

// The joint exists and leaves the coordinate free.
void check_place(const Scene& scene, const DriveSpec& drive, Findings& findings) {
  if (drive.joint.empty()) return;
  const JointSpec* found = find_joint(scene, drive.source, "joint", drive.joint, findings);
  if (!found) return;
  const std::string type(name_of(found->type));
  const std::vector<CoordinateChoice> has = coordinates_of(found->type);
  if (has.empty()) {
    findings.error(drive.source, "joint",
                   "\"" + drive.joint + "\" is " + type +
                       "; a drive moves the angle or the displacement of a revolute, prismatic, cylindrical or planar "
                       "joint");
    return;
  }
  if (drive.coordinate == CoordinateChoice::kAuto) {
    if (has.size() > 1)
      findings.error(drive.source, "coordinate",
                     "is missing; a " + type + " joint has " + (has.size() == 2 ? "two" : "three") + ", expected " +
                         coordinate_names(found->type));
    return;
  }
  if (!has_coordinate(found->type, drive.coordinate))
    findings.error(drive.source, "coordinate",
                   "is \"" + std::string(name_of(drive.coordinate)) + "\", which a " + type +
                       " joint does not have; expected " + coordinate_names(found->type));
}

}  // namespace

const JointSpec* find_joint(const Scene& scene, const Source& source, const std::string& key, const std::string& name,
                            Findings& findings) {
  std::vector<std::string> names;
  for (const JointSpec& joint : scene.joints) names.push_back(joint.name);
  const auto found =
      std::find_if(scene.joints.begin(), scene.joints.end(), [&](const JointSpec& j) { return j.name == name; });
  if (found != scene.joints.end()) return &*found;
  findings.error(source, key, "unknown joint \"" + name + "\"." + known_names("joints", name, names));
  return nullptr;
}

void check_min_below_max(const Source& source, const std::string& within, double min, double max, Unit unit,
                         Findings& findings) {
  if (min < max) return;
  // The one that --set gave is the one to look at.
  const bool of_min = source.line_of(within + "min") == Source::kFromSet && source.line_of(within + "max") > 0;
  const double mine = of_min ? min : max, other = of_min ? max : min;
  findings.error(source, within + (of_min ? "min" : "max"),
                 "is " + value_text(mine, unit) + ", not " + (of_min ? "below max, " : "above min, ") +
                     value_text(other, unit) + "; give a smaller min or a larger max");
}

void check_initial_joints(const Scene& scene, Findings& findings) {
  for (const InitialJointSpec& given : scene.initial.joints) {
    const JointSpec* joint = find_joint(scene, given.source, "", given.name, findings);
    if (!joint) continue;
    bool empty = true;
    for (const CoordinateChoice coordinate : every<CoordinateChoice>()) {
      if (!given.value(coordinate)) continue;
      empty = false;
      if (!has_coordinate(joint->type, coordinate))
        findings.error(given.source, std::string(name_of(coordinate)), no_coordinate(coordinate, joint->type));
      warn_of_start_beyond_stops(*joint, given, coordinate, findings);
    }
    if (given.angle && std::abs(*given.angle) > kPi)
      findings.error(given.source, "angle",
                     "is " + number_text(*given.angle * 180.0 / kPi, 6) +
                         " degrees; expected at most half a turn: what acts on the angle counts its turns from there");
    if (empty && given.source.refused.empty())
      findings.error(given.source, "", "is empty; expected angle or displacement, for example angle_deg = 30");
  }
  if (scene.initial.settle) {
    if (scene.touches_particles())
      findings.error(scene.initial.source, "settle",
                     "works without grains; settle the mechanism on a plane, or leave it out");
    const bool moves = !scene.initial.velocity.isZero(0.0) || !scene.initial.angular_velocity.isZero(0.0) ||
                       !scene.initial.bodies.empty();
    if (moves)
      findings.error(scene.initial.source, "settle", "starts at rest, but velocities are given; leave one of them out");
  }
  if (!scene.initial.joints.empty() && scene.initial.clearance)
    findings.warning(
        scene.initial.source, "clearance",
        "counts from the drawing, before [initial.joints] moves the bodies; the gap to the ground is another");
}

void check_drives(const Scene& scene, Findings& findings) {
  for (const JointSpec& joint : scene.joints) {
    if (!joint.source.good("type")) continue;
    for (const CoordinateChoice coordinate : every<CoordinateChoice>()) check_coordinate(joint, coordinate, findings);
  }
  check_unique_names(scene.drives, "drive", findings);
  for (const DriveSpec& drive : scene.drives) {
    if (!drive.source.good("kind")) continue;
    check_place(scene, drive, findings);
    check_function(drive.source, "command", drive.command, findings);
    if (drive.command) check_signal_name(scene, drive.source, "command.signal", drive.command->signal, findings);
    if (!drive.command)
      findings.error(drive.source, "command", "is missing, for example command = { polynomial = [0, 0.5] }");
    for (const std::string& key : foreign_keys(drive.kind))
      if (drive.source.written_together("kind", key))
        findings.error(drive.source, key, "means nothing for this kind of drive; leave it out");
    if (drive.kind == MotorKind::kBrake && !drive.max_torque)
      findings.error(drive.source, "max_torque", "is missing; a brake slides at it, and holds up to it (N m)");
    if ((drive.kind == MotorKind::kSpeed || drive.kind == MotorKind::kPosition) && !(drive.kp > 0.0))
      findings.error(drive.source, "kp", "is missing; a drive that holds a speed or a position needs it");
    if (!(drive.efficiency > 0.0)) findings.error(drive.source, "efficiency", "is 0; expected more than 0, at most 1");
    if (drive.max_speed && !drive.max_torque)
      findings.error(drive.source, "max_torque",
                     "is missing; the torque falls from it at rest to nothing at max_speed");
  }
}

}  // namespace footfall
