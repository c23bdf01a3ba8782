// Finds the type of each joint in the text of the scene, copies of arrays included, to choose its coordinate.
#include "mbd_solver/scene/initial_joints.h"

#include <algorithm>
#include <optional>

#include "coupler/base/text.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/joint_spec.h"
#include "mbd_solver/scene/value_checks.h"

namespace footfall {
namespace {

// Whether "leg_{leg}_knee", the name of an array's entries, may become this name.
bool may_become(const std::string& pattern, const std::string& name) {
  const std::size_t open = pattern.find('{'), close = pattern.find('}', open);
  if (open == std::string::npos || close == std::string::npos) return pattern == name;
  const std::string rest = pattern.substr(close + 1);
  if (name.compare(0, open, pattern, 0, open) != 0) return false;
  for (std::size_t at = open; at <= name.size(); ++at)
    if (may_become(rest, name.substr(at))) return true;
  return false;
}

// The type of the joint of this name, if it can be read; errors of the joint are reported by the reader.
std::optional<JointType> type_of_joint(const ConfigNode& root, const std::string& name) {
  const ConfigNode* joints = root.find("joints");
  if (!joints) return std::nullopt;
  const ConfigNode* found = nullptr;
  for (const ConfigNode& joint : joints->list) {
    if (joint.entry_name() == name) found = &joint;
    if (!found && may_become(joint.entry_name(), name)) found = &joint;
  }
  const ConfigNode* type = found ? found->find("type") : nullptr;
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

}  // namespace

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
      findings.error(code::kInitialJoint, node.line, path,
                     "is given, but a " + std::string(name_of(*type)) + " joint has no coordinate; remove it");
    } else {
      std::vector<std::string> names;
      for (const Coordinate coordinate : has) names.emplace_back(name_of(coordinate));
      findings.error(code::kAmbiguousCoordinate, node.line, path,
                     "is " + node.description() + ", but a " + std::string(name_of(*type)) + " joint has " +
                         joined(names, " and ") + "; write [initial.joints." + name + "] " + names.front() + " = " +
                         number_text(node.number));
    }
  }
  joints->table = std::move(kept);
}

}  // namespace footfall
