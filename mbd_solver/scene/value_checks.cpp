// Texts of findings about values, and the ranges of numbers.
#include "mbd_solver/scene/value_checks.h"

#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/scene/codes.h"

namespace footfall {

using namespace code;

std::string is_expected(const ConfigNode& node, const std::string& expected) {
  return with_code(kWrongType, "is " + node.description() + ", expected " + expected);
}

std::string with_unit(const std::string& what, const Rule& rule) {
  const std::string unit = unit_name(rule.unit);
  return unit.empty() ? what : what + " [" + unit + "]";
}

std::string check_range(double value, const Rule& rule) {
  constexpr double kSmallest = 1e-100, kLargest = 1e100;  // the product of two such numbers is still finite
  std::string expected;
  if (!std::isfinite(value)) {
    expected = "a finite number";
  } else if (value != 0.0 && !(std::abs(value) >= kSmallest && std::abs(value) <= kLargest)) {
    expected = "0 or a magnitude from " + number_text(kSmallest) + " to " + number_text(kLargest);
  } else if (rule.range == Range::kPositive && !(value > 0.0)) {
    expected = "more than 0";
  } else if (rule.range == Range::kNotNegative && !(value >= 0.0)) {
    expected = "0 or more";
  } else if (rule.range == Range::kUnitInterval && !(value >= 0.0 && value <= 1.0)) {
    expected = "a number from 0 to 1";
  }
  if (expected.empty()) return "";
  const std::string unit = unit_name(rule.unit);
  return with_code(kOutOfRange,
                   "is " + number_text(value) + (unit.empty() ? "" : " " + unit) + ", expected " + expected);
}

std::string read_numbers(const ConfigNode& node, const ValueContext& c, std::size_t count, std::vector<double>& values,
                         std::string expected) {
  if (expected.empty())
    expected = with_unit(count ? "a list of " + std::to_string(count) + " numbers" : "a list of numbers", c.rule);
  if (node.kind != ConfigNode::Kind::kList || (count && node.list.size() != count)) return is_expected(node, expected);
  std::vector<double> result;
  for (const ConfigNode& item : node.list) {
    if (!item.is_number()) return with_code(kWrongType, "contains " + item.description() + ", expected " + expected);
    result.push_back(item.number * c.factor);
    const std::string problem = check_range(result.back(), c.rule);
    if (!problem.empty()) return "number " + std::to_string(result.size()) + " " + problem;
  }
  values = std::move(result);
  return "";
}

}  // namespace footfall
