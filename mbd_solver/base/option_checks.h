#pragma once
// Checks of the values of command-line options.

#include <CLI/CLI.hpp>
#include <string>

#include "coupler/base/text.h"

namespace footfall {

// good(value): whether a number is valid; expected: "a number above zero".
template <class Good>
CLI::Validator number_that(const Good& good, const std::string& expected, const std::string& name) {
  return CLI::Validator(
      [good, expected](const std::string& text) {
        double value = 0.0;
        return CLI::detail::lexical_cast(text, value) && value <= 1e300 && good(value)
                   ? std::string()
                   : "is \"" + text + "\", expected " + expected;
      },
      name);
}

inline CLI::Validator positive() {
  return number_that([](double value) { return value > 0.0; }, "a number above zero", "NUMBER > 0");
}
inline CLI::Validator not_negative() {
  return number_that([](double value) { return value >= 0.0; }, "zero or a number above zero", "NUMBER >= 0");
}
inline CLI::Validator within(double least, double most) {
  const std::string from = number_text(least, 10), to = number_text(most, 10);
  return number_that([least, most](double value) { return value >= least && value <= most; },
                     "a number from " + from + " to " + to, "NUMBER in [" + from + " - " + to + "]");
}

}  // namespace footfall
