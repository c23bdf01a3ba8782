// experiment_schema() of mbd_solver/cli/experiments/experiment_fields.cpp says what the reader does: every shipped file
// is valid by its keys and types.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "mbd_solver/cli/experiments/experiment.h"
#include "mbd_solver/scene/config_node.h"

namespace footfall {
namespace {

using Json = nlohmann::json;
using Kind = ConfigNode::Kind;

Json schema() { return Json::parse(experiment_schema()); }

bool is_of(const ConfigNode& value, const std::string& type) {
  if (type == "string") return value.kind == Kind::kText;
  if (type == "number") return value.is_number();
  if (type == "integer") return value.kind == Kind::kInteger;
  if (type == "boolean") return value.kind == Kind::kFlag;
  if (type == "array") return value.kind == Kind::kList;
  return type == "object" && value.kind == Kind::kTable;
}

// What is wrong with a value by the schema, or "".
std::string wrong(const ConfigNode& value, const Json& s, const std::string& path) {
  if (s.empty()) return "";
  if (s.contains("anyOf")) {
    for (const Json& way : s["anyOf"])
      if (wrong(value, way, path).empty()) return "";
    return path + ": none of the types";
  }
  if (s.contains("enum")) return std::count(s["enum"].begin(), s["enum"].end(), value.text) ? "" : path + ": no choice";
  const Json types = s["type"].is_string() ? Json::array({s["type"]}) : s["type"];
  if (std::none_of(types.begin(), types.end(), [&](const Json& type) { return is_of(value, type); }))
    return path + ": is " + value.description() + ", expected " + types.dump();
  for (const ConfigNode& item : value.list)
    if (const std::string problem = wrong(item, s["items"], path + "[]"); !problem.empty()) return problem;
  for (const auto& [key, item] : value.table) {
    const bool known = s.contains("properties") && s["properties"].contains(key);
    if (!known && !s["additionalProperties"].is_object()) return path + ": knows no " + key;
    const Json& of_key = known ? s["properties"][key] : s["additionalProperties"];
    if (const std::string problem = wrong(item, of_key, path + "." + key); !problem.empty()) return problem;
  }
  return "";
}

TEST(ExperimentSchema, TakesEveryShippedExperiment) {
  const Json s = schema();
  int count = 0;
  for (const char* folder : {"inputs/accuracy", "inputs/sweeps"})
    for (const auto& entry : std::filesystem::directory_iterator(std::string(FOOTFALL_SOURCE_DIR) + "/" + folder)) {
      if (entry.path().extension() != ".toml") continue;
      EXPECT_EQ(wrong(parse_toml_file(entry.path()), s, ""), "") << entry.path();
      ++count;
    }
  EXPECT_GT(count, 20);
}

TEST(ExperimentSchema, HoldsTheKeysOfEverySection) {
  const Json s = schema()["properties"];
  EXPECT_TRUE(s["parameters"]["items"]["properties"]["choices"]["items"]["properties"].contains("settings"));
  EXPECT_TRUE(s["curves"]["items"]["properties"].contains("order_beyond"));
  EXPECT_TRUE(s["figures"]["items"]["properties"]["reduce"].contains("enum"));
  EXPECT_TRUE(s["fits"]["items"]["properties"]["factors"]["items"]["properties"].contains("published"));
  EXPECT_TRUE(s["growth"]["properties"].contains("substeps"));
  EXPECT_EQ(
      wrong(parse_toml_file(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/dropped_sphere/scene.toml"), schema(), ""),
      ": knows no bodies");
}

}  // namespace
}  // namespace footfall
