#pragma once
// The dumps of grains with their times, for ParaView: NAME.vtk.series beside them. A .pvd lists XML files alone, and
// LIGGGHTS dumps legacy ones.

#include <string>

namespace footfall {

// Writes it for the run in `out`; nothing when it dumped no grains. A dump within the window in which the bodies were
// drawn gets the time of their drawing, so that both step together. A failure is a warning on standard error, not an
// end.
void write_grain_series(const std::string& out);

}  // namespace footfall
