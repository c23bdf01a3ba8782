#pragma once
// The LIGGGHTS script as text: the parts of check_script. Each reports only what is certain for any value of variables, any
// branch and any loop.

#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

// Lines that couple: their words, the meshes and bodies that they name, and that a `run` follows.
void check_coupling(const ScriptText& script, const Scene& scene, Findings& findings);

// Meshes from files that are drawn a thousand times too large for the box.
void check_script_meshes(const ScriptText& script, const Scene& scene, Findings& findings);

}  // namespace footfall
