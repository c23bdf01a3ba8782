#pragma once
// A mesh of the LIGGGHTS script as the surface of a boundary.

#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

// File, scale, orientation and position of
//   fix ID group mesh/surface... file FILE ... [scale s] [rotate axis x y z angle phi] [move x y z] ...
// LIGGGHTS applies scale, rotate (about the origin, phi in degrees) and move in their order in the line; any order gives x -> R s x + p:   scale f: s -> f s, p -> f p;   rotate Q: R -> Q R, p -> Q p;   move d: p -> p + d.
// here: the script's folder. Throws InputError without a place if the line cannot be used.
SurfaceSpec mesh_in_script(const ScriptCommand& command, const std::string& here);

// Fills every surface with from_script = "ID" from the script's mesh of this id. A line that cannot be used is a finding.
void resolve_script_meshes(Scene& scene, Findings& findings);

}  // namespace footfall
