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

void check_coordinate(const JointSpec& joint, const std::string& key, bool has, const std::optional<CoordinateSpec>& c,
                      Findings& findings) {
  if (!c) return;
  const std::string type(name_of(joint.type));
  if (!has)
    findings.error(joint.source, key,
                   "is no coordinate of a " + type + " joint; expected " +
                       (key == "angle" ? "a revolute or cylindrical" : "a prismatic or cylindrical") + " joint");
  if (!c->stops && !c->friction && !c->spring)
    findings.error(joint.source, key, "has nothing that acts; give at least one of stops, friction, spring");
  if (c->stops) {
    if (!c->stops->min && !c->stops->max)
      findings.error(joint.source, key + ".stops", "limit nothing; give min, max or both");
    if (c->stops->min && c->stops->max && *c->stops->min >= *c->stops->max)
      findings.error(joint.source, key + ".stops.max", "is not above min");
  }
  if (c->friction && c->friction->breakaway && *c->friction->breakaway < c->friction->coulomb)
    findings.error(joint.source, key + ".friction.breakaway",
                   "is " + number_text(*c->friction->breakaway) + ", less than coulomb " +
                       number_text(c->friction->coulomb) + "; what holds at rest is at least what slides");
  if (c->spring && c->spring->stiffness == 0.0 && c->spring->damping == 0.0)
    findings.error(joint.source, key + ".spring", "has neither stiffness nor damping");
}

// The joint exists and leaves the coordinate free.
void check_place(const Scene& scene, const DriveSpec& drive, Findings& findings) {
  if (drive.joint.empty()) return;
  const JointSpec* found = find_joint(scene, drive.source, "joint", drive.joint, findings);
  if (!found) return;
  const JointTraits traits = traits_of(found->type);
  const std::string type(traits.name);
  if (!traits.turns && !traits.slides) {
    findings.error(drive.source, "joint",
                   "\"" + drive.joint + "\" is " + type +
                       "; a drive moves the angle or the displacement of a revolute, prismatic or cylindrical joint");
    return;
  }
  if (drive.coordinate == CoordinateChoice::kAuto) {
    if (traits.turns && traits.slides)
      findings.error(drive.source, "coordinate",
                     "is missing; a " + type + " joint has two, expected \"angle\" or \"displacement\"");
    return;
  }
  if (drive.coordinate == CoordinateChoice::kAngle ? !traits.turns : !traits.slides)
    findings.error(drive.source, "coordinate",
                   "is \"" + std::string(name_of(drive.coordinate)) + "\", which a " + type + " joint does not have");
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

void check_initial_joints(const Scene& scene, Findings& findings) {
  for (const InitialJointSpec& given : scene.initial.joints) {
    const JointSpec* joint = find_joint(scene, given.source, "", given.name, findings);
    if (!joint) continue;
    const JointTraits traits = traits_of(joint->type);
    const std::string type(traits.name);
    if (given.angle && !traits.turns) findings.error(given.source, "angle", "is no coordinate of a " + type + " joint");
    if (given.angle && std::abs(*given.angle) > kPi)
      findings.error(given.source, "angle",
                     "is " + number_text(*given.angle * 180.0 / kPi, 6) +
                         " degrees; expected at most half a turn: what acts on the angle counts its turns from there");
    if (given.displacement && !traits.slides)
      findings.error(given.source, "displacement", "is no coordinate of a " + type + " joint");
    if (!given.angle && !given.displacement)
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
    if (!joint.source.given("type")) continue;
    check_coordinate(joint, "angle", traits_of(joint.type).turns, joint.angle, findings);
    check_coordinate(joint, "displacement", traits_of(joint.type).slides, joint.displacement, findings);
  }
  check_unique_names(scene.drives, "drive", findings);
  for (const DriveSpec& drive : scene.drives) {
    if (!drive.source.given("kind")) continue;
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
