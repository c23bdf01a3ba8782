#pragma once
// base = "../landing_mr": a scene that lists only its differences from another one.

#include <string>

#include "mbd_solver/scene/config_node.h"

namespace footfall {

// Parses the scene of `argument` (file or folder) and, when its key `base` names another scene (path relative to its
// folder), lays its own keys over that one; a base may have a base. Tables are merged key by key; entries of lists of
// tables with the same name are merged and others appended; every other value replaces; `without = ["mr"]` in a table
// removes keys of the base's table. Paths of the base remain relative to the base's folder.
// Throws InputError: not readable, no TOML, a base that leads back to itself, an experiment instead of a scene.
ConfigNode parse_scene_with_base(const std::string& argument);

}  // namespace footfall
