#pragma once
// From [particles.box] to the scripts of inputs/box and their variables: what a user would else write in a script.

#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// What of the scene shall move on the grains and what the box holds, as LIGGGHTS will have it.
struct BoxNumbers {
  double rayleigh = 0.0, hertz = 0.0;  // times of the smallest grain [s]
  double time_step = 0.0;              // of the grains [s]
  double grains = 0.0;                 // about so many
  double headroom = 0.0;               // of the simulation box above z = 0 [m]
  double margin = 0.0;                 // of the simulation box around the walls [m]
};
// Of a scene whose box is whole (no finding of check_box).
BoxNumbers box_numbers(const Scene& scene);

// Rolling friction stands for corners: clumps, which have their own, have none unless the scene names a model.
RollingModel rolling_model_of(const Scene& scene);

// Names both scripts, their variables (those that the scene gives itself stay), surface_height and max_time_step. What
// cannot be becomes a finding. Nothing without a box.
void resolve_box(Scene& scene, Findings& findings);

// What is wrong with the box; true when nothing is.
bool check_box(const Scene& scene, Findings& findings);

// Where a script of inputs/box is (shipped_files.h). Throws InputError.
std::string box_script(const std::string& name);

}  // namespace footfall
