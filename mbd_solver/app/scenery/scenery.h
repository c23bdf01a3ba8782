#pragma once
// The surroundings of a mechanism on its page: meshes of the script that no body moves, and the block of a bed.

#include <nlohmann/json.hpp>

#include "mbd_solver/app/view_page.h"

namespace footfall {

// run.meshes: names, in the order of the chunks mesh-0, mesh-1 ...: nine coordinates [m] per triangle. Of `fix mesh/surface ... file`
// of the script, with its scale, move and rotate, without those that are coupled or moved by `fix move/mesh`. scene: as in
// summary.json. notes: what was left out.
void add_static_meshes(const nlohmann::ordered_json& scene, PageParts& parts, std::vector<std::string>& notes);

// run.bed: {low, high} [m] of [particles.box], whose surface is at z = 0. Nothing for other beds.
void add_bed_block(const nlohmann::ordered_json& scene, PageParts& parts);

}  // namespace footfall
