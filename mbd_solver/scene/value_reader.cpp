#include "mbd_solver/scene/value_reader.h"

#include <charconv>
#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {

namespace {

std::string is_expected(const ConfigNode& node, const std::string& expected) {
  return "is " + node.description() + ", expected " + expected;
}

std::string with_unit(const std::string& what, const Rule& rule) {
  const std::string unit = unit_name(rule.unit);
  return unit.empty() ? what : what + " [" + unit + "]";
}

// Beyond these a product of two numbers may be lost.
constexpr double kSmallest = 1e-100, kLargest = 1e100;

// In SI; what is out of range is described in SI as well.
std::string check_range(double value, const Rule& rule) {
  const std::string unit = unit_name(rule.unit);
  const std::string is = "is " + number_text(value) + (unit.empty() ? "" : " " + unit);
  if (!std::isfinite(value)) return is + ", expected a finite number";
  if (value != 0.0 && !(std::abs(value) >= kSmallest && std::abs(value) <= kLargest))
    return is + ", expected 0 or a size from " + number_text(kSmallest) + " to " + number_text(kLargest);
  switch (rule.range) {
    case Range::kAny: break;
    case Range::kPositive: return value > 0.0 ? "" : is + ", expected more than 0";
    case Range::kNotNegative: return value >= 0.0 ? "" : is + ", expected 0 or more";
    case Range::kUnitInterval: return value >= 0.0 && value <= 1.0 ? "" : is + ", expected a number from 0 to 1";
  }
  return "";
}

// Numbers of a list of known length (or any length: count 0), range-checked.
std::string read_numbers(const ConfigNode& node, const ValueContext& c, std::size_t count,
                         std::vector<double>& values) {
  const std::string expected =
      with_unit(count ? "a list of " + std::to_string(count) + " numbers" : std::string("a list of numbers"), c.rule);
  if (node.kind != ConfigNode::Kind::kList || (count && node.list.size() != count)) return is_expected(node, expected);
  std::vector<double> result;
  for (const ConfigNode& item : node.list) {
    if (!item.is_number()) return "holds " + item.description() + ", expected " + expected;
    result.push_back(item.number * c.factor);
    const std::string problem = check_range(result.back(), c.rule);
    if (!problem.empty()) return "number " + std::to_string(result.size()) + " " + problem;
  }
  values = result;
  return "";
}

std::string named_axis(const ConfigNode& node, Eigen::Vector3d& axis) {
  const bool minus = !node.text.empty() && node.text[0] == '-';
  const std::string letter = node.text.substr(minus ? 1 : 0);
  if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z')
    return is_expected(node, "three numbers, or \"x\", \"y\", \"z\", \"-x\" ...");
  axis = (minus ? -1.0 : 1.0) * Eigen::Vector3d::Unit(letter[0] - 'x');
  return "";
}

// Names of arrays stand in braces until their entries are copied: "leg_{leg}".
std::string without_braces(std::string text) {
  for (char& c : text)
    if (c == '{' || c == '}') c = '_';
  return text;
}

}  // namespace

std::string read_value(const ConfigNode& node, const ValueContext& c, double& target) {
  if (!node.is_number()) return is_expected(node, with_unit("a number", c.rule));
  const double value = node.number * c.factor;
  const std::string problem = check_range(value, c.rule);
  if (problem.empty()) target = value;
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::optional<double>& target) {
  double value = 0.0;
  const std::string problem = read_value(node, c, value);
  if (problem.empty()) target = value;
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext& c, int& target) {
  if (node.kind != ConfigNode::Kind::kInteger || std::abs(node.number) > 1e9)
    return is_expected(node, "a whole number");
  const std::string problem = check_range(node.number, c.rule);
  if (problem.empty()) target = static_cast<int>(node.number);
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::optional<int>& target) {
  int value = 0;
  const std::string problem = read_value(node, c, value);
  if (problem.empty()) target = value;
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext&, bool& target) {
  if (node.kind != ConfigNode::Kind::kFlag) return is_expected(node, "true or false");
  target = node.flag;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::string& target) {
  if (node.kind != ConfigNode::Kind::kText) return is_expected(node, "text in quotes");
  if (node.text.empty() && c.rule.required) return "is empty, expected a name";
  if (c.rule.meaning == Meaning::kName && !node.text.empty() && !is_plain_name(without_braces(node.text)))
    return is_expected(node, "a name of letters, digits, _ - and ., without a dot in front, at most " +
                                 std::to_string(kLongestName) + " of them (it becomes a column and a file)");
  target = node.text;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<std::string>& target) {
  if (node.kind != ConfigNode::Kind::kList) return is_expected(node, "a list of texts");
  std::vector<std::string> result;
  for (const ConfigNode& item : node.list) {
    const std::string problem = read_value(item, c, result.emplace_back());
    if (!problem.empty()) return "entry " + std::to_string(result.size()) + " " + problem;
  }
  target = result;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::array<std::string, 2>& target) {
  std::vector<std::string> names;
  const std::string problem = read_value(node, c, names);
  if (!problem.empty()) return problem;
  if (names.size() != 2) return is_expected(node, "two names of bodies");
  target = {names[0], names[1]};
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, Eigen::Vector3d& target) {
  const bool direction = c.rule.meaning == Meaning::kDirection;
  if (direction && node.kind == ConfigNode::Kind::kText) return named_axis(node, target);
  std::vector<double> v;
  const std::string problem = read_numbers(node, c, 3, v);
  if (!problem.empty()) return problem;
  const Eigen::Vector3d vector(v[0], v[1], v[2]);
  if (direction && !(vector.norm() > 0.0)) return "is zero and has no direction; expected a vector such as [0, 0, 1]";
  target = direction ? vector.normalized() : vector;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::optional<Eigen::Vector3d>& target) {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  const std::string problem = read_value(node, c, value);
  if (problem.empty()) target = value;
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<Eigen::Vector3d>& target) {
  if (node.kind != ConfigNode::Kind::kList) return is_expected(node, with_unit("a list of points [x, y, z]", c.rule));
  std::vector<Eigen::Vector3d> result;
  for (const ConfigNode& item : node.list) {
    const std::string problem = read_value(item, c, result.emplace_back(Eigen::Vector3d::Zero()));
    if (!problem.empty()) return "point " + std::to_string(result.size()) + " " + problem;
  }
  target = result;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::array<Eigen::Vector3d, 2>& target) {
  std::vector<Eigen::Vector3d> points;
  const std::string problem = read_value(node, c, points);
  if (!problem.empty()) return problem;
  if (points.size() != 2) return is_expected(node, "two points [[x, y, z], [x, y, z]]");
  target = {points[0], points[1]};
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<double>& target) {
  if (!node.is_number()) return read_numbers(node, c, 0, target);
  double value = 0.0;  // one number is a list of one
  const std::string problem = read_value(node, c, value);
  if (problem.empty()) target = {value};
  return problem;
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<int>& target) {
  if (node.kind != ConfigNode::Kind::kList) return is_expected(node, "a list of whole numbers");
  std::vector<int> result;
  for (const ConfigNode& item : node.list) {
    const std::string problem = read_value(item, c, result.emplace_back());
    if (!problem.empty()) return "entry " + std::to_string(result.size()) + " " + problem;
  }
  target = result;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<Eigen::Vector2d>& target) {
  std::vector<Eigen::Vector2d> result;
  if (node.kind == ConfigNode::Kind::kText) {
    try {
      result = read_two_columns((std::filesystem::path(c.folder) / node.text).string());
    } catch (const InputError& e) {
      return e.what();
    }
    for (Eigen::Vector2d& row : result) row[1] *= c.factor;
  } else {
    const std::string expected = "pairs [[x, y], [x, y], ...], or the name of a CSV file with two columns";
    if (node.kind != ConfigNode::Kind::kList) return is_expected(node, expected);
    for (const ConfigNode& item : node.list) {
      if (item.kind != ConfigNode::Kind::kList || item.list.size() != 2 || !item.list[0].is_number() ||
          !item.list[1].is_number())
        return "holds " + item.description() + ", expected " + expected;
      result.emplace_back(item.list[0].number, item.list[1].number * c.factor);
    }
  }
  if (result.size() < 2) return "has " + std::to_string(result.size()) + " rows, expected at least two";
  for (std::size_t i = 1; i < result.size(); ++i) {
    if (!(result[i][0] > result[i - 1][0]))
      return "does not rise: row " + std::to_string(i + 1) + " starts with " + number_text(result[i][0]) + " after " +
             number_text(result[i - 1][0]);
  }
  target = result;
  return "";
}

// { axis = [x, y, z], angle_deg = phi }, as `rotate` of a mesh in a LIGGGHTS script.
static std::string read_turn(const ConfigNode& node, Eigen::Quaterniond& target) {
  const ConfigNode* axis_node = node.find("axis");
  const ConfigNode* degrees = node.find("angle_deg");
  const ConfigNode* angle_node = degrees ? degrees : node.find("angle");
  if (!axis_node || !angle_node) return is_expected(node, "{ axis = [x, y, z], angle_deg = phi }");
  Rule direction;
  direction.meaning = Meaning::kDirection;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double angle = 0.0;
  if (const std::string problem = read_value(*axis_node, {direction, 1.0, ""}, axis); !problem.empty())
    return "axis " + problem;
  const double factor = degrees ? unit_suffixes(Unit::kAngle).front().factor : 1.0;
  if (const std::string problem = read_value(*angle_node, {Rule(), factor, ""}, angle); !problem.empty())
    return "angle " + problem;
  target = Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext&, Eigen::Quaterniond& target) {
  const std::string expected =
      "{ rpy_deg = [roll, pitch, yaw] }, { rpy = [...] } in rad, { quaternion = [w, x, y, z] }, or { axis = [x, y, z], "
      "angle_deg = phi }";
  if (node.kind == ConfigNode::Kind::kTable && node.table.size() == 2) return read_turn(node, target);
  if (node.kind != ConfigNode::Kind::kTable || node.table.size() != 1) return is_expected(node, expected);
  const auto& [key, value] = node.table.front();
  std::vector<double> v;
  const Rule rule;
  if (key == "quaternion") {
    const std::string problem = read_numbers(value, {rule, 1.0, ""}, 4, v);
    if (!problem.empty()) return "quaternion " + problem;
    const Eigen::Quaterniond q(v[0], v[1], v[2], v[3]);
    if (std::abs(q.norm() - 1.0) > 1e-3) return "quaternion has length " + number_text(q.norm()) + ", expected 1";
    target = q.normalized();
    return "";
  }
  if (key != "rpy" && key != "rpy_deg") return "holds the unknown key \"" + key + "\", expected " + expected;
  const double factor = key == "rpy" ? 1.0 : unit_suffixes(Unit::kAngle).front().factor;
  const std::string problem = read_numbers(value, {rule, factor, ""}, 3, v);
  if (!problem.empty()) return key + " " + problem;
  target = rotation_from_rpy(v[0], v[1], v[2]);
  return "";
}

// Symmetric: [xx, yy, zz] or [xx, yy, zz, xy, yz, zx].
std::string read_value(const ConfigNode& node, const ValueContext& c, Eigen::Matrix3d& target) {
  Rule rule = c.rule;
  rule.range = Range::kAny;
  std::vector<double> v;
  const bool full = node.kind == ConfigNode::Kind::kList && node.list.size() == 6;
  const std::string problem = read_numbers(node, {rule, c.factor, c.folder}, full ? 6 : 3, v);
  if (!problem.empty()) return problem + " (Ixx, Iyy, Izz), or six (Ixx, Iyy, Izz, Ixy, Iyz, Izx)";
  v.resize(6, 0.0);
  target << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext&, std::map<std::string, std::string>& target) {
  if (node.kind != ConfigNode::Kind::kTable) return is_expected(node, "a table { name = value, ... }");
  std::map<std::string, std::string> result;
  for (const auto& [key, value] : node.table) {
    if (value.kind == ConfigNode::Kind::kText) {
      result[key] = value.text;
    } else if (value.is_number()) {
      char buffer[40];
      // shortest text that reads back the same
      const auto end = std::to_chars(buffer, buffer + sizeof buffer, value.number).ptr;
      result[key] = std::string(buffer, end);
    } else {
      return "variable \"" + key + "\" is " + value.description() + ", expected a number or text";
    }
  }
  target = result;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext&, Choice& target) {
  for (std::size_t i = 0; i < target.names.size(); ++i) {
    if (node.kind == ConfigNode::Kind::kText && node.text == target.names[i]) {
      target.value = static_cast<int>(i);
      return "";
    }
  }
  return "is " + node.description() + ", which is none of the choices." +
         known_names("choices", node.text, target.names);
}

std::string read_value(const ConfigNode& node, const ValueContext& c, NumberOrWord& target) {
  if (node.kind == ConfigNode::Kind::kText) {
    if (node.text != target.word)
      return is_expected(node, with_unit("a number", c.rule) + " or \"" + target.word + "\"");
    *target.is_word = true;
    return "";
  }
  return read_value(node, c, *target.number);
}

std::string read_value(const ConfigNode& node, const ValueContext& c, PerAxis& target) {
  if (node.kind == ConfigNode::Kind::kList) return read_value(node, c, *target.values);
  double alike = 0.0;
  const std::string problem = read_value(node, c, alike);
  if (problem.empty()) target.values->setConstant(alike);
  return problem;
}

}  // namespace footfall
