#pragma once
// particles.soil = "grc-1-dense": a bed with the numbers of a published soil. inputs/soils/NAME.toml holds keys of
// [particles.box] with the source of each. Keys of the scene take precedence.

#include <string>
#include <vector>

#include "mbd_solver/scene/config_node.h"

namespace footfall {

class Findings;

// Adds the soil's keys to the table particles.box where the scene has none. Does nothing without particles.soil. An unknown
// soil, or one without a box, is a finding.
void add_soil(ConfigNode& scene, Findings& findings);

// The names of inputs/soils, sorted.
std::vector<std::string> known_soils();

}  // namespace footfall
