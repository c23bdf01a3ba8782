#pragma once
// A command line that cannot be read, told in our words: where, what is, what was expected, what to do.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace footfall {

// line: the words behind the program's name.
std::string option_error(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& line);

}  // namespace footfall
