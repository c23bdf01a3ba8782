// Vectors, directions, rotations and inertia tensors of a scene file.
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/units.h"
#include "mbd_solver/scene/value_checks.h"
#include "mbd_solver/scene/value_reader.h"

namespace footfall {

using namespace code;

namespace {

std::string named_axis(const ConfigNode& node, Eigen::Vector3d& axis) {
  const bool minus = !node.text.empty() && node.text[0] == '-';
  const std::string letter = node.text.substr(minus ? 1 : 0);
  if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z')
    return is_expected(node, "three numbers, or \"x\", \"y\", \"z\", \"-x\" ...");
  axis = (minus ? -1.0 : 1.0) * Eigen::Vector3d::Unit(letter[0] - 'x');
  return "";
}

}  // namespace

std::string read_value(const ConfigNode& node, const ValueContext& c, Eigen::Vector3d& target) {
  const bool direction = c.rule.meaning == Meaning::kDirection;
  if (direction && node.kind == ConfigNode::Kind::kText) return named_axis(node, target);
  std::vector<double> v;
  const std::string problem = read_numbers(node, c, 3, v);
  if (!problem.empty()) return problem;
  const Eigen::Vector3d vector(v[0], v[1], v[2]);
  if (direction && !(vector.norm() > 0.0))
    return with_code(kOutOfRange, "is zero and has no direction, expected a vector such as [0, 0, 1]");
  target = direction ? vector.normalized() : vector;
  return "";
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<Eigen::Vector3d>& target) {
  return read_list(node, c, with_unit("a list of points [x, y, z]", c.rule), target);
}

std::string read_value(const ConfigNode& node, const ValueContext& c, std::array<Eigen::Vector3d, 2>& target) {
  return read_pair(node, c, "two points [[x, y, z], [x, y, z]]", target);
}

std::string read_value(const ConfigNode& node, const ValueContext& c, PerAxis& target) {
  if (node.kind == ConfigNode::Kind::kList) return read_value(node, c, *target.values);
  double all = 0.0;
  const std::string problem = read_value(node, c, all);
  if (problem.empty()) target.values->setConstant(all);
  return problem;
}

namespace {

double radians_per_degree() { return unit_suffixes(Unit::kAngle).front().factor; }

// { axis = [x, y, z], angle_deg = phi }, as `rotate` of a mesh in a LIGGGHTS script.
std::string read_axis_and_angle(const ConfigNode& node, Eigen::Quaterniond& target) {
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
  const double factor = degrees ? radians_per_degree() : 1.0;
  if (const std::string problem = read_value(*angle_node, {Rule(), factor, ""}, angle); !problem.empty())
    return "angle " + problem;
  target = Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
  return "";
}

}  // namespace

std::string read_value(const ConfigNode& node, const ValueContext&, Eigen::Quaterniond& target) {
  const std::string expected =
      "{ rpy_deg = [roll, pitch, yaw] }, { rpy = [...] } in rad, { quaternion = [w, x, y, z] }, or { axis = [x, y, z], "
      "angle_deg = phi }";
  const bool table = node.kind == ConfigNode::Kind::kTable;
  if (table && node.table.size() == 2) return read_axis_and_angle(node, target);
  if (!table || node.table.size() != 1) return is_expected(node, expected);
  const auto& [key, value] = node.table.front();
  const bool quaternion = key == "quaternion";
  if (!quaternion && key != "rpy" && key != "rpy_deg")
    return with_code(kUnknownKey, "contains the unknown key \"" + key + "\", expected " + expected);
  std::vector<double> v;
  const double factor = key == "rpy_deg" ? radians_per_degree() : 1.0;
  const std::string problem = read_numbers(value, {Rule(), factor, ""}, quaternion ? 4 : 3, v);
  if (!problem.empty()) return key + " " + problem;
  if (!quaternion) {
    target = rotation_from_rpy(v[0], v[1], v[2]);
    return "";
  }
  const Eigen::Quaterniond q(v[0], v[1], v[2], v[3]);
  if (std::abs(q.norm() - 1.0) > 1e-3)
    return with_code(kOutOfRange, "quaternion has the length " + number_text(q.norm()) + ", expected 1");
  target = q.normalized();
  return "";
}

// Symmetric: [xx, yy, zz] or [xx, yy, zz, xy, yz, zx].
std::string read_value(const ConfigNode& node, const ValueContext& c, Eigen::Matrix3d& target) {
  Rule rule = c.rule;
  rule.range = Range::kAny;
  std::vector<double> v;
  const bool full = node.kind == ConfigNode::Kind::kList && node.list.size() == 6;
  const std::string expected = with_unit("a list of 3 numbers", rule) + " (Ixx, Iyy, Izz), or 6 (..., Ixy, Iyz, Izx)";
  const std::string problem = read_numbers(node, {rule, c.factor, c.folder}, full ? 6 : 3, v, expected);
  if (!problem.empty()) return problem;
  v.resize(6, 0.0);
  target << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
  return "";
}

}  // namespace footfall
