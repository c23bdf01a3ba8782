// The LIGGGHTS script as text. LIGGGHTS decides in the end; these checks find in milliseconds what would end a run later,
// and what neither program can know by itself.
#include "mbd_solver/scene/check_script.h"

#include <cmath>
#include <filesystem>
#include <optional>

#include "coupler/base/text.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

namespace {

// The time step in force when the coupled grains move. Before the coupling a script may settle its bed with another step;
// a step in an `if` is not known here.
void check_time_step(const ScriptText& script, const ParticlesSpec& particles, Findings& findings) {
  const ScriptCommand* step = nullptr;
  bool coupled = false;
  for (const ScriptCommand& command : script.commands()) {
    if (command.words[0] == "timestep" && command.words.size() > 1)
      step = command.conditional || !as_number(command.words[1]) ? nullptr : &command;
    coupled = coupled || command.is_fix("couple/mbd");
    if (command.words[0] == "run" && coupled) break;
  }
  if (step == nullptr) return;
  const double dt = *as_number(step->words[1]);
  if (dt <= particles.max_time_step * (1.0 + 1e-9)) return;
  findings.error(kScriptTimeStep, particles.source, "max_time_step",
                 "the script's time step is " + number_text(dt) + " s (" + step->place() + "), expected at most " +
                     number_text(particles.max_time_step) +
                     " s: on this kind of soil twice that runs without any message and is wrong by tens of per cent. "
                     "Reduce the time step, or set a larger max_time_step if these grains are known to allow it");
}

// A script that reads a settled bed, and a scene that does not say how it is made.
void check_bed_is_given(const ScriptText& script, const ParticlesSpec& particles, Findings& findings) {
  if (particles.bed || particles.box) return;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] == "write_restart" || w[0] == "restart") return;  // it may be the script's own
    if (w[0] != "read_restart" || w.size() < 2 || command.conditional) continue;
    const bool unknown = w[1].find("${") != std::string::npos;
    std::error_code ignored;
    if (unknown ? w[1].find("${bed}") == std::string::npos : std::filesystem::exists(w[1], ignored)) continue;
    findings.error(kScriptBed, particles.source, "script",
                   command.place() + " reads a settled bed, " + w[1] +
                       (unknown ? ", whose variable has no value" : ", which does not exist") +
                       "; add [particles.bed] with the script that makes it (script = \"in.bed\"), or name a restart "
                       "file: variables = { bed = \"FILE\" }");
  }
}

// LIGGGHTS replaces ${name} until none is left: forever, where a value leads back to its own name.
void check_values(const std::map<std::string, std::string>& variables, const std::string& key,
                  const EntryFindings& at) {
  for (const auto& [name, value] : variables) {
    std::string chain = name;
    const std::string* text = &value;
    for (std::size_t steps = 0; steps <= variables.size(); ++steps) {
      const std::size_t begin = text->find("${"), end = text->find('}', begin);
      if (begin == std::string::npos || end == std::string::npos) break;
      const auto next = variables.find(text->substr(begin + 2, end - begin - 2));
      if (next == variables.end()) break;
      chain += " -> " + next->first;
      if (next->first == name) {
        at.error(kVariableCircle, key + "." + name, "the variable refers to itself: " + chain + "; give it a value");
        return;
      }
      text = &next->second;
    }
  }
}

// A variable that the script does not read has no effect. One that resembles another is misspelt; any other may come from
// the scene's base, for another script.
void check_variables(const ScriptText& script, const std::map<std::string, std::string>& variables,
                     const std::string& key, const EntryFindings& at) {
  const std::vector<std::string> known(script.names().begin(), script.names().end());
  for (const auto& [name, value] : variables) {
    if (script.names().count(name) == 1) continue;
    const std::string what =
        "the script neither declares nor reads this variable." + known_names("variables", name, known);
    if (script.whole() && !nearest_name(name, known).empty())
      at.error(kUnknownVariable, key + "." + name, what);
    else
      at.warning(kUnusedVariable, key + "." + name, what);
  }
}

std::string gravity_text(const Eigen::Vector3d& v) {
  return "[" + number_text(v[0]) + ", " + number_text(v[1]) + ", " + number_text(v[2]) + "] m/s2";
}

// The comparison of the handshake, made before a bed is poured: one fix gravity with plain numbers.
void check_gravity(const ScriptText& script, const Scene& scene, const EntryFindings& at) {
  const ScriptCommand* only = nullptr;
  bool grains_move = false, coupled = false;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (coupled && w[0] == "run" && !command.conditional) break;  // here they are compared
    coupled = coupled || command.is_fix("couple/mbd");
    if (w[0] == "unfix" && only != nullptr && w.size() > 1 && w[1] == only->words[1]) {
      if (command.conditional) return;
      only = nullptr;
    }
    if (command.is_fix("couple/mbd"))
      for (std::size_t i = 4; i + 1 < w.size(); ++i)
        if (w[i] == "gravity" && w[i + 1] == "script") return;
    if (w[0] == "fix" && w.size() > 3 && w[3].find('$') != std::string::npos) return;  // it may be any fix
    grains_move = grains_move || command.is_fix("nve/sphere") || command.is_fix("multisphere");
    if (!command.is_fix("gravity")) continue;
    if (only != nullptr || command.conditional) return;
    only = &command;
  }
  if (only == nullptr && grains_move && script.whole() && script.straight() && !scene.gravity.isZero(0.0)) {
    const Eigen::Vector3d down = scene.gravity.normalized();
    at.warning(kNoGrainGravity, "script",
               "has no fix gravity, so the grains have no weight; the scene's gravity is " +
                   gravity_text(scene.gravity) + ". Add  fix gravity all gravity " + number_text(scene.gravity.norm()) +
                   " vector " + number_text(down[0]) + " " + number_text(down[1]) + " " + number_text(down[2]));
  }
  if (only == nullptr || only->words.size() != 9 || only->words[5] != "vector") return;
  Eigen::Vector3d direction;
  const std::optional<double> size = as_number(only->words[4]);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::optional<double> x = as_number(only->words[6 + c]);
    if (!x) return;
    direction[static_cast<Eigen::Index>(c)] = *x;
  }
  if (!size || direction.isZero(0.0)) return;
  const Eigen::Vector3d g = *size * direction.normalized();
  at.error_if((g - scene.gravity).norm() > 1e-6 * scene.gravity.norm(), kScriptGravity, "script",
              "the gravity of the grains is " + gravity_text(g) + " (" + only->place() + "), that of the scene " +
                  gravity_text(scene.gravity) +
                  "; make them agree, or declare that the grains have their own: fix ID all couple/mbd every N gravity "
                  "script ...");
}

// The words of the last `fix ID all gravity ...` and of the elastic constants, by their meaning. (Friction differs on
// purpose: beds are poured with little of it, to be dense.)
std::map<std::string, std::string> conditions(const ScriptText& script) {
  std::map<std::string, std::string> all;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    std::size_t first = 0;
    if (command.is_fix("gravity")) first = 4;
    if (command.is_fix("property/global") && w.size() > 4 && (w[4] == "youngsModulus" || w[4] == "poissonsRatio"))
      first = 5;
    if (first == 0 || command.conditional) continue;
    std::string text;
    for (std::size_t i = first; i < w.size(); ++i) {
      const std::optional<double> number = as_number(w[i]);
      text += (text.empty() ? "" : " ") + (number ? number_text(*number, 12) : w[i]);
    }
    if (text.find("${") == std::string::npos) all[first == 4 ? "gravity" : w[4]] = text;
  }
  return all;
}

// A cached bed was poured by a script of its own. Gravity and elasticity should be the same in both, and so should every
// variable that both scripts have and the scene sets in one of them; but for the time step, which is the method's.
void compare_with_bed(const ScriptText& script, const ScriptText& bed, const ParticlesSpec& particles,
                      const EntryFindings& at) {
  const auto differs = [&](const std::string& what, const std::string& of_bed, const std::string& of_run) {
    at.warning(kBedDiffers, "bed",
               "the bed is made with " + what + " = " + of_bed + ", the run has " + of_run +
                   ", so the grains do not rest as they would in the run; make them agree unless this is intended");
  };
  const std::map<std::string, std::string> of_bed = conditions(bed), of_run = conditions(script);
  for (const auto& [what, value] : of_bed) {
    const auto other = of_run.find(what);
    if (other != of_run.end() && other->second != value) differs(what, value, other->second);
  }
  for (const std::string& name : bed.names()) {
    const bool set = particles.variables.count(name) == 1 || particles.bed->variables.count(name) == 1;
    if (!set || name == "dt" || name == "gravity") continue;  // gravity is compared above
    const std::optional<double> here = as_number(bed.value(name)), there = as_number(script.value(name));
    if (here && there && *here != *there) differs("variable " + name, bed.value(name), script.value(name));
  }
}

bool is_file(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(name, ignored);
}

// The script and what it includes; nothing, with a finding, if a file includes itself.
std::optional<ScriptText> script_of(const std::string& file, const std::map<std::string, std::string>& variables,
                                    const std::string& key, const EntryFindings& at) {
  ScriptText script(file, variables);
  if (script.circle().empty()) return script;
  at.error(kScriptCircle, key, script.circle() + " includes a file that includes this line again");
  return std::nullopt;
}

}  // namespace

void check_script(const Scene& scene, Findings& findings) {
  const ParticlesSpec& particles = *scene.particles;
  const EntryFindings at(findings, particles.source);
  if (!is_file(particles.script)) return;  // reported with its path
  const std::optional<ScriptText> script = script_of(particles.script, particles.variables, "script", at);
  if (!script) return;
  const bool couples = std::any_of(script->commands().begin(), script->commands().end(),
                                   [](const ScriptCommand& command) { return command.is_fix("couple/mbd"); });
  at.error_if(!couples && script->whole(), kScriptNotCoupled, "script",
              "has no line \"fix ID all couple/mbd ...\" (in " + particles.script +
                  " and the files it includes), so the mechanism would never meet the grains; add one, or set "
                  "ground.kind to \"none\" or \"plane\"");
  if (couples) check_time_step(*script, particles, findings);
  check_coupling(*script, scene, findings);
  check_script_meshes(*script, scene, findings);
  check_bed_is_given(*script, particles, findings);
  check_gravity(*script, scene, at);
  check_values(particles.variables, "variables", at);
  check_variables(*script, particles.variables, "variables", at);
  if (!particles.bed || !is_file(particles.bed->script)) return;
  const std::optional<ScriptText> bed = script_of(particles.bed->script, particles.bed->variables, "bed.script", at);
  if (!bed) return;
  check_values(particles.bed->variables, "bed.variables", at);
  check_variables(*bed, particles.bed->variables, "bed.variables", at);
  compare_with_bed(*script, *bed, particles, at);
}

}  // namespace footfall
