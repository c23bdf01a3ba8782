// The LIGGGHTS script as text. LIGGGHTS has the last word on it; this finds in milliseconds what would else end a run,
// or what neither program could know.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "coupler/base/text.h"
#include "mbd_solver/scene/check_script.h"
#include "mbd_solver/scene/scene_check.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace {

// The time step that is in force when the coupled grains move. Before the coupling a script may settle its bed with
// another one; what stands in an `if` is not known here.
void check_time_step(const ScriptText& script, const ParticlesSpec& particles, Findings& findings) {
  const ScriptCommand* step = nullptr;
  bool coupled = false, judged = false;
  const auto judge = [&] {
    judged = true;
    if (step == nullptr) return;
    const double dt = *as_number(step->words[1]);
    if (dt <= particles.max_time_step * (1.0 + 1e-9)) return;
    findings.error(particles.source, "max_time_step",
                   "the script's time step is " + number_text(dt) + " s (" + step->place() + "), expected at most " +
                       number_text(particles.max_time_step) +
                       " s: on soil of this kind twice that runs without complaint and is wrong by tens of per cent; "
                       "make the step smaller, or state a larger max_time_step if your grains are known to allow it");
  };
  for (const ScriptCommand& command : script.commands()) {
    if (command.words[0] == "timestep" && command.words.size() > 1)
      step = command.conditional || !as_number(command.words[1]) ? nullptr : &command;
    coupled = coupled || command.is_fix("couple/mbd");
    if (command.words[0] == "run" && coupled && !judged) judge();
  }
  if (!judged) judge();
}

// A script that reads a settled bed, and a scene that does not say how it is made.
void check_bed_is_given(const ScriptText& script, const ParticlesSpec& particles, Findings& findings) {
  if (particles.bed || particles.box) return;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] == "write_restart" || w[0] == "restart") return;  // it may be its own
    if (w[0] != "read_restart" || w.size() < 2 || command.conditional) continue;
    const bool unknown = w[1].find("${") != std::string::npos;
    std::error_code ignored;
    if (unknown ? w[1].find("${bed}") == std::string::npos : std::filesystem::exists(w[1], ignored)) continue;
    findings.error(particles.source, "script",
                   command.place() + " reads a settled bed, " + w[1] +
                       (unknown ? ", which nothing gives" : ", and there is no such file") +
                       "; add [particles.bed] with the script that makes it (script = \"in.bed\"), or name a restart "
                       "file: variables = { bed = \"FILE\" }");
  }
}

// LIGGGHTS replaces ${name} until none is left: for ever, where a value leads back to its own name.
void check_values(const std::map<std::string, std::string>& variables, const std::string& key, const Source& source,
                  Findings& findings) {
  for (const auto& [name, value] : variables) {
    std::string chain = name;
    const std::string* text = &value;
    for (std::size_t steps = 0; steps <= variables.size(); ++steps) {
      const std::size_t at = text->find("${"), end = text->find('}', at);
      if (at == std::string::npos || end == std::string::npos) break;
      const auto next = variables.find(text->substr(at + 2, end - at - 2));
      if (next == variables.end()) break;
      chain += " -> " + next->first;
      if (next->first == name) {
        findings.error(source, key + "." + name, "the variable names itself: " + chain + "; give it a value");
        return;
      }
      text = &next->second;
    }
  }
}

// A variable that nobody reads: its value never arrives. One that resembles another is misspelt; any other may come from
// the scene's base, for another script.
void check_variables(const ScriptText& script, const std::map<std::string, std::string>& variables,
                     const std::string& key, const Source& source, Findings& findings) {
  const std::vector<std::string> known(script.names().begin(), script.names().end());
  for (const auto& [name, value] : variables) {
    if (script.names().count(name) == 1) continue;
    const std::string what =
        "the script neither declares nor reads such a variable." + known_names("variables", name, known);
    if (script.whole() && !nearest_name(name, known).empty())
      findings.error(source, key + "." + name, what);
    else
      findings.warning(source, key + "." + name, what);
  }
}

std::string gravity_text(const Eigen::Vector3d& v) {
  return "[" + number_text(v[0]) + ", " + number_text(v[1]) + ", " + number_text(v[2]) + "] m/s2";
}

// What the handshake will compare, said before a bed is poured: one fix gravity with plain numbers.
void check_gravity(const ScriptText& script, const Scene& scene, Findings& findings) {
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
    findings.warning(scene.particles->source, "script",
                     "has no fix gravity, and the scene the gravity " + gravity_text(scene.gravity) +
                         ": the grains have no weight; add  fix gravity all gravity " +
                         number_text(scene.gravity.norm()) + " vector " + number_text(down[0]) + " " +
                         number_text(down[1]) + " " + number_text(down[2]));
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
  if ((g - scene.gravity).norm() <= 1e-6 * scene.gravity.norm()) return;
  findings.error(scene.particles->source, "script",
                 "the grains have the gravity " + gravity_text(g) + " (" + only->place() + "), the scene " +
                     gravity_text(scene.gravity) +
                     "; make them agree, or say that the grains have their own: fix ID all couple/mbd every N gravity "
                     "script ...");
}

// The words of the last `fix ID all gravity ...` and of the elastic constants, by what they say. (Friction differs by
// intent: beds are poured with little of it, to be dense.)
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

// A kept bed was poured by a script of its own. Gravity and elasticity should be the same in both, and so should every
// variable that both scripts have and the scene sets in one of them; but for the time step, which is the method's.
void compare_with_bed(const ScriptText& script, const ScriptText& bed, const ParticlesSpec& particles,
                      Findings& findings) {
  const auto told = [&](const std::string& what, const std::string& of_bed, const std::string& of_run) {
    findings.warning(particles.source, "bed",
                     "the bed is made with " + what + " = " + of_bed + ", the run has " + of_run +
                         ": the grains lie otherwise than they would in the run; make them agree if this is not meant");
  };
  const std::map<std::string, std::string> of_bed = conditions(bed), of_run = conditions(script);
  for (const auto& [what, value] : of_bed) {
    const auto other = of_run.find(what);
    if (other != of_run.end() && other->second != value) told(what, value, other->second);
  }
  for (const std::string& name : bed.names()) {
    const bool set = particles.variables.count(name) == 1 || particles.bed->variables.count(name) == 1;
    if (!set || name == "dt" || name == "gravity") continue;  // compared as what they make of gravity
    const std::optional<double> here = as_number(bed.value(name)), there = as_number(script.value(name));
    if (here && there && *here != *there) told("variable " + name, bed.value(name), script.value(name));
  }
}

bool is_file(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(name, ignored);
}

}  // namespace

void check_script(const Scene& scene, Findings& findings) {
  const ParticlesSpec& particles = *scene.particles;
  if (!is_file(particles.script)) return;  // reported with its path
  const ScriptText script(particles.script, particles.variables);
  if (!script.circle().empty()) {
    findings.error(particles.source, "script", script.circle() + " includes a file that includes this line again");
    return;
  }
  const bool couples = std::any_of(script.commands().begin(), script.commands().end(),
                                   [](const ScriptCommand& command) { return command.is_fix("couple/mbd"); });
  if (!couples && script.whole()) {
    findings.error(particles.source, "script",
                   "has no line \"fix ID all couple/mbd ...\" (in " + particles.script +
                       " and the files it includes), so the mechanism would never meet the grains; add one, or set "
                       "ground.kind to \"none\" or \"plane\"");
  }
  if (couples) check_time_step(script, particles, findings);
  check_coupling(script, scene, findings);
  check_script_meshes(script, scene, findings);
  check_bed_is_given(script, particles, findings);
  check_gravity(script, scene, findings);
  check_values(particles.variables, "variables", particles.source, findings);
  check_variables(script, particles.variables, "variables", particles.source, findings);
  if (!particles.bed || !is_file(particles.bed->script)) return;
  const ScriptText bed(particles.bed->script, particles.bed->variables);
  if (!bed.circle().empty()) {
    findings.error(particles.source, "bed.script", bed.circle() + " includes a file that includes this line again");
    return;
  }
  check_values(particles.bed->variables, "bed.variables", particles.source, findings);
  check_variables(bed, particles.bed->variables, "bed.variables", particles.source, findings);
  compare_with_bed(script, bed, particles, findings);
}

}  // namespace footfall
