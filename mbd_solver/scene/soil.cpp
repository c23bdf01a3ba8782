// Merges the table of a shipped soil under the keys of the scene.
#include "mbd_solver/scene/soil.h"

#include <algorithm>
#include <filesystem>

#include "coupler/base/text.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {

namespace {

// Adds keys that are not there yet; their line is that of the key `soil`.
void fill(ConfigNode& own, const ConfigNode& soil, int line) {
  for (const auto& [key, value] : soil.table) {
    ConfigNode* there = own.find(key);
    if (there && there->kind == ConfigNode::Kind::kTable && value.kind == ConfigNode::Kind::kTable) {
      fill(*there, value, line);
    } else if (!there) {
      ConfigNode fresh = value;
      fresh.table.clear();
      fresh.line = line;
      fill(fresh, value, line);
      own.table.emplace_back(key, fresh);
    }
  }
}

}  // namespace

std::vector<std::string> known_soils() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(shipped_file("inputs/soils")))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

void add_soil(ConfigNode& scene, Findings& findings) {
  ConfigNode* particles = scene.find("particles");
  const ConfigNode* soil = particles ? particles->find("soil") : nullptr;
  if (!soil || soil->kind != ConfigNode::Kind::kText) return;  // another type is reported by the reader
  const int line = soil->line;
  const std::string name = soil->text;
  const std::vector<std::string> names = known_soils();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    findings.error(
        code::kUnknownSoil, line, "particles.soil",
        "unknown soil \"" + name + "\"." + known_names("soils", name, names) + " They are files of inputs/soils");
    return;
  }
  ConfigNode* box = particles->find("box");
  if (!box || box->kind != ConfigNode::Kind::kTable) {
    findings.error(code::kNeedsOtherKey, line, "particles.soil",
                   "needs a bed by numbers: [particles.box] with size, depth and radius");
    return;
  }
  const ConfigNode file = parse_toml_file(shipped_file("inputs/soils/" + name + ".toml"));
  if (const ConfigNode* numbers = file.find("box")) fill(*box, *numbers, line);
}

}  // namespace footfall
