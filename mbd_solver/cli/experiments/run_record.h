#pragma once
// What a finished run was made from and what it cost, kept beside its folder (FOLDER.done.json): the same run need not
// be done again.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"

namespace footfall {

// What a run is made from: the scene with all its values, and a fingerprint of each file it names: scripts (with what
// they include), meshes, controllers, tables.
std::string made_from(const Scene& scene);

// The same of a file and settings, and the end time [s]. Empty when the scene cannot be read: such a run is never taken
// as done.
std::string run_recipe(const std::string& scene_file, const std::vector<std::string>& settings, double until);

// `cost` of the run in `folder`, when it was recorded with this recipe and its summary is still there; null otherwise.
nlohmann::ordered_json recorded_cost(const std::string& folder, const std::string& recipe);
void record_run(const std::string& folder, const std::string& recipe, const nlohmann::ordered_json& cost);

}  // namespace footfall
