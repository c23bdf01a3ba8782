// Every kind has a name and a place in the reference: coupler/base/kinds.h.

#include <gtest/gtest.h>

#include "coupler/base/text.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/kind_keys.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {
namespace {

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
  std::istringstream page(text_of(FOOTFALL_SOURCE_DIR "/docs/scene.md"));
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
      if (!rule.required) defaults.emplace_back(key, (*choice)->names[static_cast<std::size_t>((*choice)->value)]);
    }
    if (rule.required) return;
    // 0 stands for "not given" as often as for a number: it is left to the comment.
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
                       << "; the comments beside it in inputs/reference/scene.toml say:" << given;
  }
}

// A scene holds one of several choices; the comment beside it names the others.
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
  Names common{"name", "kind", "joint", "coordinate", "max_torque", "gear_ratio", "rotor_inertia"};
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

}  // namespace
}  // namespace footfall
