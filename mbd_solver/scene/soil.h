#pragma once
// particles.soil = "grc-1-dense": a bed with the numbers of a published soil. inputs/soils/NAME.toml holds keys of
// [particles.box] with the source of each. What the scene says itself stays.

#include <string>
#include <vector>

#include "mbd_solver/scene/config_node.h"

namespace footfall {

class Findings;

// Fills the table particles.box of the scene with what its soil says and the scene does not. Nothing without particles.soil.
// A soil that nobody knows, or one without a box, becomes a finding.
void add_soil(ConfigNode& scene, Findings& findings);

// The names that inputs/soils has, in their order.
std::vector<std::string> known_soils();

}  // namespace footfall
