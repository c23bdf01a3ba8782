#pragma once
// The scene as JSON text, with all defaults: summary.json's key `scene`.

#include <string>

#include "mbd_solver/scene/scene.h"

namespace footfall {

std::string scene_json(const Scene& scene);

}  // namespace footfall
