// Visitors that write the JSON schema, the keys of each kind, and the values of a scene.

#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/joint_spec.h"
#include "mbd_solver/scene/kind_keys.h"
#include "mbd_solver/scene/scene_schema.h"

namespace footfall {

// ---- values ----

static Json to_json(double v) { return v; }
static Json to_json(int v) { return v; }
static Json to_json(bool v) { return v; }
static Json to_json(const std::string& v) { return v; }
static Json to_json(const Eigen::Vector2d& v) { return {v[0], v[1]}; }
static Json to_json(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
static Json to_json(const Eigen::Quaterniond& q) { return {{"quaternion", {q.w(), q.x(), q.y(), q.z()}}}; }
static Json to_json(const Eigen::Matrix3d& m) { return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)}; }
static Json to_json(const std::map<std::string, std::string>& v) { return v.empty() ? Json::object() : Json(v); }
static Json to_json(const Choice& v) { return v.names[v.value]; }
static Json to_json(const NumberOrWord& v) { return *v.number; }
static Json to_json(const PerAxis& v) {
  const Eigen::Vector3d& k = *v.values;
  return k[0] == k[1] && k[1] == k[2] ? Json(k[0]) : to_json(k);
}
static Json to_json(const NamedTexts& v) {
  if (v.names->empty()) return v.texts->empty() ? Json::array() : Json(*v.texts);
  Json table = Json::object();
  for (std::size_t i = 0; i < v.names->size(); ++i) table[(*v.names)[i]] = (*v.texts)[i];
  return table;
}
static Json to_json(const Source&) { return nullptr; }
template <class T>
static Json to_json(const std::optional<T>& v) {
  return v ? to_json(*v) : Json(nullptr);
}
template <class Range>
static Json list_to_json(const Range& values) {
  Json list = Json::array();
  for (const auto& value : values) list.push_back(to_json(value));
  return list;
}
template <class T>
static Json to_json(const std::vector<T>& v) {
  return list_to_json(v);
}
template <class T, std::size_t N>
static Json to_json(const std::array<T, N>& v) {
  return list_to_json(v);
}

static Json json_of(const FieldRef& ref) {
  return std::visit([](const auto* value) { return to_json(*value); }, ref);
}

// ---- keys of kinds ----

namespace {

Json keys_of_joint(JointType type) {
  const JointTraits traits = traits_of(type);
  Json required = Json::array(), optional = Json::array();
  const auto add = [&](const char* key, KeyUse use) {
    if (use == KeyUse::kRequired) required.push_back(key);
    if (use == KeyUse::kOptional) optional.push_back(key);
  };
  add("axis", traits.axis);
  add("axis2", traits.axis2);
  add("length", traits.length);
  add("radius", traits.radius);
  add("motion", traits.motion);
  for (const Coordinate coordinate : coordinates_of(type)) optional.push_back(name_of(coordinate));
  return {{"required", required}, {"optional", optional}};
}

// Which of them are required only the checks know.
template <class Kind>
Json every_kind() {
  Json all = Json::object();
  for (const Kind kind : every<Kind>())
    all[std::string(name_of(kind))] = {{"required", Json::array()}, {"optional", keys_of(kind)}};
  return all;
}

}  // namespace

Json kind_schema() {
  Json joints = Json::object(), shapes = Json::object();
  for (const JointType type : every<JointType>()) joints[std::string(name_of(type))] = keys_of_joint(type);
  for (const ShapeKind kind : every<ShapeKind>()) {
    const ShapeKeys keys = keys_of(kind);
    shapes[std::string(name_of(kind))] = {{"required", keys.required}, {"optional", keys.optional}};
  }
  return {{"shapes", shapes},
          {"joints", joints},
          {"springs", every_kind<SpringKind>()},
          {"drives", every_kind<MotorKind>()},
          {"controllers", every_kind<ControllerKind>()},
          {"signals", every_kind<SignalKind>()}};
}

// A visitor that writes the type of every key.

namespace {

Json of_type(const char* type) { return {{"type", type}}; }
Json any_of(Json first, Json second) { return {{"anyOf", Json::array({std::move(first), std::move(second)})}}; }

Json list_of(Json item, int least, int most) {
  Json list = of_type("array");
  list["items"] = std::move(item);
  if (least > 0) list["minItems"] = least;
  if (most > 0) list["maxItems"] = most;
  return list;
}

Json number(const Rule& rule) {
  Json type = of_type("number");
  switch (rule.range) {
    case Range::kAny: break;
    case Range::kPositive: type["exclusiveMinimum"] = 0; break;
    case Range::kNotNegative: type["minimum"] = 0; break;
    case Range::kUnitInterval:
      type["minimum"] = 0;
      type["maximum"] = 1;
      break;
  }
  return type;
}

Json whole(const Rule& rule) {
  Json type = number(rule);
  type["type"] = "integer";
  return type;
}

Json vector_of(const Rule& rule) {
  Json three = list_of(number(rule), 3, 3);
  if (rule.meaning != Meaning::kDirection) return three;
  return any_of(three, {{"enum", {"x", "y", "z", "-x", "-y", "-z"}}});
}

// What the reader accepts for a member of each type (field_reader.cpp).
Json type_of(const double&, const Rule& rule) { return number(rule); }
Json type_of(const int&, const Rule& rule) { return whole(rule); }
Json type_of(const bool&, const Rule&) { return of_type("boolean"); }
Json type_of(const std::string&, const Rule& rule) {
  return rule.meaning == Meaning::kWords ? Json{{"type", {"string", "number"}}} : of_type("string");
}
Json type_of(const std::vector<std::string>&, const Rule& rule) {
  const Json word = type_of(std::string(), rule), list = list_of(word, 0, 0);
  return rule.meaning == Meaning::kWords ? any_of(word, list) : list;
}
Json type_of(const std::array<std::string, 2>&, const Rule&) { return list_of(of_type("string"), 2, 2); }
Json type_of(const Eigen::Vector3d&, const Rule& rule) { return vector_of(rule); }
Json type_of(const std::vector<Eigen::Vector3d>&, const Rule& rule) { return list_of(vector_of(rule), 0, 0); }
Json type_of(const std::array<Eigen::Vector3d, 2>&, const Rule& rule) { return list_of(vector_of(rule), 2, 2); }
Json type_of(const std::vector<double>&, const Rule& rule) { return any_of(number(rule), list_of(number(rule), 0, 0)); }
Json type_of(const std::vector<int>&, const Rule& rule) { return list_of(whole(rule), 0, 0); }
Json type_of(const std::vector<Eigen::Vector2d>&, const Rule&) {  // pairs, or a CSV file
  return any_of(list_of(list_of(of_type("number"), 2, 2), 2, 0), of_type("string"));
}
Json type_of(const Eigen::Quaterniond&, const Rule&) {
  const Json three = list_of(of_type("number"), 3, 3), four = list_of(of_type("number"), 4, 4);
  const Json axis = any_of(three, {{"enum", {"x", "y", "z", "-x", "-y", "-z"}}});
  Json one = of_type("object"), turn = of_type("object");
  one["properties"] = {{"rpy_deg", three}, {"rpy", three}, {"quaternion", four}};
  one["minProperties"] = one["maxProperties"] = 1;
  one["additionalProperties"] = false;
  turn["properties"] = {{"axis", axis}, {"angle_deg", of_type("number")}, {"angle", of_type("number")}};
  turn["minProperties"] = turn["maxProperties"] = 2;
  turn["additionalProperties"] = false;
  return any_of(one, turn);
}
Json type_of(const Eigen::Matrix3d&, const Rule&) { return list_of(of_type("number"), 3, 6); }
Json type_of(const std::map<std::string, std::string>&, const Rule&) {
  Json table = of_type("object");
  table["additionalProperties"] = {{"type", {"string", "number"}}};
  return table;
}
Json type_of(const NamedTexts&, const Rule& rule) {
  return any_of(type_of(std::vector<std::string>(), rule), type_of(std::map<std::string, std::string>(), rule));
}
Json type_of(const Choice& choice, const Rule&) { return {{"enum", choice.names}}; }
Json type_of(const NumberOrWord& value, const Rule& rule) { return any_of(number(rule), {{"const", value.word}}); }
Json type_of(const PerAxis&, const Rule& rule) { return any_of(number(rule), list_of(number(rule), 3, 3)); }
Json type_of(const Source&, const Rule&) { return {}; }
template <class T>
Json type_of(const std::optional<T>&, const Rule& rule) {
  return type_of(T(), rule);
}

std::string description(const Rule& rule, const std::string& unit) {
  std::string text;
  if (!unit.empty()) text = "[" + unit + "]";
  const auto add = [&](const char* what) { text += (text.empty() ? "" : " ") + std::string(what); };
  if (rule.meaning == Meaning::kPath) add("A file, relative to the scene's folder.");
  if (rule.meaning == Meaning::kDirection) add("A direction of any length.");
  if (rule.required) add("Required.");
  return text;
}

class SchemaWriter final : public FieldVisitor {
 public:
  // `layers`: tables may drop keys of a base.
  explicit SchemaWriter(bool layers) : layers_(layers) {
    root = open_table();
    stack_.push_back(&root);
  }
  Json root;

  void field(const std::string& key, const FieldRef& ref, const Rule& rule) override {
    if (key.empty()) return;
    Json type = std::visit([&](const auto* value) { return type_of(*value, rule); }, ref);
    const std::string text = description(rule, unit_name(rule.unit));
    if (!text.empty()) type["description"] = text;
    // The default is given in SI units only.
    for (const UnitSuffix& unit : unit_suffixes(rule.unit)) {
      Json other = type;
      other["description"] = description(rule, unit.suffix.substr(1));
      other["x-unit-of"] = key;
      properties()[key + unit.suffix] = std::move(other);
    }
    const Json value = rule.required ? Json() : json_of(ref);
    const bool bound = value.is_number() && std::isinf(value.get<double>());  // none is given
    if (!value.is_null() && value != "" && value != Json::array() && !bound) type["default"] = value;
    properties()[key] = std::move(type);
  }

  bool begin_section(const std::string& key, Presence presence, bool&) override {
    Json& place = properties()[key];
    if (presence == Presence::kSwitch) {
      place = any_of(of_type("boolean"), open_table());
      stack_.push_back(&place["anyOf"][1]);
    } else {
      place = open_table();
      stack_.push_back(&place);
    }
    return true;
  }
  void end_section() override { stack_.pop_back(); }

  int begin_list(const std::string& key, bool named, int) override {
    Json& place = properties()[key];
    place = of_type(named ? "object" : "array");
    Json& item = place[named ? "additionalProperties" : "items"];
    item = open_table();
    stack_.push_back(&item);
    return -1;
  }
  void begin_item(int, std::string*) override {}
  void end_item() override {}
  void end_list() override { stack_.pop_back(); }

 private:
  // A table that knows its keys.
  Json open_table() const {
    Json table = of_type("object");
    table["properties"] = Json::object();
    if (layers_) table["properties"]["without"] = list_of(of_type("string"), 0, 0);
    table["additionalProperties"] = false;
    return table;
  }
  Json& properties() { return (*stack_.back())["properties"]; }

  bool layers_;
  std::vector<Json*> stack_;
};

Json schema_text(const std::string& title, const Json& root) {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  schema.update(root);
  return schema;
}

}  // namespace

std::string schema_of(const std::string& title, const std::function<void(FieldVisitor&)>& describe) {
  SchemaWriter writer(false);
  describe(writer);
  return schema_text(title, writer.root).dump(2);
}

std::string scene_schema() {
  SchemaWriter writer(true);
  Scene scene;
  visit_fields(writer, scene);
  Json base = of_type("string");
  base["description"] = "Path of a scene that this one modifies.";
  writer.root["properties"]["base"] = std::move(base);
  // The reader accepts a number as well.
  Json& joint = writer.root["properties"]["initial"]["properties"]["joints"]["additionalProperties"];
  joint = any_of(of_type("number"), joint);
  Json schema = schema_text("Scene of footfall", writer.root);
  schema["x-kinds"] = kind_schema();
  return schema.dump(2);
}

// A visitor that writes values.

namespace {

class JsonWriter final : public FieldVisitor {
 public:
  Json root = Json::object();

  void field(const std::string& key, const FieldRef& ref, const Rule&) override {
    if (!key.empty()) current()[key] = json_of(ref);
  }
  bool begin_section(const std::string& key, Presence, bool& present) override {
    Json& place = current()[key];
    if (!present) return false;
    place = Json::object();
    stack_.push_back(&place);
    return true;
  }
  void end_section() override { stack_.pop_back(); }
  int begin_list(const std::string& key, bool named, int count) override {
    Json& place = current()[key];
    place = named ? Json::object() : Json::array();
    stack_.push_back(&place);
    return count;
  }
  void begin_item(int, std::string* name) override {
    Json& list = current();
    if (!name) list.push_back(Json::object());
    Json& item = name ? list[*name] : list.back();
    stack_.push_back(&item);
  }
  void end_item() override { stack_.pop_back(); }
  void end_list() override { stack_.pop_back(); }

 private:
  Json& current() { return stack_.empty() ? root : *stack_.back(); }
  std::vector<Json*> stack_;
};

}  // namespace

std::string scene_json(const Scene& scene) {
  JsonWriter writer;
  Scene copy = scene;
  visit_fields(writer, copy);
  return writer.root.dump(2);
}

}  // namespace footfall
