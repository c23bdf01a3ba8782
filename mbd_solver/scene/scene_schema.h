#pragma once
// JSON schema (draft 2020-12) of scene files, for editors that complete and check TOML: types, units, ranges, choices and
// defaults of the keys that the reader knows; keys of kinds as "x-kinds" (kind_schema.h).
//
// Left to `footfall check`: required keys (a base may give them), names that must exist, keys of other kinds, and values of
// several keys that contradict each other.

#include <functional>
#include <string>

namespace footfall {

class FieldVisitor;

std::string scene_schema();
// The schema of any other file whose keys are described (field_visitor.h).
std::string schema_of(const std::string& title, const std::function<void(FieldVisitor&)>& describe);

}  // namespace footfall
