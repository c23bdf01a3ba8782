#pragma once
// The subcommands of footfall.

#include <CLI/CLI.hpp>
#include <vector>

#include "mbd_solver/cli/user_commands.h"

namespace footfall {

struct Subcommand {
  const char* name;
  const char* what;                      // as --help shows it
  Action (*prepare)(CLI::App& command);  // adds its options; returns what it does once they are read
};

// Those of footfall itself, in the order of --help; docs/commands.md has a line for each. Others: studies.h.
const std::vector<Subcommand>& subcommands();

}  // namespace footfall
