#pragma once
// A scene as JSON (summary.json), and the JSON schema of scene files.

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

using Json = nlohmann::ordered_json;

// The keys of each kind of shape, joint, spring, drive, controller and signal, for the reference pages:
//
//   { "shapes": ..., "joints": { "revolute": { "required": ["axis"], "optional": ["angle"] }, ... }, "springs": { ... }, ... }
//
// It is made of joint_spec.h and kind_keys.h, as the checks of a scene are. Keys of every kind (name, bodies, points ...) are
// omitted. `footfall schema` writes it as "x-kinds".
Json kind_schema();

// JSON schema (draft 2020-12) of scene files, for editors that complete and check TOML: types, units, ranges, choices and
// defaults of the keys that the reader knows; keys of kinds as "x-kinds".
//
// Left to `footfall check`: required keys (a base may give them), names that must exist, keys of other kinds, and values of
// several keys that contradict each other.
std::string scene_schema();
// The schema of any other file whose keys are described (field_visitor.h).
std::string schema_of(const std::string& title, const std::function<void(FieldVisitor&)>& describe);

// The scene as JSON text, with all defaults: summary.json's key `scene`.
std::string scene_json(const Scene& scene);

}  // namespace footfall
