#pragma once
// From [particles.box] to the scripts of inputs/box and their variables.

#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Numbers that follow from the box and the scene.
struct BoxNumbers {
  double rayleigh = 0.0, hertz = 0.0;  // times of the smallest grain [s]
  double time_step = 0.0;              // of the grains [s]
  double grains = 0.0;                 // about this number
  double headroom = 0.0;               // of the simulation box above z = 0 [m]
  double margin = 0.0;                 // of the simulation box around the walls [m]
};
// Of a scene whose box has no finding of check_box.
BoxNumbers box_numbers(const Scene& scene);

// Rolling friction replaces corners: clumps have none unless the scene names a model.
RollingModel rolling_model_of(const Scene& scene);

// Sets both scripts, their variables (those of the scene take precedence), surface_height and max_time_step. Errors become
// findings. Does nothing without a box.
void resolve_box(Scene& scene, Findings& findings);

// Reports errors of the box; true if there is none.
bool check_box(const Scene& scene, Findings& findings);

// Path of a script of inputs/box (shipped_files.h). Throws InputError.
std::string box_script(const std::string& name);

}  // namespace footfall
