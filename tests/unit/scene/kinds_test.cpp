// Every kind of part: reference scene, keys, schema.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "coupler/base/text.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/kind_keys.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/scene/toml_file.h"
#include "tests/unit/scene/key_list.h"

namespace footfall {
namespace {

// Every kind has a name and a place in the reference: mbd_solver/base/kinds.h.

using Names = std::set<std::string>;

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

template <class Kind>
Names names() {
  const std::vector<std::string> all = names_of<Kind>();
  return {all.begin(), all.end()};
}

Names law_names() {
  Names all;
  const StrutSpec strut;
  each_law(strut, [&](const char* key, const auto&) { all.insert(key); });
  return all;
}

// First cells of the table rows "| `name` | ..." of the first table below the heading that begins so.
Names names_on_page(const std::string& heading) {
  std::istringstream page(text_of(FOOTFALL_SOURCE_DIR "/docs/reference/scene.md"));
  Names found;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("## ", 0) == 0) inside = line.rfind("## " + heading, 0) == 0;
    if (inside && !found.empty() && line.empty()) break;
    if (inside && line.rfind("| `", 0) == 0) found.insert(line.substr(3, line.find('`', 3) - 3));
  }
  return found;
}

TEST(SceneKinds, EachHasItsRowOnThePage) {
  EXPECT_EQ(names_on_page("Joints"), names<JointType>());
  EXPECT_EQ(names_on_page("Laws of a strut"), law_names());
  EXPECT_EQ(names_on_page("Springs"), names<SpringKind>());
  EXPECT_EQ(names_on_page("Forces"), names<ForceFrame>());
  EXPECT_EQ(names_on_page("Drives"), names<MotorKind>());
  EXPECT_EQ(names_on_page("Controllers"), names<ControllerKind>());
  EXPECT_EQ(names_on_page("Signals"), names<SignalKind>());
  EXPECT_EQ(names_on_page("Shapes"), names<ShapeKind>());
  EXPECT_EQ(names_on_page("Ground"), names<GroundKind>());
}

TEST(ReferenceScene, HoldsEveryKind) {
  const Scene scene = read_scene(FOOTFALL_SOURCE_DIR "/inputs/reference");
  Names joints, springs, controllers, signals, laws, shapes;
  for (const JointSpec& joint : scene.joints) joints.emplace(name_of(joint.type));
  for (const SpringSpec& spring : scene.springs) springs.emplace(name_of(spring.kind));
  for (const ControllerSpec& controller : scene.controllers) controllers.emplace(name_of(controller.kind));
  for (const SignalSpec& signal : scene.signals) signals.emplace(name_of(signal.kind));
  for (const BodySpec& body : scene.bodies)
    if (body.shape) shapes.emplace(name_of(body.shape->kind));
  for (const StrutSpec& strut : scene.struts)
    each_law(strut, [&](const char* key, const auto& law) {
      if (law) laws.insert(key);
    });
  EXPECT_EQ(joints, names<JointType>());
  EXPECT_EQ(springs, names<SpringKind>());
  EXPECT_EQ(controllers, names<ControllerKind>());
  EXPECT_EQ(signals, names<SignalKind>());
  EXPECT_EQ(laws, law_names());
  EXPECT_EQ(shapes, names<ShapeKind>());
}

// Enters every key; collects the names of all choices, and what a key is where the file is silent, as text.
class Collector final : public FieldVisitor {
 public:
  Names choices;
  std::vector<std::pair<std::string, std::string>> defaults;  // key, value
  void field(const std::string& key, const FieldRef& ref, const Rule& rule) override {
    if (Choice* const* choice = std::get_if<Choice*>(&ref)) {
      choices.insert((*choice)->names.begin(), (*choice)->names.end());
      if (!rule.required) defaults.emplace_back(key, (*choice)->names[(*choice)->value]);
    }
    if (rule.required) return;
    // 0 means "not given" as often as for a number: it is left to the comment.
    if (double* const* number = std::get_if<double*>(&ref); number && **number != 0.0)
      defaults.emplace_back(key, number_text(**number));
    if (int* const* number = std::get_if<int*>(&ref); number && **number != 0)
      defaults.emplace_back(key, std::to_string(**number));
    if (bool* const* flag = std::get_if<bool*>(&ref)) defaults.emplace_back(key, **flag ? "true" : "false");
  }
  bool begin_section(const std::string&, Presence, bool&) override { return true; }
  void end_section() override {}
  int begin_list(const std::string&, bool, int) override { return -1; }
  void begin_item(int, std::string*) override {}
  void end_item() override {}
  void end_list() override {}
};

// The word after "default" in a comment, in SI where a unit in milli- follows: "Default 5 mm" -> "0.005".
std::string default_in(const std::string& comment) {
  const std::size_t at = comment.find("efault ");
  if (at == std::string::npos) return "";
  std::istringstream rest(comment.substr(at + 7));
  std::string word, unit;
  rest >> word >> unit;
  while (!word.empty() && (word.back() == '.' || word.back() == ')' || word.back() == ',')) word.pop_back();
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') return word;
  return number_text(unit.substr(0, 2) == "mm" || unit.substr(0, 2) == "ms" ? 1e-3 * value : value);
}

TEST(ReferenceScene, GivesTheDefaultsOfTheReader) {
  std::vector<std::pair<std::string, std::string>> lines;  // code, default
  std::istringstream text(text_of(FOOTFALL_SOURCE_DIR "/inputs/reference/scene.toml"));
  for (std::string line; std::getline(text, line);) {
    const std::size_t comment = line.find(" #");
    if (comment != std::string::npos) lines.emplace_back(line.substr(0, comment), default_in(line.substr(comment)));
  }
  Collector collector;
  Scene scene;
  visit_fields(collector, scene);
  for (const auto& [key, value] : collector.defaults) {
    const std::regex as_key("(^|[ {,])" + key + "(_[A-Za-z_0-9]+)? = ");  // toe = ..., toe_mm = ...
    std::string given;
    bool found = false;  // keys of one name may stand in several tables
    for (const auto& [code, stated] : lines) {
      if (!std::regex_search(code, as_key)) continue;
      found = found || stated == value;
      given += " " + (stated.empty() ? "nothing" : stated);
    }
    EXPECT_TRUE(found) << "the default of " << key << " is " << value
                       << "; the comments next to it in inputs/reference/scene.toml say:" << given;
  }
}

// A scene holds one of several choices; the comment next to it names the others.
TEST(ReferenceScene, NamesEveryChoice) {
  const std::string text = text_of(FOOTFALL_SOURCE_DIR "/inputs/reference/scene.toml");
  Collector collector;
  Scene scene;
  visit_fields(collector, scene);
  for (const std::string& name : collector.choices)
    EXPECT_NE(text.find("\"" + name + "\""), std::string::npos)
        << "inputs/reference/scene.toml nowhere names \"" << name << "\"";
}

// The keys of entries of one list, as known_keys() gives them: "controllers[].kp" -> "kp".
Names keys_of_entries(const std::string& list) {
  Names keys;
  for (const std::string& key : known_keys())
    if (key.rfind(list + "[].", 0) == 0) keys.insert(key.substr(list.size() + 3));
  return keys;
}

// `common` and the keys of all kinds together are the keys that the reader knows.
template <class Kind>
void expect_every_key_to_belong(const std::string& list, Names common) {
  for (const Kind kind : every<Kind>())
    for (const std::string& key : keys_of(kind)) {
      EXPECT_TRUE(keys_of_entries(list).count(key))
          << list << ": " << name_of(kind) << " lists the unknown key " << key;
      common.insert(key);
    }
  EXPECT_EQ(keys_of_entries(list), common) << "kind_keys.h says which kind of " << list << " a key belongs to";
}

TEST(SceneKinds, EveryKeyOfASpringBelongsToAKind) {
  expect_every_key_to_belong<SpringKind>("springs", {"name", "kind", "bodies", "point", "stiffness", "damping"});
}

TEST(SceneKinds, EveryKeyOfADriveBelongsToAKind) {
  Names common{"name", "kind", "joint", "coordinate", "max_torque", "max_force", "gear_ratio", "rotor_inertia"};
  for (const char* part : {"", ".polynomial", ".amplitude", ".frequency", ".phase", ".table", ".signal"})
    common.insert(std::string("command") + part);
  expect_every_key_to_belong<MotorKind>("drives", common);
}

TEST(SceneKinds, EveryKeyOfAControllerBelongsToAKind) {
  expect_every_key_to_belong<ControllerKind>("controllers", {"name", "kind", "body", "period", "outputs"});
}

TEST(SceneKinds, EveryKeyOfASignalBelongsToAKind) {
  expect_every_key_to_belong<SignalKind>("signals", {"name", "kind", "period", "states"});
}

// Keys of an entry of [[family]], or of the shape of a body, as the reader knows them, without keys in other units.
Names keys_of_schema(const std::string& family) {
  Json schema = Json::parse(scene_schema());
  const Json& place = family == "shapes" ? schema["properties"]["bodies"]["items"]["properties"]["shape"]
                                         : schema["properties"][family];
  const Json& entry = place.contains("properties") ? place
                      : place.contains("items")    ? place["items"]
                                                   : place["additionalProperties"];
  Names keys;
  for (const auto& [key, value] : entry["properties"].items())
    if (!value.contains("x-unit-of") && key != "without") keys.insert(key);
  return keys;
}

Names keys_of_kinds(const std::string& family) {
  Names keys;
  const Json schema = kind_schema();
  for (const auto& [kind, uses] : schema[family].items())
    for (const char* use : {"required", "optional"})
      for (const Json& key : uses[use]) keys.insert(key.get<std::string>());
  return keys;
}

TEST(KindSchema, EveryKeyOfAJointBelongsToAKindOrToAll) {
  Names expected = keys_of_schema("joints");
  for (const char* of_all : {"name", "kind", "bodies", "point", "point_a", "point_b"})
    EXPECT_EQ(expected.erase(of_all), 1U);
  EXPECT_EQ(keys_of_kinds("joints"), expected);
}

TEST(KindSchema, EveryKeyOfAShapeBelongsToAKind) {
  Names expected = keys_of_schema("shapes");
  EXPECT_EQ(expected.erase("kind"), 1U);
  EXPECT_EQ(keys_of_kinds("shapes"), expected);
}

TEST(KindSchema, NamesOnlyKeysThatTheReaderKnows) {
  const Json schema = kind_schema();
  for (const auto& [family, kinds] : schema.items()) {
    const Names known = keys_of_schema(family);
    EXPECT_GT(kinds.size(), 2U) << family;
    for (const std::string& key : keys_of_kinds(family)) EXPECT_EQ(known.count(key), 1U) << family << ": " << key;
  }
}

TEST(KindSchema, IsPartOfTheSchema) { EXPECT_EQ(Json::parse(scene_schema())["x-kinds"], kind_schema()); }

// The schema says what the reader does: the same keys, and every shipped scene is valid by it.

using Json = nlohmann::json;

Json schema() { return Json::parse(scene_schema()); }

// All keys of a schema's tables as known_keys() writes them, but for those that every table has.
void list_keys(const Json& node, const std::string& prefix, std::set<std::string>& keys) {
  if (node.contains("anyOf"))
    for (const Json& way : node["anyOf"]) list_keys(way, prefix, keys);
  if (node.contains("properties") && !node.contains("maxProperties"))
    for (const auto& [key, value] : node["properties"].items()) {
      if (key == "without" || (prefix.empty() && key == "base")) continue;
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
