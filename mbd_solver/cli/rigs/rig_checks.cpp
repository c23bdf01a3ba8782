#include "mbd_solver/cli/rigs/rig_checks.h"

#include "coupler/base/errors.h"
#include "coupler/base/text.h"

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

}  // namespace

std::vector<RigCheck> checks_of(const Scene& scene, bool slow) {
  const BoxSpec& box = *scene.particles->box;
  std::vector<RigCheck> checks = {{"double box",
                                   {"particles.box.size=" + list_text(box.size, 2.0),
                                    "particles.box.depth=" + number_text(2.0 * box.depth, kRigDigits)}},
                                  {"half grains", {"particles.box.radius=" + list_text(box.radius, 0.5)}}};
  if (!slow) return checks;
  RigCheck half{"half speed", {"end_time=" + number_text(2.0 * scene.end_time, kRigDigits)}};
  if (box.frames > 0.0) half.settings.push_back("particles.box.frames=" + number_text(2.0 * box.frames, kRigDigits));
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
  checks.push_back(half);
  return checks;
}

}  // namespace footfall
