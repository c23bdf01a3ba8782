#pragma once
// JSON schema (draft 2020-12) of scene files, for editors that complete and check TOML. It is made by walking the
// keys that the reader knows, so that it cannot say anything else: types, units, ranges, choices, defaults. Keys of
// kinds stand beside it, as "x-kinds" (kind_schema.h).
//
// What only the reader can tell is not in it: keys that are required (a base may give them), names that must exist,
// keys that belong to other kinds, values of two keys that contradict each other. `footfall check` tells these.

#include <functional>
#include <string>

namespace footfall {

class FieldVisitor;

std::string scene_schema();
// Of any other file whose keys are described (field_visitor.h).
std::string schema_of(const std::string& title, const std::function<void(FieldVisitor&)>& describe);

}  // namespace footfall
