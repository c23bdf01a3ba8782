#pragma once
// The command line of footfall: its commands, and the way from the words that a user typed to an exit code.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace footfall {

using Action = std::function<int()>;  // returns an exit code; throws the errors of coupler/base/errors.h

// Adds the options of a command; returns what it does once they are read.
using Prepare = Action (*)(CLI::App& command);

// Carried out by a program of its own, such as "footfall_studies": a first run does not wait for the compilation of others.
struct Subcommand {
  const char* name;
  const char* what;  // for --help
  std::string program;
  Prepare prepare;  // null: not in this program
};

// All commands of commands.def, with the functions of those that a program carries out itself. docs/reference/commands.md has a
// section for each.
std::vector<Subcommand> commands_with(const std::vector<std::pair<std::string, Prepare>>& own);

// The commands of the program footfall.
const std::vector<Subcommand>& subcommands();

// Reads the line and carries it out. Errors are printed on standard error.
int run_command_line(int argc, char** argv, const std::vector<Subcommand>& commands);

}  // namespace footfall
