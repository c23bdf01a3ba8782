// What acts on the coordinates of joints: stops, friction, springs, drives; and where the coordinates start.
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

namespace {

// "is no coordinate of a spherical joint; expected a joint of type revolute or cylindrical".
std::string no_coordinate(Coordinate coordinate, JointType type) {
  std::vector<std::string> types;
  for (const JointType other : every<JointType>())
    if (has_coordinate(other, coordinate)) types.emplace_back(name_of(other));
  const std::string names = coordinate_names(type);
  return "is no coordinate of a " + std::string(name_of(type)) + " joint; expected " +
         (names.empty() ? "" : names + " of it, or ") + "a joint of type " + joined(types, " or ");
}

Unit unit_of(Coordinate coordinate) { return coordinate == Coordinate::kAngle ? Unit::kAngle : Unit::kLength; }

// "20 degrees", "0.01 m".
std::string value_text(double value, Unit unit) {
  if (unit == Unit::kAngle) return number_text(value * 180.0 / kPi) + " degrees";
  return number_text(value) + (unit == Unit::kLength ? " m" : "");
}

void check_coordinate(const JointSpec& joint, Coordinate coordinate, const EntryFindings& at) {
  const std::optional<CoordinateSpec>& c = joint.acting_on(coordinate);
  if (!c) return;
  const std::string key(name_of(coordinate));
  if (!has_coordinate(joint.type, coordinate)) at.error(kUnknownCoordinate, key, no_coordinate(coordinate, joint.type));
  at.error_if(!c->stops && !c->friction && !c->spring, kEmptyEntry, key,
              "has no force law; give at least one of stops, friction, spring");
  if (c->stops) {
    const std::optional<double>&min = c->stops->smallest_stroke, &max = c->stops->largest_stroke;
    at.error_if(!min && !max, kEmptyEntry, key + ".stops", "limit nothing; give min, max or both");
    if (min && max) check_min_below_max(at, key + ".stops.", *min, *max, unit_of(coordinate));
  }
  if (c->friction && c->friction->breakaway && *c->friction->breakaway < c->friction->coulomb)
    at.error(kRangeReversed, key + ".friction.breakaway",
             "is " + number_text(*c->friction->breakaway) + ", expected at least coulomb, " +
                 number_text(c->friction->coulomb));
  at.error_if(c->spring && c->spring->stiffness == 0.0 && c->spring->damping == 0.0, kEmptyEntry, key + ".spring",
              "has neither stiffness nor damping; give one of them");
}

void warn_of_start_beyond_stops(const JointSpec& joint, const InitialJointSpec& given, Coordinate coordinate,
                                const EntryFindings& at) {
  const std::optional<CoordinateSpec>& c = joint.acting_on(coordinate);
  if (!c || !c->stops) return;
  const double value = *given.value(coordinate);
  const std::optional<double>&min = c->stops->smallest_stroke, &max = c->stops->largest_stroke;
  const bool below = min && value < *min;
  if (!below && !(max && value > *max)) return;
  const Unit unit = unit_of(coordinate);
  at.warning(kStartBeyondStop, std::string(name_of(coordinate)),
             "starts joint \"" + joint.name + "\" at " + value_text(value, unit) + ", beyond its stop at " +
                 value_text(below ? *min : *max, unit) +
                 ", which throws it back at once; start it within its stops, or move the stop");
}

// The joint exists and leaves the coordinate free.
void check_coordinate_of(const Scene& scene, const DriveSpec& drive, const EntryFindings& at) {
  if (drive.joint.empty()) return;
  const JointSpec* joint = find_joint(scene, at, "joint", drive.joint);
  if (!joint) return;
  const std::string type(name_of(joint->type)), expected = "; expected " + coordinate_names(joint->type);
  const std::size_t count = coordinates_of(joint->type).size();
  if (count == 0) {
    at.error(kUnknownCoordinate, "joint",
             "\"" + drive.joint + "\" is " + type +
                 "; a drive moves an angle or displacement of a revolute, prismatic, cylindrical or planar joint");
  } else if (!drive.coordinate) {
    at.error_if(count > 1, kAmbiguousCoordinate, "coordinate",
                "is missing; a " + type + " joint has " + (count == 2 ? "two" : "three") + expected);
  } else if (!has_coordinate(joint->type, *drive.coordinate)) {
    at.error(
        kUnknownCoordinate, "coordinate",
        "is \"" + std::string(name_of(*drive.coordinate)) + "\", which a " + type + " joint does not have" + expected);
  }
}

}  // namespace

const JointSpec* find_joint(const Scene& scene, const EntryFindings& at, const std::string& key,
                            const std::string& name) {
  for (const JointSpec& joint : scene.joints)
    if (joint.name == name) return &joint;
  at.error(kUnknownJoint, key, "unknown joint \"" + name + "\"." + known_names("joints", name, names_in(scene.joints)));
  return nullptr;
}

void check_min_below_max(const EntryFindings& at, const std::string& within, double min, double max, Unit unit) {
  if (min < max) return;
  // The finding is about the one that --set gave.
  const Source& source = at.source();
  const bool of_min = source.line_of(within + "min") == Source::kFromSet && source.line_of(within + "max") > 0;
  const double mine = of_min ? min : max, other = of_min ? max : min;
  at.error(kRangeReversed, within + (of_min ? "min" : "max"),
           "is " + value_text(mine, unit) + ", expected " + (of_min ? "less than max, " : "more than min, ") +
               value_text(other, unit));
}

void check_initial_joints(const Scene& scene, Findings& findings) {
  const InitialSpec& initial = scene.initial;
  for (const InitialJointSpec& given : initial.joints) {
    const EntryFindings at(findings, given.source);
    const JointSpec* joint = find_joint(scene, at, "", given.name);
    if (!joint) continue;
    bool empty = true;
    for (const Coordinate coordinate : every<Coordinate>()) {
      if (!given.value(coordinate)) continue;
      empty = false;
      if (!has_coordinate(joint->type, coordinate))
        at.error(kInitialJoint, std::string(name_of(coordinate)), no_coordinate(coordinate, joint->type));
      warn_of_start_beyond_stops(*joint, given, coordinate, at);
    }
    if (given.angle && std::abs(*given.angle) > kPi)
      at.error(kInitialJoint, "angle",
               "is " + number_text(*given.angle * 180.0 / kPi, 6) +
                   " degrees, expected at most half a turn: the laws of this angle count turns from there");
    at.error_if(empty && given.source.refused.empty(), kEmptyEntry, "",
                "is empty; expected angle or displacement, for example angle_deg = 30");
  }
  const EntryFindings at(findings, initial.source);
  if (initial.settle) {
    at.error_if(scene.touches_particles(), kSettle, "settle",
                "is not possible with grains; settle the mechanism on a plane, or remove it");
    const bool moves =
        !initial.velocity.isZero(0.0) || !initial.angular_velocity.isZero(0.0) || !initial.bodies.empty();
    at.error_if(moves, kSettle, "settle", "starts from rest, but velocities are given; remove one of the two");
  }
  if (!initial.joints.empty() && initial.clearance)
    at.warning(kClearance, "clearance",
               "is measured in the reference configuration, before [initial.joints] moves the bodies: the gap at the "
               "start differs from it");
}

void check_drives(const Scene& scene, Findings& findings) {
  for (const JointSpec& joint : scene.joints)
    if (joint.source.good("type"))
      for (const Coordinate coordinate : every<Coordinate>())
        check_coordinate(joint, coordinate, {findings, joint.source});
  check_unique_names(scene.drives, "drive", findings);
  for (const DriveSpec& drive : scene.drives) {
    if (!drive.source.good("kind")) continue;
    const EntryFindings at(findings, drive.source);
    const MotorParameters& motor = drive.motor;
    check_coordinate_of(scene, drive, at);
    check_function(at, "command", drive.command);
    if (drive.command) check_signal_name(scene, at, "command.signal", drive.command->signal);
    at.missing_if(!drive.command, "command", "for example command = { polynomial = [0, 0.5] }");
    check_kind_keys(at, motor.kind, "drive");
    at.missing_if(motor.kind == MotorKind::kBrake && !motor.largest_torque, "max_torque",
                  "the torque at which a brake slides [N m]");
    at.missing_if((motor.kind == MotorKind::kSpeed || motor.kind == MotorKind::kPosition) && !(motor.kp > 0.0), "kp",
                  "a drive that holds a speed or a position needs it");
    at.error_if(!(motor.efficiency > 0.0), kOutOfRange, "efficiency", "is 0, expected more than 0, at most 1");
    at.error_if(motor.no_load_speed && !motor.largest_torque, kNeedsOtherKey, "max_torque",
                "is missing; the torque falls from it at rest to 0 at max_speed");
  }
}

}  // namespace footfall
