#pragma once
// paraview.py: opens a run in ParaView, bodies and grains in step, grains as spheres coloured by speed.

#include <string>

namespace footfall {

// Writes it for the run in `out`; nothing when it drew neither bodies nor grains. A failure is a warning on standard
// error, not an end.
void write_paraview_script(const std::string& out);

}  // namespace footfall
