#include "mbd_solver/scene/value_checks.h"

#include <cmath>

#include "coupler/base/text.h"

namespace footfall {

std::string is_expected(const ConfigNode& node, const std::string& expected) {
  return "is " + node.description() + ", expected " + expected;
}

std::string with_unit(const std::string& what, const Rule& rule) {
  const std::string unit = unit_name(rule.unit);
  return unit.empty() ? what : what + " [" + unit + "]";
}

// Beyond these a product of two numbers may be lost.
static constexpr double kSmallest = 1e-100, kLargest = 1e100;

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

}  // namespace footfall
