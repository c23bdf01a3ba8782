#pragma once
// What the readers of values (value_reader.h) share: texts of findings, ranges, lists.

#include <string>
#include <vector>

#include "mbd_solver/scene/value_reader.h"

namespace footfall {

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

}  // namespace footfall
