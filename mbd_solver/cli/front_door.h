#pragma once
// A command line of footfall, from its words to an exit code.

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "mbd_solver/cli/subcommands.h"

namespace footfall {

// commands: those that --help lists. help: one more, which it does not list; none without. What goes wrong is told on stderr.
int front_door(int argc, char** argv, const std::vector<Subcommand>& commands,
               const std::function<Action(CLI::App& app, CLI::App& command)>& help = {});

}  // namespace footfall
