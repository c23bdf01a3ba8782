#pragma once
// A check of command-line values, with a message that people can read.

#include <CLI/CLI.hpp>
#include <string>

namespace footfall {

// A number above zero.
inline CLI::Validator positive() {
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0.0;
        return CLI::detail::lexical_cast(text, value) && value > 0.0 && value <= 1e300
                   ? std::string()
                   : "is \"" + text + "\", expected a number above zero";
      },
      "NUMBER > 0");
}

}  // namespace footfall
