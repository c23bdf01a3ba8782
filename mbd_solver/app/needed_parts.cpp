// Sorts the words of the line, reads every file that they name as a tree of keys, and looks for the keys that decide. Files
// of studies are read as trees as well: app does not know the readers of studies.
#include "mbd_solver/app/needed_parts.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "mbd_solver/app/new_case.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/toml_file.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

using Kind = ConfigNode::Kind;
using Texts = std::vector<std::string>;

// A command line, sorted: `--set a=1` and `--set=a=1` are the same.
struct SortedLine {
  std::string command;
  Texts named;     // words that are no options, and the values of all options but --set
  Texts settings;  // of --set
  std::string from, resumed;
};

SortedLine sorted(const Texts& words) {
  SortedLine line;
  if (!words.empty()) line.command = words.front();
  std::string option;
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::string value = words[i];
    if (value.rfind("--", 0) == 0) {
      const std::size_t equals = value.find('=');
      option = value.substr(0, equals);
      if (equals == std::string::npos) continue;
      value.erase(0, equals + 1);
    }
    if (option == "--set") {
      line.settings.push_back(value);
    } else {
      line.named.push_back(value);
      if (option == "--from") line.from = value;
      if (option == "--resume") line.resumed = value;
    }
    option.clear();
  }
  return line;
}

// What `look` finds in files; false where one of them cannot be read.
template <class Look>
bool finds(const Look& look) {
  try {
    return look();
  } catch (const std::exception&) {
    return false;
  }
}

bool has_fmu(ConfigNode scene, const Texts& settings) {
  Findings ignored("");
  for (const std::string& setting : settings) apply_setting(scene, setting, ignored);
  rename_second_spellings(scene);
  const ConfigNode* const signals = scene.find("signals");
  if (signals == nullptr) return false;
  return std::any_of(signals->list.begin(), signals->list.end(), [](const ConfigNode& signal) {
    const ConfigNode* const kind = signal.find("kind");
    return kind != nullptr && kind->kind == Kind::kText && kind->text == "fmu";
  });
}

// All texts below `node` that stand under this key, alone or in a list.
void collect(const ConfigNode& node, const std::string& key, Texts& texts) {
  for (const auto& [name, child] : node.table) {
    if (name == key && child.kind == Kind::kText) texts.push_back(child.text);
    for (const ConfigNode& item : child.list)
      if (name == key && item.kind == Kind::kText) texts.push_back(item.text);
    collect(child, key, texts);
  }
  for (const ConfigNode& item : node.list) collect(item, key, texts);
}

// A sweep, a calibration, a rig: scenes relative to the file, each with one of the settings of signals or none.
bool study_has_fmu(const std::string& file, const Texts& settings) {
  const ConfigNode study = parse_toml_file(file);
  Texts scenes, all = settings;
  collect(study, "scene", scenes);
  collect(study, "settings", all);
  all.erase(std::remove_if(all.begin(), all.end(), [](const std::string& one) { return one.rfind("signals", 0) != 0; }),
            all.end());
  return std::any_of(scenes.begin(), scenes.end(), [&](const std::string& name) {
    return finds([&] {
      const ConfigNode scene = parse_scene_with_base((fs::path(file).parent_path() / name).string());
      return has_fmu(scene, {}) ||
             std::any_of(all.begin(), all.end(), [&](const std::string& one) { return has_fmu(scene, {one}); });
    });
  });
}

bool draws_runs(const std::string& file) {
  const ConfigNode study = parse_toml_file(file);
  const ConfigNode* const runs = study.find("runs");
  return runs != nullptr && runs->is_number() && runs->number > 0.0;
}

// The scene of the run in this folder.
bool resumed_has_fmu(const std::string& folder) {
  const nlohmann::ordered_json run = read_summary((fs::path(folder) / "summary.json").string());
  return has_fmu(parse_scene_with_base(run.at("scene_file").get<std::string>()), run.at("settings").get<Texts>());
}

}  // namespace

Texts needed_parts(const Texts& words) {
  const SortedLine line = sorted(words);
  const auto any_named = [&](const auto& look) {
    return std::any_of(line.named.begin(), line.named.end(),
                       [&](const std::string& name) { return finds([&] { return look(scene_file(name)); }); });
  };
  Texts parts;
  if ((line.command == "sweep" || line.command == "check") && any_named(draws_runs)) parts.push_back("campaign");
  if (any_named([&](const std::string& file) { return has_fmu(parse_scene_with_base(file), line.settings); }) ||
      any_named([&](const std::string& file) { return study_has_fmu(file, line.settings); }) ||
      (!line.resumed.empty() && finds([&] { return resumed_has_fmu(line.resumed); })))
    parts.push_back("fmi");
  if (line.command == "new" && is_robot_file(line.from)) parts.push_back("import");
  return parts;
}

}  // namespace footfall
