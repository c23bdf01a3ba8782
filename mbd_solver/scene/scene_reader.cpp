// The steps from a file to a checked scene: bases, --set, soil, short forms of initial joints.

#include <toml++/toml.h>
#include <algorithm>
#include <filesystem>
#include <optional>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/input_file.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/budget.h"
#include "mbd_solver/base/named_file.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/joint_spec.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/scene_check.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/toml_file.h"

namespace footfall {
using namespace code;

namespace {

ConfigNode convert(const toml::node& node) {
  ConfigNode result;
  result.line = static_cast<int>(node.source().begin.line);
  if (const toml::table* table = node.as_table()) {
    result.kind = ConfigNode::Kind::kTable;
    for (const auto& [key, value] : *table) {
      ConfigNode child = convert(value);
      if (child.line == 0) child.line = static_cast<int>(key.source().begin.line);
      result.table.emplace_back(std::string(key.str()), std::move(child));
    }
  } else if (const toml::array* array = node.as_array()) {
    result.kind = ConfigNode::Kind::kList;
    for (const toml::node& value : *array) result.list.push_back(convert(value));
  } else if (const auto* text = node.as_string()) {
    result.kind = ConfigNode::Kind::kText;
    result.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    result.kind = ConfigNode::Kind::kInteger;
    result.number = static_cast<double>(integer->get());
  } else if (const auto* number = node.as_floating_point()) {
    result.kind = ConfigNode::Kind::kNumber;
    result.number = number->get();
  } else if (const auto* flag = node.as_boolean()) {
    result.kind = ConfigNode::Kind::kFlag;
    result.flag = flag->get();
  } else {
    result.kind = ConfigNode::Kind::kOther;
  }
  return result;
}

void mark_as_set(ConfigNode& node) {
  node.line = Source::kFromSet;
  for (auto& [key, child] : node.table) mark_as_set(child);
  for (ConfigNode& child : node.list) mark_as_set(child);
}

// The value of --set: TOML, or a bare word ("ida"), which counts as text.
ConfigNode parse_value(const std::string& text) {
  ConfigNode node;
  try {
    node = convert(*toml::parse("value = " + text).get("value"));
  } catch (const toml::parse_error&) {
    node.kind = ConfigNode::Kind::kText;
    node.text = text;
  }
  mark_as_set(node);
  return node;
}

constexpr int kMostParts = 100;  // of a dotted key
const char* const kTooManyParts = " has more than 100 parts between dots, expected a few";

int dots_in(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '.')); }

// The library parses a dotted key recursively.
void require_flat_keys(const std::string& file, const std::string& text) {
  int number = 0;
  for (const std::string& line : split(text, '\n')) {
    ++number;
    if (static_cast<int>(line.size()) <= kMostParts || dots_in(line) <= kMostParts) continue;
    for (std::size_t begin = 0; begin < line.size();) {  // keys stand before "=" and within "[" and "]"
      const std::size_t end = std::min(line.find_first_of("=],{}", begin), line.size());
      const bool key = end < line.size() && line[end] != ',';
      if (key && dots_in(line.substr(begin, end - begin)) > kMostParts)
        throw InputError(kKeyTooDeep, place_of(file, number, ""), "a key", kTooManyParts);
      begin = end + 1;
    }
  }
}

// The entry `name` of a list of tables, by name or by index from 0; null after a finding.
ConfigNode* list_entry(ConfigNode& list, const std::string& name, const std::string& path, const ArrayCounts& arrays,
                       Findings& findings) {
  std::vector<std::string> names;
  for (ConfigNode& item : list.list) {
    names.push_back(item.entry_name());
    if (names.back() == name) return &item;
    for (const auto& [array, count] : arrays)  // a copy that another setting has named
      for (int k = 1; k <= count; ++k) {
        const std::string mark = concat("{", array, "=", k, "}");
        const std::size_t at = names.back().find(mark);
        if (at == std::string::npos) continue;
        names.back().replace(at, mark.size(), std::to_string(k));
        if (names.back() == name) return &item;
      }
  }
  if (const int copy = own_copy(list, name, arrays); copy >= 0) return &list.list[copy];
  if (!name.empty() && name.find_first_not_of("0123456789") == std::string::npos && name.size() < 6) {
    const std::size_t index = std::stoul(name);
    if (index < list.list.size()) return &list.list[index];
  }
  findings.error(kUnknownEntry, Source::kFromSet, path, "unknown entry \"", name, "\".",
                 known_names("entries", name, names));
  return nullptr;
}

// Whether "leg_{leg}_knee", the name of an array's entries, may become this name: braces stand for any text, and what
// is between them comes as early as it can.
bool may_become(const std::string& pattern, const std::string& name) {
  std::size_t from = 0, at = 0;  // in the pattern, in the name
  for (;;) {
    const std::size_t open = pattern.find('{', from), close = pattern.find('}', open);
    const bool last = open == std::string::npos || close == std::string::npos;
    const std::string piece = last ? pattern.substr(from) : pattern.substr(from, open - from);
    if (last && from > 0) return name.size() - at >= piece.size() && ends_with(name, piece);
    if (last) return name == piece;
    const std::size_t found = name.find(piece, at);
    if (found == std::string::npos || (from == 0 && found > 0)) return false;
    at = found + piece.size();
    from = close + 1;
  }
}

// The type of the joint of this name, copies of arrays included, if it can be read; the reader reports its errors.
std::optional<JointType> type_of_joint(const ConfigNode& root, const std::string& name) {
  const ConfigNode* joints = root.find("joints");
  if (!joints) return std::nullopt;
  const ConfigNode* found = nullptr;
  for (const ConfigNode& joint : joints->list) {
    if (joint.entry_name() == name) found = &joint;
    if (!found && may_become(joint.entry_name(), name)) found = &joint;
  }
  const ConfigNode* type = found ? found->find("kind") : nullptr;
  if (!type) return std::nullopt;
  for (const JointType known : every<JointType>())
    if (type->text == name_of(known)) return known;
  return std::nullopt;
}

ConfigNode table_of(const std::string& key, const ConfigNode& value) {
  ConfigNode table;
  table.line = value.line;
  table.table.emplace_back(key, value);
  return table;
}

// knee = 0.3 in [initial.joints]: the one coordinate of a joint, short for [initial.joints.knee] angle = 0.3.
// Makes tables of the numbers. Values that no joint accepts are reported and dropped.
void expand_initial_joints(ConfigNode& root, Findings& findings) {
  ConfigNode* initial = root.find("initial");
  ConfigNode* joints = initial ? initial->find("joints") : nullptr;
  if (!joints || joints->kind != ConfigNode::Kind::kTable) return;
  std::vector<std::pair<std::string, ConfigNode>> kept;
  for (const auto& [name, node] : joints->table) {
    const std::string path = "initial.joints." + name;
    if (node.kind == ConfigNode::Kind::kTable) {
      kept.emplace_back(name, node);
      continue;
    }
    if (!node.is_number()) {
      findings.coded_error(node.line, path,
                           is_expected(node, "a number (rad, m), or a table such as { angle_deg = 30 }"));
      continue;
    }
    const std::optional<JointType> type = type_of_joint(root, name);
    const std::vector<Coordinate> has = type ? coordinates_of(*type) : std::vector<Coordinate>();
    if (!type) {
      kept.emplace_back(name, table_of("angle", node));  // the checks report a joint that does not exist
    } else if (has.size() == 1) {
      kept.emplace_back(name, table_of(std::string(name_of(has.front())), node));
    } else if (has.empty()) {
      findings.error(code::kInitialJoint, node.line, path, "is given, but a ", name_of(*type),
                     " joint has no coordinate; remove it");
    } else {
      std::vector<std::string> names;
      for (const Coordinate coordinate : has) names.emplace_back(name_of(coordinate));
      findings.error(code::kAmbiguousCoordinate, node.line, path, "is ", node.description(), ", but a ", name_of(*type),
                     " joint has ", joined(names, " and "), "; write [initial.joints.", name, "] ", names.front(),
                     " = ", node.number);
    }
  }
  joints->table = std::move(kept);
}

Scene scene_of(ConfigNode root, const std::string& file, const std::vector<std::string>& settings) {
  Findings findings(file);
  for (const std::string& setting : settings) apply_setting(root, setting, findings);
  add_soil(root, findings);
  rename_second_spellings(root);
  add_ground_soil(root, std::filesystem::absolute(file).parent_path().string(), findings);
  expand_initial_joints(root, findings);

  Scene scene;
  scene.file = file;
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  scene.folder = folder.string();
  scene.settings = settings;
  read_fields(root, scene, findings);
  resolve_scene(scene, findings);
  check_scene(scene, findings);
  findings.throw_if_errors();
  scene.warnings = findings.warnings();
  return scene;
}

}  // namespace

ConfigNode parse_toml_file(const std::string& file) {
  require_regular_file(file, kLargestText);
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) throw InputError(kFileNotReadable, file, ": cannot be read; expected a scene file (TOML)");
  return parse_toml(*text, file);
}

ConfigNode parse_toml(const std::string& text, const std::string& file) {
  ReadBudget parts(limit::kTomlParts, file);
  parts.take(static_cast<std::uint64_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return c == '=' || c == ',' || c == '['; })));
  if (text.find('\0') != std::string::npos)
    throw InputError(kNotToml, file, ": is no text file (a picture, an archive, a program?); expected TOML");
  require_flat_keys(file, text);
  try {
    return convert(toml::parse(text, file));
  } catch (const toml::parse_error& e) {
    throw InputError(kNotToml, place_of(file, static_cast<int>(e.source().begin.line), ""),
                     "is not valid TOML: ", e.description());
  }
}

void apply_setting(ConfigNode& root, const std::string& setting, Findings& findings) {
  const std::size_t equals = setting.find('=');
  const std::string path = setting.substr(0, equals);
  const auto refuse = [&](const MessageCode& code, const std::string& what) {
    findings.error(code, Source::kFromSet, path.substr(0, 60) + (path.size() > 60 ? "..." : ""), what);
  };
  if (equals == std::string::npos || equals == 0)
    return refuse(kMalformedSetting, "is no setting, expected key=value, for example solver.integrator=ida");
  if (dots_in(path) > kMostParts) return refuse(kKeyTooDeep, concat("the key", kTooManyParts));
  ConfigNode* node = &root;
  for (const std::string& part : split(path, '.')) {
    if (part.empty()) return refuse(kMalformedSetting, "has an empty part, expected names separated by single dots");
    if (node->kind == ConfigNode::Kind::kList) {
      node = list_entry(*node, part, path, arrays_of(root), findings);
      if (!node) return;
      continue;
    }
    if (node->kind != ConfigNode::Kind::kTable) {  // "flexible = true" becomes a table when one of its keys is set
      *node = ConfigNode{};
      node->line = Source::kFromSet;
    }
    if (!node->find(part)) {
      ConfigNode fresh;
      fresh.line = Source::kFromSet;
      node->table.emplace_back(part, fresh);
    }
    node = node->find(part);
  }
  *node = parse_value(setting.substr(equals + 1));
}

std::string scene_file(const std::string& argument) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const std::string expected = "a scene file (TOML), or a folder with a scene.toml";
  if (argument.empty()) throw InputError(kNoScene, "the name of the scene is empty; expected ", expected);
  if (fs::is_directory(argument, ignored)) {
    const fs::path file = fs::path(argument) / "scene.toml";
    if (!fs::exists(file, ignored) && fs::exists(fs::path(argument) / "history.csv", ignored))
      throw InputError(kNoScene, argument,
                       ": is the folder of a run, not a scene; `footfall view`, `plot` and `report` show it, `footfall "
                       "run --resume ",
                       argument, "` continues it, and its summary.json names the scene (scene_file)");
    if (!fs::exists(file, ignored))
      throw InputError(kNoScene, argument, ": is a folder without scene.toml; expected ", expected);
    return file.string();
  }
  if (!fs::exists(argument, ignored))
    throw InputError(kNoScene, argument, ": no such file or folder; expected ", expected, suggested_path(argument));
  return argument;
}

std::string large_scene_file(const std::string& argument) {
  const std::filesystem::path file = std::filesystem::path(scene_file(argument)).replace_filename("large.toml");
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError(kNoScene, argument, ": has no larger version; expected ", file.string(),
                     ", a scene with this one as its `base`");
  return file.string();
}

Scene read_scene(const std::string& argument, const std::vector<std::string>& settings) {
  const std::string file = scene_file(argument);
  return scene_of(parse_scene_with_base(file), file, settings);
}

Scene read_scene_text(const std::string& text, const std::string& folder, const std::vector<std::string>& settings) {
  const std::string file = (std::filesystem::path(folder) / kSceneText).string();
  return scene_of(parse_scene_with_base(text, file), file, settings);
}

}  // namespace footfall
