// The schema says what the reader does: the same keys, and every shipped scene is valid by it.
#include "mbd_solver/scene/scene_schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "mbd_solver/scene/config_node.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/units.h"

namespace footfall {
namespace {

using Json = nlohmann::json;

Json schema() { return Json::parse(scene_schema()); }

// All keys of a schema's tables as known_keys() writes them, but for those that every table has.
void list_keys(const Json& node, const std::string& prefix, std::set<std::string>& keys) {
  if (node.contains("anyOf"))
    for (const Json& way : node["anyOf"]) list_keys(way, prefix, keys);
  if (node.contains("properties") && !node.contains("maxProperties"))
    for (const auto& [key, value] : node["properties"].items()) {
      if (key == "without" || key == "base") continue;
      const std::string path = prefix.empty() ? key : prefix + "." + key;
      keys.insert(path);
      list_keys(value, path, keys);
    }
  for (const char* list : {"items", "additionalProperties"})
    if (node.contains(list) && node[list].is_object()) list_keys(node[list], prefix + "[]", keys);
}

TEST(SceneSchema, HoldsTheKeysOfTheReaderAndNoOthers) {
  std::set<std::string> keys;
  list_keys(schema(), "", keys);
  for (const std::string& key : known_keys()) EXPECT_EQ(keys.count(key), 1u) << key;
  // What is left is a known key with the suffix of a unit.
  std::set<std::string> suffixes;
  for (int unit = 0; unit <= static_cast<int>(Unit::kTorque); ++unit)
    for (const UnitSuffix& suffix : unit_suffixes(static_cast<Unit>(unit))) suffixes.insert(suffix.suffix);
  for (const std::string& key : keys) {
    bool known = known_keys().count(key) > 0;
    for (const std::string& suffix : suffixes)
      if (key.size() > suffix.size() && key.compare(key.size() - suffix.size(), suffix.size(), suffix) == 0)
        known = known || known_keys().count(key.substr(0, key.size() - suffix.size())) > 0;
    EXPECT_TRUE(known) << key;
  }
}

bool is_of_type(const ConfigNode& value, const std::string& type) {
  using Kind = ConfigNode::Kind;
  if (type == "number") return value.is_number();
  if (type == "integer") return value.kind == Kind::kInteger;
  if (type == "boolean") return value.kind == Kind::kFlag;
  if (type == "string") return value.kind == Kind::kText;
  if (type == "array") return value.kind == Kind::kList;
  return type == "object" && value.kind == Kind::kTable;
}

bool is_of_one_type(const ConfigNode& value, const Json& types) {
  if (types.is_string()) return is_of_type(value, types);
  return std::any_of(types.begin(), types.end(), [&](const Json& type) { return is_of_type(value, type); });
}

// What is wrong with a value by a schema, or "". Knows the words that scene_schema writes.
std::string wrong(const ConfigNode& value, const Json& s, const std::string& path) {
  if (s.contains("anyOf")) {
    std::string all;
    for (const Json& way : s["anyOf"]) {
      const std::string problem = wrong(value, way, path);
      if (problem.empty()) return "";
      all += problem + "; ";
    }
    return all;
  }
  if (s.contains("const")) return value.text == s["const"] ? "" : path + ": is another word";
  if (s.contains("enum"))
    return std::find(s["enum"].begin(), s["enum"].end(), value.text) != s["enum"].end() ? "" : path + ": no choice";
  if (!is_of_one_type(value, s["type"])) return path + ": is " + value.description() + ", not " + s["type"].dump();
  if (value.is_number()) {
    if (s.contains("minimum") && value.number < s["minimum"]) return path + ": too small";
    if (s.contains("maximum") && value.number > s["maximum"]) return path + ": too large";
    if (s.contains("exclusiveMinimum") && value.number <= s["exclusiveMinimum"]) return path + ": too small";
  }
  if (s.contains("minItems") && value.list.size() < s["minItems"]) return path + ": too short";
  if (s.contains("maxItems") && value.list.size() > s["maxItems"]) return path + ": too long";
  for (const ConfigNode& item : value.list)
    if (const std::string problem = wrong(item, s["items"], path + "[]"); !problem.empty()) return problem;
  for (const auto& [key, item] : value.table) {
    const bool known = s.contains("properties") && s["properties"].contains(key);
    const Json& rest = s.contains("additionalProperties") ? s["additionalProperties"] : Json();
    if (!known && !rest.is_object()) return path + ": knows no " + key;
    const std::string problem = wrong(item, known ? s["properties"][key] : rest, path + "." + key);
    if (!problem.empty()) return problem;
  }
  return "";
}

TEST(SceneSchema, TakesEveryShippedScene) {
  const Json s = schema();
  int count = 0;
  for (const char* folder : {"inputs", "examples"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(FOOTFALL_SOURCE_DIR) + "/" + folder)) {
      if (entry.path().filename() != "scene.toml") continue;
      EXPECT_EQ(wrong(parse_toml_file(entry.path()), s, ""), "") << entry.path();
      ++count;
    }
  EXPECT_GE(count, 6);
}

TEST(SceneSchema, RefusesWhatTheReaderRefuses) {
  const Json s = schema();
  const auto refused = [&](const std::string& setting) {
    ConfigNode scene;
    Findings findings("scene");
    apply_setting(scene, setting, findings);
    return !wrong(scene, s, "").empty();
  };
  EXPECT_FALSE(refused("solver.rtol=1e-6"));
  EXPECT_TRUE(refused("solver.rtol=-1e-6"));
  EXPECT_TRUE(refused("solver.rtol=\"small\""));
  EXPECT_TRUE(refused("solver.rtoll=1e-6"));
  EXPECT_TRUE(refused("solver.integrator=\"euler\""));
  EXPECT_TRUE(refused("gravity=[0.0, 1.0]"));
}

}  // namespace
}  // namespace footfall
