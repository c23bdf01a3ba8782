#pragma once
// Not listed: `footfall help [COMMAND]`, and --man, --bash, --zsh, --write, which the installation uses.

#include <CLI/CLI.hpp>

#include "mbd_solver/cli/user_commands.h"

namespace footfall {

Action print_help(CLI::App& app, CLI::App& command);

}  // namespace footfall
