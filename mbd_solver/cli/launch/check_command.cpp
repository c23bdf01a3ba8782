#include "mbd_solver/cli/launch/check_command.h"

#include <cstdio>

#include "coupler/base/errors.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/cli/launch/box_report.h"
#include "mbd_solver/cli/launch/script_report.h"
#include "mbd_solver/observe/start_values.h"
#include "mbd_solver/scene/boundary_surface.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {

namespace {

// What only building the mechanism finds. A message that does not start with a file gets the scene's.
void check_by_building(Scene scene) {
  // The bed may not be made yet: any height will do to see whether the mechanism can be built.
  const bool unknown_height =
      scene.touches_particles() && scene.particles->grains.empty() && !scene.particles->surface_height;
  if (unknown_height) scene.particles->surface_height = 0.0;
  try {
    for (const BoundarySpec& boundary : scene.boundaries) {
      if (boundary.surface && !boundary.surface->file.empty()) boundary_surface(scene, boundary);
    }
    Mechanism mechanism = build_mechanism(scene);
    for (const std::string& warning : mechanism.warnings)
      std::fprintf(stderr, "footfall: warning: %s\n", warning.c_str());
    demand_inside_box(scene, mechanism);
    demand_values_at_start(scene, !unknown_height, mechanism);
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.front() == '/' || names_a_place(scene.file, what) ? what : scene.file + ": " + what);
  }
}

}  // namespace

Scene checked_scene(const std::string& argument, const std::vector<std::string>& settings) {
  const Scene scene = read_scene(argument, settings);
  check_by_building(scene);  // its warnings begin with those of the scene
  return scene;
}

int check_command(const std::string& argument, const std::vector<std::string>& settings) {
  const Scene scene = checked_scene(argument, settings);
  const char* grounds[] = {"no ground", "a rigid plane", "particles"};
  double mass = 0.0;
  for (const BodySpec& body : scene.bodies) mass += body.mass;
  std::printf(
      "%s: good. %zu bodies (%g kg), %zu joints, %zu struts, %zu springs, %zu controllers, %zu boundaries on %s.\n",
      scene.file.c_str(), scene.bodies.size(), mass, scene.joints.size(), scene.struts.size(), scene.springs.size(),
      scene.controllers.size(), scene.boundaries.size(), grounds[static_cast<int>(scene.ground.kind)]);
  if (scene.touches_particles())
    std::fputs((scene.particles->box ? box_report(scene) : script_report(scene)).c_str(), stdout);
  return kExitDone;
}

}  // namespace footfall
