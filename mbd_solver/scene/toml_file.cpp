// Text -> ConfigNode by the library toml++, which only this file uses; --set.

#include <algorithm>
#include <array>
#include <filesystem>
#include <unordered_map>
#include <unordered_set>

#include "coupler/base/text.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/toml_file.h"

namespace footfall {

const ConfigNode* ConfigNode::find(const std::string& key) const {
  for (const auto& [name, node] : table) {
    if (name == key) return &node;
  }
  return nullptr;
}

ConfigNode* ConfigNode::find(const std::string& key) {
  return const_cast<ConfigNode*>(static_cast<const ConfigNode*>(this)->find(key));
}

std::string ConfigNode::entry_name() const {
  for (const char* key : {"name", "body"}) {
    const ConfigNode* node = find(key);
    if (node && node->kind == Kind::kText) return node->text;
  }
  return "";
}

std::string ConfigNode::description() const {
  switch (kind) {
    case Kind::kTable: return "a table";
    case Kind::kList: return concat("a list of ", list.size());
    case Kind::kText: return "text \"" + text + "\"";
    case Kind::kInteger:
    case Kind::kNumber: return concat("the number ", number);
    case Kind::kFlag: return flag ? "true" : "false";
    case Kind::kOther: break;
  }
  return "a date or time";
}

ArrayCounts arrays_of(const ConfigNode& root) {
  ArrayCounts out;
  const ConfigNode* const arrays = root.find("arrays");
  if (arrays == nullptr) return out;
  for (const auto& [name, array] : arrays->table)
    if (const ConfigNode* const count = array.find("count"); count != nullptr && count->is_number())
      out.emplace_back(name, static_cast<int>(std::clamp(count->number, 0.0, 1000.0)));
  return out;
}

int own_copy(ConfigNode& list, const std::string& name, const ArrayCounts& arrays) {
  for (std::size_t i = 0; i < list.list.size(); ++i) {
    const std::string pattern = list.list[i].entry_name();
    for (const auto& [array, count] : arrays) {
      const std::size_t begin = pattern.find("{" + array), mark = begin + 1 + array.size();
      if (begin == std::string::npos || mark >= pattern.size() || (pattern[mark] != '}' && pattern[mark] != '!'))
        continue;
      const std::size_t end = pattern.find('}', mark);
      if (end == std::string::npos) continue;
      const std::string before = pattern.substr(0, begin), behind = pattern.substr(end + 1);
      for (int k = 1; k <= count; ++k) {
        const std::string number = std::to_string(k);
        if (before + number + behind != name) continue;
        ConfigNode copy = list.list[i];
        const char* const key = copy.find("name") ? "name" : "body";
        copy.find(key)->text = before + "{" + array + "=" + number + "}" + behind;
        list.list[i].find(key)->text = pattern.substr(0, end) + "!" + number + pattern.substr(end);
        list.list.insert(list.list.begin() + i + 1, std::move(copy));
        return static_cast<int>(i) + 1;
      }
    }
  }
  return -1;
}

// Reads a scene and its bases, the innermost base first, and merges each over the one before.
using namespace code;
namespace {

namespace fs = std::filesystem;

constexpr int kLongestChain = 8;  // bases of bases
constexpr std::array<const char*, 12> kPathKeys = {"script",      "file",        "mesh",         "grains",
                                                   "table",       "yield_table", "yield_stress", "stiffness_matrix",
                                                   "mass_matrix", "node_file",   "dof_file",     "stress_file"};

// Values of a base have no line in the file that is read, and their paths are relative to another folder.
void move_to(ConfigNode& node, const fs::path& folder) {
  node.line = 0;
  for (auto& [key, child] : node.table) {
    const bool is_path = std::find(kPathKeys.begin(), kPathKeys.end(), key) != kPathKeys.end();
    if (is_path && child.kind == ConfigNode::Kind::kText && !child.text.empty() && fs::path(child.text).is_relative())
      child.text = (folder / child.text).lexically_normal().string();
    move_to(child, folder);
  }
  for (ConfigNode& child : node.list) move_to(child, folder);
}

// without = ["mr", "gas"]: keys of the base's table that the merged one does not have.
void leave_out(ConfigNode& base, const ConfigNode& without, const std::string& file) {
  std::vector<std::string> known;
  for (const auto& entry : base.table) known.push_back(entry.first);
  std::unordered_set<std::string> left(known.begin(), known.end());
  const auto wrong = [&](const std::string& what) {
    throw InputError(kBadWithout, place_of(file, without.line, "without") + what);
  };
  if (without.kind != ConfigNode::Kind::kList)
    wrong("is " + without.description() + ", expected a list of keys of the base");
  for (const ConfigNode& key : without.list) {
    if (left.erase(key.text) == 0)
      wrong("the base has no key \"" + key.text + "\" here." + known_names("keys", key.text, known));
  }
  base.table.erase(std::remove_if(base.table.begin(), base.table.end(),
                                  [&](const auto& entry) { return left.count(entry.first) == 0; }),
                   base.table.end());
}

void lay_over(ConfigNode& base, const ConfigNode& own, const ArrayCounts& arrays, const std::string& file) {
  const bool tables = base.kind == ConfigNode::Kind::kTable && own.kind == ConfigNode::Kind::kTable;
  const auto named = [](const ConfigNode& list) {
    return list.kind == ConfigNode::Kind::kList && !list.list.empty() &&
           std::all_of(list.list.begin(), list.list.end(),
                       [](const ConfigNode& item) { return !item.entry_name().empty(); });
  };
  if (tables) {
    base.line = own.line;
    if (const ConfigNode* without = own.find("without")) leave_out(base, *without, file);
    std::unordered_map<std::string, std::size_t> places;
    for (const auto& entry : base.table) places.emplace(entry.first, places.size());
    for (const auto& [key, value] : own.table) {
      if (key == "without") continue;
      const auto [there, is_new] = places.emplace(key, base.table.size());
      if (is_new) {
        base.table.emplace_back(key, value);
      } else {
        lay_over(base.table[there->second].second, value, arrays, file);
      }
    }
  } else if (named(base) && named(own)) {
    base.line = own.line;
    std::unordered_map<std::string, std::size_t> places;  // of the first entry of each name
    const auto find_places = [&] {
      places.clear();
      for (std::size_t i = 0; i < base.list.size(); ++i) places.emplace(base.list[i].entry_name(), i);
    };
    find_places();
    for (const ConfigNode& item : own.list) {
      const std::string name = item.entry_name();
      if (const auto same = places.find(name); same != places.end()) {
        lay_over(base.list[same->second], item, arrays, file);
      } else if (const int copy = own_copy(base, name, arrays); copy >= 0) {
        ConfigNode& entry = base.list[copy];
        const std::string pattern = entry.entry_name();
        lay_over(entry, item, arrays, file);
        entry.find(entry.find("name") ? "name" : "body")->text = pattern;
        find_places();
      } else {
        places.emplace(name, base.list.size());
        base.list.push_back(item);
      }
    }
  } else {
    base = own;
  }
}

// The file of a sweep, a study or a rig has no bodies of its own: it names a scene and says what to vary.
void require_scene(const ConfigNode& own, const std::string& file) {
  const ConfigNode* scene = own.find("scene");
  if (!scene || scene->kind != ConfigNode::Kind::kText || own.find("bodies") || own.find("base")) return;
  throw InputError(kNotAScene, place_of(file, scene->line, "scene"), "this file is an experiment with the scene \"",
                   scene->text,
                   "\", expected a scene; run it with the command that its first lines name, such as footfall sweep ",
                   file, ", or give that scene");
}

// "frames_ms" with the second spelling "frames" of "frame_interval": "frame_interval_ms".
void rename_key(ConfigNode& table, const std::string& second, const std::string& key) {
  const auto is = [](const std::string& written, const std::string& one) {
    return written == one || written.rfind(one + "_", 0) == 0;
  };
  const auto first =
      std::find_if(table.table.begin(), table.table.end(), [&](const auto& entry) { return is(entry.first, key); });
  auto same = static_cast<std::size_t>(first - table.table.begin());  // the size: none
  for (std::size_t i = 0; i < table.table.size(); ++i) {
    auto& [written, node] = table.table[i];
    if (!is(written, second)) continue;
    const std::string renamed = key + written.substr(second.size());
    if (same < table.table.size()) {
      if (node.line != Source::kFromSet) continue;
      auto& [name, value] = table.table[same];
      value = node;
      name = renamed;
      value.spelt = written;
      if (i < same) --same;
      table.table.erase(table.table.begin() + i--);
      continue;
    }
    same = i;
    node.spelt = written;
    written = renamed;
  }
}

}  // namespace

void rename_second_spellings(ConfigNode& root) {
  for (const char* list : {"joints", "springs", "drives", "signals", "controllers"})
    if (ConfigNode* const entries = root.find(list))
      for (ConfigNode& entry : entries->list) rename_key(entry, "type", "kind");
  if (ConfigNode* const bodies = root.find("bodies"))
    for (ConfigNode& body : bodies->list)
      if (ConfigNode* const shape = body.find("shape")) rename_key(*shape, "type", "kind");
  if (ConfigNode* const ground = root.find("ground")) rename_key(*ground, "type", "kind");
  ConfigNode* const particles = root.find("particles");
  ConfigNode* const box = particles ? particles->find("box") : nullptr;
  if (box == nullptr) return;
  rename_key(*box, "every", "exchange_steps");
  rename_key(*box, "frames", "frame_interval");
}

namespace {

ConfigNode parse(const std::string& argument, int depth);

ConfigNode with_base(ConfigNode own, const std::string& file, int depth) {
  rename_second_spellings(own);
  require_scene(own, file);
  const ConfigNode* base_key = own.find("base");
  if (!base_key) return own;
  const std::string where = place_of(file, base_key->line, "base");
  if (base_key->kind != ConfigNode::Kind::kText)
    throw InputError(kBadBase, where, "is ", base_key->description(),
                     ", expected the path of another scene, in quotes");
  if (depth == kLongestChain)
    throw InputError(kBadBase, where, "leads through more than ", kLongestChain,
                     " scenes; check that none is its own base");
  const fs::path target = fs::path(file).parent_path() / base_key->text;
  ConfigNode base;
  try {
    base = parse(target.string(), depth + 1);
  } catch (const InputError& error) {
    throw InputError(where + error.what());
  }
  const fs::path folder = fs::path(file).parent_path(),
                 base_folder = fs::path(scene_file(target.string())).parent_path();
  move_to(base, fs::relative(base_folder, folder.empty() ? fs::path(".") : folder));
  own.table.erase(
      std::find_if(own.table.begin(), own.table.end(), [](const auto& entry) { return entry.first == "base"; }));
  ArrayCounts arrays = arrays_of(own);
  for (const auto& array : arrays_of(base)) arrays.push_back(array);
  lay_over(base, own, arrays, file);
  return base;
}

ConfigNode parse(const std::string& argument, int depth) {
  const std::string file = scene_file(argument);
  return with_base(parse_toml_file(file), file, depth);
}

}  // namespace

ConfigNode parse_scene_with_base(const std::string& argument) { return parse(argument, 0); }

ConfigNode parse_scene_with_base(const std::string& text, const std::string& file) {
  return with_base(parse_toml(text, file), file, 0);
}

}  // namespace footfall
