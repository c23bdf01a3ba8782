#pragma once
// What the readers of values (value_reader.h) share: texts of findings, ranges, lists of numbers.

#include <string>
#include <vector>

#include "mbd_solver/scene/value_reader.h"

namespace footfall {

// "is the number 5, expected a table".
std::string is_expected(const ConfigNode& node, const std::string& expected);
// "a number [m]".
std::string with_unit(const std::string& what, const Rule& rule);
// `value` in SI; what is out of range is described in SI as well. Empty: nothing is wrong.
std::string check_range(double value, const Rule& rule);
// Numbers of a list of known length (or any length: count 0), range-checked; as read_value.
std::string read_numbers(const ConfigNode& node, const ValueContext& c, std::size_t count, std::vector<double>& values);

}  // namespace footfall
