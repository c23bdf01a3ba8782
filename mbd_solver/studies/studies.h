#pragma once
// The subcommands that start many runs, and the schema of their files. They stand in a program of their own, footfall_studies,
// so that a first run does not wait for their compilation.

#include <CLI/CLI.hpp>
#include <vector>

#include "mbd_solver/app/command_line.h"

namespace footfall {

const std::vector<Subcommand>& studies();

// Not listed: `footfall help [COMMAND]`, and --man, --bash, --zsh, --write, which the installation uses.

Action print_help(CLI::App& app, CLI::App& command);

}  // namespace footfall
