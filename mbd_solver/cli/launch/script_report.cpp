#include "mbd_solver/cli/launch/script_report.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include "coupler/base/text.h"
#include "mbd_solver/build/grain_dump.h"
#include "mbd_solver/cli/launch/bed.h"
#include "mbd_solver/cli/launch/bed_seal.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/scene/grain_time_step.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace {

// What the text of the scripts says; a command behind another one of its kind wins, as in LIGGGHTS.
struct SaidOfGrains {
  std::optional<double> young, poisson;  // of the first type: [Pa], [-]
  std::optional<double> step;            // [s]
  std::string every;                     // substeps per window, as written
  double density = 0.0;                  // smallest of the templates; 0: none is said [kg/m3]
  double smallest = 0.0, largest = 0.0;  // radii of the templates; 0: none is said [m]
};

void read_template(const std::vector<std::string>& words, SaidOfGrains& said) {
  for (std::size_t i = 4; i + 2 < words.size(); ++i) {
    if (words[i + 1] != "constant") continue;
    const std::optional<double> value = as_number(words[i + 2]);
    if (!value || !(*value > 0.0)) continue;
    if (words[i] == "density") said.density = said.density > 0.0 ? std::min(said.density, *value) : *value;
    if (words[i] != "radius") continue;
    said.smallest = said.smallest > 0.0 ? std::min(said.smallest, *value) : *value;
    said.largest = std::max(said.largest, *value);
  }
}

void read_script(const std::string& file, const std::map<std::string, std::string>& variables, SaidOfGrains& said) {
  const ScriptText script(file, variables);
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] == "timestep" && w.size() > 1) said.step = command.conditional ? std::nullopt : as_number(w[1]);
    if (w[0] != "fix" || w.size() < 6) continue;
    if (w[3] == "property/global" && w.size() > 6 && w[5] == "peratomtype") {
      if (w[4] == "youngsModulus") said.young = as_number(w[6]);
      if (w[4] == "poissonsRatio") said.poisson = as_number(w[6]);
    }
    if (w[3].rfind("particletemplate/", 0) == 0) read_template(w, said);
    if (w[3] == "couple/mbd" && w[4] == "every") said.every = w[5];
  }
}

// "0.02 m", "0.02 to 0.04 m".
std::string radii_text(double smallest, double largest) {
  return number_text(smallest, 3) + (largest > smallest ? " to " + number_text(largest, 3) : "") + " m";
}

std::string step_text(const SaidOfGrains& said, double speed) {
  if (!said.step) return "";
  std::string text = "  time step: " + number_text(*said.step) + " s";
  if (said.young && said.poisson && said.density > 0.0 && said.smallest > 0.0) {
    const ElasticGrain grain = {said.smallest, said.density, *said.young, *said.poisson};
    text += ", " + share_text(*said.step / rayleigh_time(grain)) + " of the Rayleigh time";
    if (speed > 0.0)
      text += ", " + share_text(*said.step / hertz_time(grain, speed)) + " of the Hertz time at " +
              number_text(speed, 3) + " m/s";
  }
  if (!said.every.empty() && said.every.front() != '$')
    text += "; window: " + (said.every == "auto" ? "chosen during the run" : said.every + " steps");
  return text + "\n";
}

}  // namespace

std::string script_report(const Scene& scene) {
  const ParticlesSpec& particles = *scene.particles;
  SaidOfGrains said;
  if (particles.bed) read_script(particles.bed->script, particles.bed->variables, said);
  said.step.reset();
  read_script(particles.script, particles.variables, said);
  std::string text = "Grains: " + short_path(particles.script) + " on " + std::to_string(particles.ranks) +
                     (particles.ranks == 1 ? " rank" : " ranks");
  if (particles.bed) {
    const std::string folder = bed_folder(*particles.bed);
    const std::string grains = (std::filesystem::path(folder) / kBedGrains).string();
    if (!bed_is_made(folder)) {
      text += "\n  the bed is not made yet; the first run makes and keeps it";
    } else if (std::filesystem::exists(grains)) {
      const std::vector<GrainPlace> places = read_grains(grains);
      said.smallest = std::numeric_limits<double>::infinity();
      said.largest = 0.0;
      for (const GrainPlace& place : places) {
        said.smallest = std::min(said.smallest, place.radius);
        said.largest = std::max(said.largest, place.radius);
      }
      text += "\n  the bed is made: " + std::to_string(count_grains(places)) + " grains, " + short_path(folder);
    }
  }
  text += "\n";
  if (said.largest > 0.0) text += "  radius: " + radii_text(said.smallest, said.largest) + "\n";
  return text + step_text(said, scene.initial.velocity.norm());
}

}  // namespace footfall
