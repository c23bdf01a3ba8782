#pragma once
// The dumps of grains for ParaView: NAME.pvd lists them with their times, as bodies.pvd does for the bodies. A .pvd
// lists XML files alone and LIGGGHTS dumps legacy ones or text, so each dump is written once more beside itself, as
// NAME_STEP.vtp: packed, with id, radius [m], velocity [m/s] and force [N] where the dump has them.

#include <string>

#include "mbd_solver/bed/bed_frames.h"

namespace footfall {

// Writes them for the run in `out`; nothing when it dumped no grains. A dump within the window in which the bodies were
// drawn gets the time of their drawing, so that both step together. A failure is a warning on standard error, not an
// end.
void write_grain_series(const std::string& out);

// One dump as VTK's XML: points with float arrays `velocity`, `force` and `radius`, and the integers `id`; each array
// is one block of zlib in base64, behind VTK's header of it.
std::string grain_polydata(const BedFrame& frame);

// paraview.py: opens a run in ParaView, bodies and grains in step, grains as spheres coloured by speed.

// Writes it for the run in `out`; nothing when it drew neither bodies nor grains. A failure is a warning on standard
// error, not an end.
void write_paraview_script(const std::string& out);

}  // namespace footfall
