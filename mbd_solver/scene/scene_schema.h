#pragma once
// Values of scene fields as JSON: what summary.json and the schema of scenes write.

#include <array>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

using Json = nlohmann::ordered_json;

namespace field_json {

inline Json to_json(double v) { return v; }
inline Json to_json(int v) { return v; }
inline Json to_json(bool v) { return v; }
inline Json to_json(const std::string& v) { return v; }
inline Json to_json(const Eigen::Vector2d& v) { return {v[0], v[1]}; }
inline Json to_json(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
inline Json to_json(const Eigen::Quaterniond& q) { return {{"quaternion", {q.w(), q.x(), q.y(), q.z()}}}; }
inline Json to_json(const Eigen::Matrix3d& m) { return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)}; }
inline Json to_json(const std::map<std::string, std::string>& v) { return v.empty() ? Json::object() : Json(v); }
inline Json to_json(const Choice& v) { return v.names[static_cast<std::size_t>(v.value)]; }
inline Json to_json(const NumberOrWord& v) { return *v.number; }
inline Json to_json(const PerAxis& v) {
  const Eigen::Vector3d& k = *v.values;
  return k[0] == k[1] && k[1] == k[2] ? Json(k[0]) : to_json(k);
}
inline Json to_json(const Source&) { return nullptr; }
template <class T>
Json to_json(const std::optional<T>& v) {
  return v ? to_json(*v) : Json(nullptr);
}
template <class Range>
Json list_to_json(const Range& values) {
  Json list = Json::array();
  for (const auto& value : values) list.push_back(to_json(value));
  return list;
}
template <class T>
Json to_json(const std::vector<T>& v) {
  return list_to_json(v);
}
template <class T, std::size_t N>
Json to_json(const std::array<T, N>& v) {
  return list_to_json(v);
}

}  // namespace field_json

inline Json json_of(const FieldRef& ref) {
  return std::visit([](const auto* value) { return field_json::to_json(*value); }, ref);
}

// The keys of each kind of joint, spring, drive, controller and signal, for the reference pages:
//
//   { "joints": { "revolute": { "required": ["axis"], "optional": ["angle"] }, ... }, "springs": { ... }, ... }
//
// It is made of joint_spec.h and kind_keys.h, as the checks of a scene are. Keys of every kind (name, bodies, points ...) are
// omitted. `footfall schema` writes it as "x-kinds".
Json kind_schema();

// JSON schema (draft 2020-12) of scene files, for editors that complete and check TOML: types, units, ranges, choices and
// defaults of the keys that the reader knows; keys of kinds as "x-kinds" (kind_schema.h).
//
// Left to `footfall check`: required keys (a base may give them), names that must exist, keys of other kinds, and values of
// several keys that contradict each other.
class FieldVisitor;

std::string scene_schema();
// The schema of any other file whose keys are described (field_visitor.h).
std::string schema_of(const std::string& title, const std::function<void(FieldVisitor&)>& describe);

// The scene as JSON text, with all defaults: summary.json's key `scene`.
std::string scene_json(const Scene& scene);

}  // namespace footfall
