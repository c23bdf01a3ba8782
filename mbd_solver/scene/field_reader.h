#pragma once
// Units of scene numbers: SI without a suffix, others by the suffix of the key (angle_deg, diameter_mm), converted by the
// reader.

#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/scene/toml_file.h"

namespace footfall {

struct UnitSuffix {
  std::string suffix;  // "_mm"
  double factor;       // SI value = factor * written value
};

// Name of the SI unit: "m", "Pa"; empty for numbers without a unit.
const char* unit_name(Unit unit);
// The suffixes allowed for this unit; does not contain the empty one.
const std::vector<UnitSuffix>& unit_suffixes(Unit unit);

// One value of a scene file into one member of a struct, with its unit and range. Each read_value returns an empty text,
// or what is wrong and what was expected, with its code; the member then keeps its default.
struct ValueContext {
  const Rule& rule;
  double factor;              // written value * factor = SI value
  const std::string& folder;  // of the scene: tables in files are relative to it
};

std::string read_value(const ConfigNode& node, const ValueContext& c, double& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, int& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, bool& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, std::string& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<std::string>& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, std::array<std::string, 2>& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, Eigen::Vector3d& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<Eigen::Vector3d>& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, std::array<Eigen::Vector3d, 2>& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<double>& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<int>& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<Eigen::Vector2d>& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, Eigen::Quaterniond& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, Eigen::Matrix3d& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, std::map<std::string, std::string>& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, Choice& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, NumberOrWord& target);
std::string read_value(const ConfigNode& node, const ValueContext& c, PerAxis& target);
inline std::string read_value(const ConfigNode&, const ValueContext&, Source&) { return ""; }  // handled by the reader

template <class T>
std::string read_value(const ConfigNode& node, const ValueContext& c, std::optional<T>& target) {
  T value{};
  const std::string problem = read_value(node, c, value);
  if (problem.empty()) target = value;
  return problem;
}

// What the readers of values (value_reader.h) share: texts of findings, ranges, lists.
// "is the number 5, expected a table [E0104 wrong-type]".
std::string is_expected(const ConfigNode& node, const std::string& expected);
// "a number [m]".
std::string with_unit(const std::string& what, const Rule& rule);
// `value` in SI units, which the message uses as well. Empty: the value is in its range.
std::string check_range(double value, const Rule& rule);
// The numbers of a list of known length (count 0: any length), range-checked; `expected` replaces "a list of 3 numbers".
std::string read_numbers(const ConfigNode& node, const ValueContext& c, std::size_t count, std::vector<double>& values,
                         std::string expected = "");

// Each item of a list by the reader of one item. `target` changes only if all are good.
template <class T>
std::string read_list(const ConfigNode& node, const ValueContext& c, const std::string& expected,
                      std::vector<T>& target) {
  if (node.kind != ConfigNode::Kind::kList) return is_expected(node, expected);
  std::vector<T> result;
  for (const ConfigNode& item : node.list) {
    T value{};
    const std::string problem = read_value(item, c, value);
    result.push_back(value);
    if (!problem.empty()) return "entry " + std::to_string(result.size()) + " " + problem;
  }
  target = std::move(result);
  return "";
}

// A list of two.
template <class T>
std::string read_pair(const ConfigNode& node, const ValueContext& c, const std::string& expected,
                      std::array<T, 2>& target) {
  std::vector<T> list;
  const std::string problem = read_value(node, c, list);
  if (!problem.empty()) return problem;
  if (list.size() != 2) return is_expected(node, expected);
  target = {list[0], list[1]};
  return "";
}

// Tree of values -> Scene, by the description of the keys (field_visitor.h). Wrong types, units and ranges, missing and
// unknown keys become findings; the scene then keeps its default.
class FieldVisitor;

void read_fields(const ConfigNode& root, Scene& scene, Findings& findings);
// Any file whose keys are described; the files that it names are relative to `folder`.
void read_fields(const ConfigNode& root, const std::string& folder, const std::function<void(FieldVisitor&)>& describe,
                 Findings& findings);

// Two columns of a text file (mbd_solver/base/csv.h; commas, semicolons or blanks); the first line may name them.
std::vector<Eigen::Vector2d> read_two_columns(const std::string& file);

}  // namespace footfall
