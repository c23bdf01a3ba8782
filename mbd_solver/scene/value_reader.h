#pragma once
// One value of a scene file into one member of a struct, with its unit and range. Each read_value returns an empty text,
// or what is wrong and what was expected, with its code; the member then keeps its default.

#include <string>

#include "mbd_solver/scene/config_node.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/units.h"

namespace footfall {

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

}  // namespace footfall
