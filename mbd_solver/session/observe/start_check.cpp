// Builds the mechanism as a run does, and evaluates what a run would refuse or warn of.

#include "mbd_solver/session/observe/start_check.h"

#include <utility>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/assemble/grain_dump.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/session/observe/attached_damping.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/observe/requirements.h"
#include "mbd_solver/session/observe/start_overlaps.h"
#include "mbd_solver/session/observe/start_values.h"

namespace footfall {

void check_by_building(Scene scene, bool judges, const std::function<void(const std::string&)>& warn,
                       const std::function<void(const Scene&, const Mechanism&)>& with_grains) {
  // The bed may not be made yet: whether the mechanism can be built does not depend on its height.
  const bool unknown_height =
      scene.touches_particles() && scene.particles->grains.empty() && !scene.particles->surface_height;
  if (unknown_height) scene.particles->surface_height = 0.0;
  try {
    for (const BoundarySpec& boundary : scene.boundaries) {
      if (boundary.surface && !boundary.surface->file.empty()) boundary_surface(scene, boundary);
    }
    Mechanism mechanism = build_mechanism(scene);
    for (const std::string& warning : mechanism.warnings) warn(warning);
    if (with_grains) with_grains(scene, mechanism);
    require_values_at_start(scene, !unknown_height, mechanism);
    if (!judges) return;
    std::vector<GrainPlace> grains;
    if (scene.touches_particles() && !scene.particles->grains.empty()) grains = read_grains(scene.particles->grains);
    for (const std::string& warning : surfaces_away(scene)) warn(warning);
    for (const std::string& warning : overlaps_at_start(scene, mechanism, grains)) warn(warning);
    for (const std::string& warning : warnings_of_held_bodies(scene, mechanism)) warn(warning);
    const Layout layout(mechanism.model);
    const Observation observation({scene, mechanism, layout});
    for (const std::string& warning : requirement_unit_warnings(scene, observation.names(), observation.units()))
      warn(warning);
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.front() == '/' || names_a_place(scene.file, what) ? what : scene.file + ": " + what);
  }
}

}  // namespace footfall
