// Keys of a box, or variables of the user's script that set the interval, the modulus and the time step.

#include "mbd_solver/coupling/coupling_advice.h"

#include <cmath>
#include <optional>
#include <regex>

#include "coupler/base/text.h"
#include "mbd_solver/scene/particle_script.h"

namespace footfall {
namespace {

// A variable of the script with a plain number.
struct ScriptNumber {
  std::string name;  // empty: none
  double value = 0.0;
};

// The number in the first command whose text matches; the pattern's first group is the name.
ScriptNumber number_of(const ScriptText& script, const std::string& pattern) {
  const std::regex line(pattern);
  std::smatch match;
  for (const ScriptCommand& command : script.commands()) {
    if (!std::regex_search(command.text, match, line)) continue;
    const std::string name = match[1];
    if (const std::optional<double> value = as_number(script.value(name))) return {name, *value};
  }
  return {};
}

std::string set(const std::string& key, const std::string& value) { return "--set " + key + "=" + value; }
std::string set(const ScriptNumber& number, double factor) {
  return set("particles.variables." + number.name, number_text(factor * number.value, 2));
}
std::string as_typed(const std::string& words) { return "`" + words + "`"; }

std::string interval_of_script(const ParticlesSpec& particles, int n) {
  const ScriptText script(particles.script, particles.variables);
  const ScriptNumber every = number_of(script, R"(couple/mbd\s.*\bevery\s+\$\{?(\w+))");
  const std::string steps = std::to_string(n);
  return as_typed(every.name.empty() ? "every " + steps : set("particles.variables." + every.name, steps));
}

std::string stiffer_script(const ParticlesSpec& particles, double f) {
  const ScriptText script(particles.script, particles.variables);
  const ScriptNumber modulus = number_of(script, R"(youngsModulus\s+peratomtype\s.*?\$\{?(\w+))"),
                     step = number_of(script, R"(^\s*timestep\s+\$\{?(\w+))");
  const std::string times = number_text(f, 2);
  if (modulus.name.empty() || step.name.empty())
    return "multiply Young's modulus of the grains by " + times + " and divide the time step by " +
           number_text(std::sqrt(f), 2);
  return as_typed(set(modulus, f) + " " + set(step, 1.0 / std::sqrt(f))) + " (Young's modulus times " + times + ")";
}

std::string stiffer_box(const BoxSpec& box, double f) {
  std::string words = set("particles.box.material.young", number_text(f * box.material.young, 2));
  if (box.time_step) words += " " + set("particles.box.time_step", number_text(*box.time_step / std::sqrt(f), 2));
  return as_typed(words) + " (Young's modulus times " + number_text(f, 2) + ")";
}

}  // namespace

CouplingAdvice coupling_advice(const Scene& scene, bool chooses_windows) {
  const ParticlesSpec& particles = *scene.particles;
  CouplingAdvice advice;
  if (chooses_windows) {
    advice.interval = [](int n) { return as_typed(set("coupling.max_substeps", std::to_string(n))); };
  } else if (particles.box) {
    advice.interval = [](int n) { return as_typed(set("particles.box.exchange_steps", std::to_string(n))); };
  } else {
    advice.interval = [&particles](int n) { return interval_of_script(particles, n); };
  }
  if (particles.box) {
    advice.shorter_step = "a smaller particles.box.time_step";
    advice.stiffer = [&particles](double f) { return stiffer_box(*particles.box, f); };
  } else {
    advice.shorter_step = "a smaller timestep in the script";
    advice.stiffer = [&particles](double f) { return stiffer_script(particles, f); };
  }
  return advice;
}

}  // namespace footfall
