#pragma once
// The command line of footfall: its commands, and the way from the words that a user typed to an exit code.

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace footfall {

using Action = std::function<int()>;  // returns an exit code; throws the errors of coupler/base/errors.h

struct Subcommand {
  const char* name;
  const char* what;                      // for --help
  Action (*prepare)(CLI::App& command);  // adds its options; returns what it does once they are read; null: not here
};

// All commands, in the order of --help. Those without `prepare` are in other programs (footfall_studies, footfall_campaign),
// so that a first run does not wait for its compilation. docs/reference/commands.md has a section for each.
const std::vector<Subcommand>& subcommands();

// Reads the line and carries it out. Errors are printed on standard error.
int run_command_line(int argc, char** argv, const std::vector<Subcommand>& commands);

}  // namespace footfall
