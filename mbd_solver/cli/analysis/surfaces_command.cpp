#include "mbd_solver/cli/analysis/surfaces_command.h"

#include <cstdio>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/analysis/surface_plots.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/model/controllers/control_surface.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {

namespace {

struct Input {
  const char* name;
  const char* axis;
};
constexpr Input kAcceleration{"a", "a [g]"};
constexpr Input kAgainst[] = {{"da", "da [g in 0.1 s]"}, {"alpha", "alpha (pitch) [deg]"}};

std::vector<std::string> write_scripts(const ControllerSpec& controller, const std::string& out) {
  const FuzzySystem system(controller.file);
  std::vector<std::string> scripts;
  for (int output : {0, 2}) {
    if (output >= system.output_count()) continue;
    const std::string voltage = "U" + std::to_string(output + 1);
    for (const Input& second : kAgainst) {
      const ControlSurface surface = control_surface(system, output, kAcceleration.name, second.name);
      SurfacePicture picture{controller.name + "_" + voltage + "_a_" + second.name,
                             voltage + " of " + controller.name,
                             kAcceleration.axis,
                             second.axis,
                             voltage + " [-]",
                             surface.first,
                             surface.second,
                             surface.voltage};
      scripts.push_back(write_surface_script(out, picture));
    }
  }
  return scripts;
}

}  // namespace

int surfaces_command(const std::string& scene_argument, const std::vector<std::string>& settings,
                     const std::string& out) {
  const Scene scene = read_scene(scene_argument, settings);
  std::vector<std::string> scripts;
  for (const ControllerSpec& controller : scene.controllers) {
    if (controller.kind != ControllerKind::kFuzzy) continue;
    const std::vector<std::string> more = write_scripts(controller, out);
    scripts.insert(scripts.end(), more.begin(), more.end());
  }
  if (scripts.empty())
    throw InputError(scene.file + ": controllers: none is of kind \"fuzzy\"; there is no surface to show");
  for (const std::string& picture : run_gnuplot(out, scripts)) std::printf("%s\n", short_path(picture).c_str());
  return kExitDone;
}

}  // namespace footfall
