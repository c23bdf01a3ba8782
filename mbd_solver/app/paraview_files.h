#pragma once
// Files for ParaView: NAME.pvd lists the dumps of grains with their times, as bodies.pvd does for the bodies. A .pvd lists
// XML files only and LIGGGHTS dumps legacy files or text, so each dump is written anew as NAME_STEP.vtp: compressed, with id,
// type, radius [m], velocity [m/s] and force [N] where the dump has them. A legacy file that holds nothing else is removed then:
// every reader of footfall reads the .vtp. And paraview.py, which opens both.

#include <string>

#include "mbd_solver/bed/bed_frames.h"

namespace footfall {

// For the run in `out`; nothing without dumps of grains. A dump within the window in which the bodies were drawn gets the
// time of their drawing, so that both step together. A failure is a warning on standard error.
void write_grain_series(const std::string& out);

// One dump as VTK XML: points with float arrays `velocity`, `force` and `radius`, and integers `id`; each array is one
// block of zlib in base64, after VTK's header of it.
std::string grain_polydata(const BedFrame& frame);

// paraview.py shows bodies, and grains as spheres coloured by speed. Nothing for a run with neither. A failure is a warning
// on standard error.
void write_paraview_script(const std::string& out);

}  // namespace footfall
