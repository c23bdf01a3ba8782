#include "mbd_solver/cli/rigs/rig_checks.h"

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/experiments/table.h"

namespace footfall {

namespace {

constexpr int kRigDigits = 12;

std::string list_text(const std::vector<double>& values, double factor) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(number_text(factor * value, kRigDigits));
  return "[" + joined(texts, ",") + "]";
}

// c_k / 2^k.
std::string slower(std::vector<double> polynomial) {
  double factor = 1.0;
  for (double& c : polynomial) c *= factor, factor *= 0.5;
  return list_text(polynomial, 1.0);
}

RigCheck half_speed(const Scene& scene) {
  RigCheck half{"half speed", {"end_time=" + number_text(2.0 * scene.end_time, kRigDigits)}};
  const bool box = scene.particles && scene.particles->box;
  if (box && scene.particles->box->frames > 0.0)
    half.settings.push_back("particles.box.frames=" + number_text(2.0 * scene.particles->box->frames, kRigDigits));
  for (const JointSpec& joint : scene.joints) {
    if (!joint.motion) continue;
    const MotionSpec& motion = *joint.motion;
    const std::pair<const char*, const std::optional<TimeFunctionSpec>&> parts[] = {
        {"x", motion.x}, {"y", motion.y}, {"z", motion.z}, {"rotation", motion.rotation}};
    for (const auto& [key, f] : parts) {
      if (!f) continue;
      if (!f->table.empty() || f->amplitude != 0.0)
        throw InputError(scene.file + ": joint \"" + joint.name +
                         "\": --checks can slow down polynomials of time only");
      if (f->polynomial.size() > 1)
        half.settings.push_back("joints." + joint.name + ".motion." + key + ".polynomial=" + slower(f->polynomial));
    }
  }
  return half;
}

std::string times(const Eigen::Vector3d& v, double factor) { return list_text({v.x(), v.y(), v.z()}, factor); }

// Of a bed by numbers; throws InputError for one of a script.
const BoxSpec& box_to_change(const Scene& scene) {
  if (!scene.particles || !scene.particles->box)
    throw InputError("--checks: the bed of " + scene.file +
                     " comes from a script; bed and grains of [particles.box] are what checks change");
  return *scene.particles->box;
}

RigCheck half_grains(const BoxSpec& box) {
  return {"half grains", {"particles.box.radius=" + list_text(box.radius, 0.5)}};
}

std::vector<std::string> twice_the_bed(const BoxSpec& box) {
  std::vector<std::string> settings = {"particles.box.size=" + list_text(box.size, 2.0),
                                       "particles.box.depth=" + number_text(2.0 * box.depth, kRigDigits)};
  if (!box.pit.empty())
    append(settings, {"particles.box.pit=" + list_text(box.pit, 2.0),
                      "particles.box.pit_depth=" + number_text(2.0 * box.pit_depth, kRigDigits)});
  return settings;
}

}  // namespace

std::vector<RigCheck> checks_of(const Scene& scene, bool slow) {
  const BoxSpec& box = box_to_change(scene);
  std::vector<RigCheck> checks = {{"double box", twice_the_bed(box)}, half_grains(box)};
  if (slow) checks.push_back(half_speed(scene));
  return checks;
}

std::vector<RigCheck> checks_of_holding_bodies(const Scene& scene, bool slow) {
  const BoxSpec& box = box_to_change(scene);
  RigCheck twice{"double box", {"end_time=" + number_text(2.0 * scene.end_time, kRigDigits)}};
  for (const BodySpec& body : scene.bodies) {
    if (!body.shape) continue;
    const ShapeSpec& shape = *body.shape;
    const std::string key = "bodies." + body.name + ".";
    if (shape.kind == ShapeKind::kMesh)
      append(twice.settings, {key + "shape.scale=" + number_text(2.0 * shape.scale, kRigDigits),
                              key + "shape.position=" + times(shape.position, 2.0)});
    else  // the lid; its weight is a part of the pressure
      append(twice.settings,
             {key + "shape.size=" + times(shape.size, 2.0), key + "shape.centre=" + times(shape.centre, 2.0),
              key + "mass=" + number_text(4.0 * body.mass, kRigDigits)});
  }
  for (const JointSpec& joint : scene.joints)
    twice.settings.push_back("joints." + joint.name + ".point=" + times(joint.point_a, 2.0));
  for (const ForceSpec& force : scene.forces)
    if (force.force)
      twice.settings.push_back("forces." + force.name + ".force.polynomial=" + list_text(force.force->polynomial, 4.0));
  append(twice.settings, twice_the_bed(box));
  for (const auto& [name, room] : {std::pair("margin", box.margin), std::pair("headroom", box.headroom)})
    if (room)
      twice.settings.push_back(std::string("particles.box.") + name + "=" + number_text(2.0 * *room, kRigDigits));
  std::vector<RigCheck> checks = {twice, half_grains(box)};
  if (slow) checks.push_back(half_speed(scene));
  return checks;
}

}  // namespace footfall
