#pragma once
// Height maps from files: ESRI ASCII grids, and text with x, y and z in each line. The origin is subtracted in double precision,
// so that coordinates of a site (1e6 m) lose no digit of what the file gives.

#include <memory>

#include "mbd_solver/scene/terrain_spec.h"

namespace footfall {

// Samples from the file, counted from its origin. Throws InputError, naming file and line: not readable, another header, rows
// of other lengths, holes, values that are no numbers, too many samples.
std::shared_ptr<const HeightGrid> read_height_map(const TerrainMapSpec& map);

}  // namespace footfall
