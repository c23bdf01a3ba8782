#pragma once
// Uneven ground as it is drawn: a part of it around the mechanism.

#include <string>

#include "mbd_solver/assemble/mechanism.h"

namespace footfall {

inline constexpr const char* kTerrainFile = "terrain.json";  // in the folder of a run

// {first: [x, y], step: [dx, dy], counts: [columns, rows], heights: [...], rocks: [[x, y, z, radius], ...]} in W [m]: twice the
// size of the mechanism around it, and as far as its horizontal speed at the start takes it. Empty where the ground is a plane.
std::string terrain_text(const Scene& scene, const Mechanism& mechanism);

}  // namespace footfall
