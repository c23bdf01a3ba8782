// The LIGGGHTS script as text. LIGGGHTS has the last word on it; this finds in milliseconds what would else end a run.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/scene_check.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace {

bool as_number(const std::string& text, double& value) {
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return end && *end == '\0' && end != text.c_str();
}

// Nothing, told, when the text goes round for ever.
std::optional<ScriptText> read_script(const std::string& file, const std::map<std::string, std::string>& variables,
                                      const ParticlesSpec& particles, Findings& findings) {
  try {
    return ScriptText(file, variables);
  } catch (const InputError& error) {
    findings.error(particles.source, "script", error.what());
    return {};
  }
}

}  // namespace

void check_script(const Scene& scene, Findings& findings) {
  const ParticlesSpec& particles = *scene.particles;
  std::error_code ignored;
  if (particles.bed) read_script(particles.bed->script, particles.bed->variables, particles, findings);
  if (!std::filesystem::is_regular_file(particles.script, ignored)) return;  // reported with its path
  const std::optional<ScriptText> text = read_script(particles.script, particles.variables, particles, findings);
  if (!text) return;
  const ScriptText& script = *text;
  bool couples = false;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    const bool is_fix = w[0] == "fix" && w.size() > 3;
    couples = couples || (is_fix && w[3] == "couple/mbd");
    double step = 0.0;
    if (w[0] == "timestep" && w.size() > 1 && as_number(w[1], step) && step > particles.max_time_step * (1.0 + 1e-9)) {
      findings.error(particles.source, "max_time_step",
                     "the script's time step is " + number_text(step) + " s (" + command.file + ":" +
                         std::to_string(command.line) + "), expected at most " + number_text(particles.max_time_step) +
                         " s: on soil of this kind twice that runs without complaint and is wrong by tens of per cent; "
                         "make the step smaller, or "
                         "state a larger max_time_step if your grains are known to allow it");
    }
    if (is_fix && (w[3] == "couple/mbd/geometry" || w[3] == "wall/gran/beam")) {
      std::vector<std::string> names;
      for (const BoundarySpec& b : scene.boundaries) names.push_back(b.body);
      for (std::size_t i = 4; i + 1 < w.size(); ++i) {
        if (w[i] != "body" || w[i + 1].find("${") != std::string::npos) continue;
        if (std::find(names.begin(), names.end(), w[i + 1]) == names.end())
          findings.error(particles.source, "script",
                         command.file + ":" + std::to_string(command.line) + " asks for the body \"" + w[i + 1] +
                             "\", which has no boundary in this scene." + known_names("boundaries", w[i + 1], names));
      }
    }
  }
  if (!couples) {
    findings.error(particles.source, "script",
                   "has no line \"fix ID all couple/mbd ...\" (in " + particles.script +
                       " and the files it includes), so the mechanism would never meet the grains; add one, or set "
                       "ground.kind to \"none\" or \"plane\"");
  }
}

}  // namespace footfall
